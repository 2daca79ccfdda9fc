#include "storage/pages.h"

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace lgs::detail {
namespace {

[[maybe_unused]] constexpr std::size_t kLarge = std::size_t{2} << 20;  // what x86-64 and ARM have beside pages of 4 KiB

}  // namespace

Slab Slab::forPages(std::size_t pageBytes, std::size_t before) {
  Slab slab;
#ifdef __linux__
  if (before * pageBytes >= kLarge / 2) {  // until then they are allocated one by one: small worlds stay small
    slab.pages_ = kLarge / pageBytes;
    slab.bytes_ = kLarge;
    slab.memory_ = {static_cast<std::byte*>(::operator new (kLarge, std::align_val_t{kLarge})), FreeSlab{true}};
    static_cast<void>(madvise(slab.memory(), kLarge, MADV_HUGEPAGE));  // a wish: it may be refused
    return slab;
  }
#endif
  static_cast<void>(before);
  slab.pages_ = 1;
  slab.bytes_ = pageBytes;
  slab.memory_ = {static_cast<std::byte*>(::operator new(pageBytes)), FreeSlab{false}};
  return slab;
}

void FreeSlab::operator()(std::byte* memory) const {
#ifdef __linux__
  if (isLarge) {
    ::operator delete (memory, std::align_val_t{kLarge});
    return;
  }
#endif
  ::operator delete(memory);
}

}  // namespace lgs::detail
