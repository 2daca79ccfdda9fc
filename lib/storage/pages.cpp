#include "storage/pages.h"

#include <functional>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace lgs::detail {
namespace {

[[maybe_unused]] constexpr std::size_t kLarge = std::size_t{2} << 20;  // what x86-64 and ARM have beside pages of 4 KiB

}  // namespace

bool PageMemory::Slab::contains(const std::byte* page) const {
  return std::greater_equal()(page, memory.get()) && std::less()(page, memory.get() + bytes);
}

PageMemory::Slab PageMemory::slabFor(std::size_t pageBytes, std::size_t inUse) {
#ifdef __linux__
  if (inUse * pageBytes >= kLarge / 2) {  // until then they are allocated one by one: small worlds stay small
    Slab slab{{static_cast<std::byte*>(::operator new (kLarge, std::align_val_t{kLarge})), Free{true}}, kLarge};
    static_cast<void>(madvise(slab.memory.get(), kLarge, MADV_HUGEPAGE));  // a wish: it may be refused
    return slab;
  }
#endif
  static_cast<void>(inUse);
  return {{static_cast<std::byte*>(::operator new(pageBytes)), Free{}}, pageBytes};
}

/// From the newest one on, where most pages are given out.
std::vector<PageMemory::Slab>::iterator PageMemory::slabOf(const std::byte* page) {
  auto slab = slabs_.end() - 1;
  for (; !slab->contains(page); --slab) assert(slab != slabs_.begin());
  return slab;
}

std::byte* PageMemory::take(std::size_t pageBytes, std::size_t inUse) {
  if (spare_.empty()) {
    const Slab& slab = slabs_.emplace_back(slabFor(pageBytes, inUse));
    for (std::size_t n = slab.bytes / pageBytes; n > 0; --n) spare_.push_back(slab.memory.get() + (n - 1) * pageBytes);
  }
  std::byte* const page = spare_.back();
  spare_.pop_back();
  ++slabOf(page)->used;
  return page;
}

void PageMemory::giveBack(std::byte* page) {
  spare_.push_back(page);
  const auto slab = slabOf(page);
  if (--slab->used != 0) return;
  std::erase_if(spare_, [&](const std::byte* one) { return slab->contains(one); });
  slabs_.erase(slab);
}

std::uint64_t PageMemory::bytes() const {
  std::uint64_t sum = slabs_.capacity() * sizeof slabs_[0] + spare_.capacity() * sizeof spare_[0];
  for (const Slab& slab : slabs_) sum += slab.bytes;
  return sum;
}

void PageMemory::Free::operator()(std::byte* memory) const {
#ifdef __linux__
  if (isLarge) {
    ::operator delete (memory, std::align_val_t{kLarge});
    return;
  }
#endif
  ::operator delete(memory);
}

}  // namespace lgs::detail
