// Memory for small records of any size, in words of 32 bits. A reference of 32 bits names a record until it is
// released; 0 names none. Pages never move, so nothing is copied when the arena grows. Released records are reused by
// size, the last one first.
#pragma once

#include "storage/pages.h"

#include <array>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace lgs::detail {

class RecordArena {
 public:
  using Ref = std::uint32_t;
  static constexpr std::uint32_t kPageWords = 1u << 16;  ///< no record is larger, and none crosses a page
  static constexpr std::size_t kMaxPages = (std::size_t{1} << 31) / kPageWords;

  /// What the record holds is not determined.
  Ref allocate(std::uint32_t words) {
    assert(words != 0 && words <= kPageWords);
    const std::uint32_t size = roundUp(words);
    Ref& head = free_[sizeClass(size)];
    if (head != kNone) {
      const Ref ref = head;
      head = *at(ref);
      return ref;
    }
    if (used_ + size > kPageWords) addPage();
    const Ref ref = static_cast<Ref>((pages_.size() - 1) * kPageWords + used_);
    used_ += size;
    return ref;
  }

  void release(Ref ref, std::uint32_t words) {
    assert(ref != kNone);
    Ref& head = free_[sizeClass(roundUp(words))];
    *at(ref) = head;
    head = ref;
  }

  /// Whether a record of one size has room for one of the other.
  static bool sameSize(std::uint32_t a, std::uint32_t b) { return roundUp(a) == roundUp(b); }

  std::uint32_t* at(Ref ref) const { return pages_[ref / kPageWords].data() + ref % kPageWords; }

  /// For tests of the limit: so many pages count as full, and are not there.
  void passOver(std::size_t pages) { pages_.addMissing(pages); }

  std::uint64_t bytes() const { return pages_.bytes(); }

 private:
  /// Apart, so that allocate() is small and inlined.
  [[gnu::noinline]] void addPage() {
    if (pages_.size() == kMaxPages) std::abort();  // with 8 GiB of records, as if memory had run out
    pages_.add();
    used_ = pages_.size() == 1 ? 1 : 0;  // reference 0 names no record
  }

  static constexpr Ref kNone = 0;
  using Page = std::array<std::uint32_t, kPageWords>;
  static constexpr std::uint32_t kExact = 32;  // every size has a class up to here, then powers of two
  static constexpr std::size_t kClasses = kExact + 12;

  static constexpr std::uint32_t roundUp(std::uint32_t words) { return words <= kExact ? words : std::bit_ceil(words); }
  static constexpr std::size_t sizeClass(std::uint32_t size) {
    return size <= kExact ? size : kExact + static_cast<std::size_t>(std::bit_width(size)) - 6;
  }

  Pages<Page> pages_;
  std::uint32_t used_ = kPageWords;  // of the last page
  std::array<Ref, kClasses> free_{};
};

}  // namespace lgs::detail
