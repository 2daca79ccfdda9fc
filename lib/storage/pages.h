// Pages of plain data that never move. Those that are not needed can be given back, and made again. A large world has
// many, and looks at them in no order. Then a good part of the time goes into finding where memory is, and with large
// pages the processor has less to look up. So pages beyond the first few are parts of slabs, for which Linux is asked
// for large pages. Where there are none nothing is lost.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace lgs::detail {

struct FreeSlab {
  bool isLarge = false;
  void operator()(std::byte* memory) const;
};

/// Memory for one or more pages.
class Slab {
 public:
  /// `before` says how many pages there are already.
  static Slab forPages(std::size_t pageBytes, std::size_t before);

  std::byte* memory() const { return memory_.get(); }
  std::size_t pages() const { return pages_; }
  std::uint64_t bytes() const { return bytes_; }
  bool contains(const std::byte* p) const {
    return std::greater_equal()(p, memory()) && std::less()(p, memory() + bytes_);
  }

 private:
  std::unique_ptr<std::byte, FreeSlab> memory_;
  std::size_t pages_ = 0;
  std::size_t bytes_ = 0;
};

template <class Page>
class Pages {
  static_assert(std::is_trivially_copyable_v<Page> && alignof(Page) <= alignof(std::max_align_t));

 public:
  Pages() = default;
  /// A page may be written in part only. Its bytes can be copied all the same.
  Pages(const Pages& other) : pages_(other.pages_.size()), missing_(pages_.size()) {
    for (std::size_t k = 0; k < pages_.size(); ++k)
      if (other.pages_[k]) std::memcpy(&make(k), other.pages_[k], sizeof(Page));
  }
  Pages& operator=(const Pages&) = delete;
  Pages(Pages&&) noexcept = default;
  Pages& operator=(Pages&&) noexcept = default;
  ~Pages() = default;

  Page& operator[](std::size_t k) const {
    assert(k < pages_.size() && has(k));
    return *pages_[k];
  }
  std::size_t size() const { return pages_.size(); }
  /// One more. What it holds is not determined.
  void add() {
    pages_.push_back(nullptr);
    ++missing_;
    make(pages_.size() - 1);
  }
  bool has(std::size_t k) const { return pages_[k] != nullptr; }
  std::size_t missing() const { return missing_; }
  /// One that is missing. What it holds is not determined.
  Page& make(std::size_t k) {
    assert(!has(k));
    if (spare_.empty()) {
      const Slab& slab = slabs_.emplace_back(Slab::forPages(sizeof(Page), pages_.size() - missing_));
      for (std::size_t n = slab.pages(); n-- != 0;) spare_.push_back(slab.memory() + n * sizeof(Page));
    }
    pages_[k] = new (spare_.back()) Page;
    spare_.pop_back();
    --missing_;
    return *pages_[k];
  }
  /// They are missing from now on, and slabs of which no page is left are given back.
  void giveBack(const std::vector<std::size_t>& gone) {
    for (const std::size_t k : gone) spare_.push_back(reinterpret_cast<std::byte*>(std::exchange(pages_[k], nullptr)));
    missing_ += gone.size();
    std::erase_if(slabs_, [&](const Slab& slab) {
      const auto isOfIt = [&](const std::byte* page) { return slab.contains(page); };
      if (static_cast<std::size_t>(std::count_if(spare_.begin(), spare_.end(), isOfIt)) < slab.pages()) return false;
      std::erase_if(spare_, isOfIt);
      return true;
    });
  }
  /// For tests of limits: so many more that must not be looked at.
  void passOver(std::size_t pages) { pages_.resize(pages_.size() + pages, nullptr); }
  std::uint64_t bytes() const {
    std::uint64_t sum = pages_.capacity() * sizeof pages_[0] + slabs_.capacity() * sizeof slabs_[0] +
                        spare_.capacity() * sizeof spare_[0];
    for (const Slab& slab : slabs_) sum += slab.bytes();
    return sum;
  }

 private:
  std::vector<Page*> pages_;  ///< null where one is missing
  std::size_t missing_ = 0;
  std::vector<Slab> slabs_;
  std::vector<std::byte*> spare_;  ///< pages of slabs that are not given out
};

}  // namespace lgs::detail
