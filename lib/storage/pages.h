// Pages of plain data that never move. A large world has many, and looks at them in no order. Then a good part of the
// time goes into finding where memory is, and with large pages the processor has less to look up. So pages beyond the
// first few are parts of slabs, for which Linux is asked for large pages. Where there are none nothing is lost.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>
#include <type_traits>
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
  Pages(const Pages& other) {
    while (pages_.size() < other.pages_.size()) {
      add();
      std::memcpy(pages_.back(), other.pages_[pages_.size() - 1], sizeof(Page));
    }
  }
  Pages& operator=(const Pages&) = delete;
  Pages(Pages&&) noexcept = default;
  Pages& operator=(Pages&&) noexcept = default;
  ~Pages() = default;

  Page& operator[](std::size_t k) const { return *pages_[k]; }
  std::size_t size() const { return pages_.size(); }
  /// One more. What it holds is not determined.
  void add() {
    if (spare_ == 0) {
      slabs_.push_back(Slab::forPages(sizeof(Page), pages_.size()));
      spare_ = slabs_.back().pages();
    }
    const std::size_t at = slabs_.back().pages() - spare_--;
    pages_.push_back(new (slabs_.back().memory() + at * sizeof(Page)) Page);
  }
  /// For tests of limits: so many more that nobody may look at.
  void passOver(std::size_t pages) { pages_.resize(pages_.size() + pages, nullptr); }
  std::uint64_t bytes() const {
    std::uint64_t sum = pages_.capacity() * sizeof pages_[0] + slabs_.capacity() * sizeof slabs_[0];
    for (const Slab& slab : slabs_) sum += slab.bytes();
    return sum;
  }

 private:
  std::vector<Page*> pages_;
  std::vector<Slab> slabs_;
  std::size_t spare_ = 0;  ///< pages of the last slab that are not given out yet
};

}  // namespace lgs::detail
