// Pages that never move, by number. One that is not needed can be given back, and made again. A large world has many, and
// looks at them in no order. Then a good part of the time goes into finding where memory is, and with large pages of the
// processor it has less to look up. So once there are many they are parts of slabs, for which Linux is asked for such
// pages. Where there are none nothing is lost.
#pragma once

#include "storage/owned.h"

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

  std::size_t used = 0;  ///< pages of it that are given out

 private:
  std::unique_ptr<std::byte, FreeSlab> memory_;
  std::size_t pages_ = 0;
  std::size_t bytes_ = 0;
};

template <class Page>
class Pages {
  static_assert(alignof(Page) <= alignof(std::max_align_t));

 public:
  Pages() = default;
  /// Plain data may be a page that is written in part only. Its bytes can be copied all the same.
  Pages(const Pages& other) : pages_(other.pages_.size()), missing_(pages_.size()) {
    for (std::size_t k = 0; k < pages_.size(); ++k) {
      if (!other.pages_[k]) continue;
      if constexpr (std::is_trivially_copyable_v<Page>) {
        std::memcpy(&make(k), other.pages_[k], sizeof(Page));
      } else {
        pages_[k] = new (place()) Page(*other.pages_[k]);
      }
    }
  }
  Pages& operator=(const Pages&) = delete;
  Pages(Pages&& other) noexcept { swap(other); }
  Pages& operator=(Pages&& other) noexcept {
    swap(other);
    return *this;
  }
  ~Pages() {
    for (Page* page : pages_)
      if (page) page->~Page();
  }

  Page& operator[](std::size_t k) const {
    assert(k < pages_.size() && has(k));
    return *pages_[k];
  }
  /// Null where it is missing.
  Page* get(std::size_t k) const { return pages_[k]; }
  std::size_t size() const { return pages_.size(); }
  bool has(std::size_t k) const { return pages_[k] != nullptr; }
  std::size_t missing() const { return missing_; }
  /// So many more, which are missing.
  void addMissing(std::size_t pages = 1) {
    pages_.resize(pages_.size() + pages, nullptr);
    missing_ += pages;
  }
  /// One that is missing. What it holds is not determined, if it is plain data.
  Page& make(std::size_t k) {
    assert(!has(k));
    return *(pages_[k] = new (place()) Page);
  }
  /// One more.
  Page& add() {
    addMissing();
    return make(pages_.size() - 1);
  }
  /// It is missing from now on. A slab of which no page is left is given back.
  void drop(std::size_t k) {
    assert(has(k));
    pages_[k]->~Page();
    auto* const memory = reinterpret_cast<std::byte*>(std::exchange(pages_[k], nullptr));
    ++missing_;
    spare_.push_back(memory);
    const auto slab = slabOf(memory);
    if (--slab->used != 0) return;
    std::erase_if(spare_, [&](const std::byte* page) { return slab->contains(page); });
    slabs_.erase(slab);
  }
  /// There are so many from now on. The others are missing.
  void shorten(std::size_t size) {
    assert(std::all_of(pages_.begin() + static_cast<std::ptrdiff_t>(size), pages_.end(), [](auto* p) { return !p; }));
    missing_ -= pages_.size() - size;
    pages_.resize(size);
    giveBackSpare(pages_);
  }
  std::uint64_t bytes() const {
    std::uint64_t sum = pages_.capacity() * sizeof pages_[0] + slabs_.capacity() * sizeof slabs_[0] +
                        spare_.capacity() * sizeof spare_[0];
    for (const Slab& slab : slabs_) sum += slab.bytes();
    return sum;
  }

 private:
  void swap(Pages& other) noexcept {
    pages_.swap(other.pages_);
    std::swap(missing_, other.missing_);
    slabs_.swap(other.slabs_);
    spare_.swap(other.spare_);
  }
  /// From the newest one on, where most pages are given out.
  std::vector<Slab>::iterator slabOf(const std::byte* page) {
    auto slab = slabs_.end() - 1;
    for (; !slab->contains(page); --slab) assert(slab != slabs_.begin());
    return slab;
  }
  /// Memory for a page that is missing.
  std::byte* place() {
    if (spare_.empty()) {
      const Slab& slab = slabs_.emplace_back(Slab::forPages(sizeof(Page), pages_.size() - missing_));
      for (std::size_t n = slab.pages(); n-- != 0;) spare_.push_back(slab.memory() + n * sizeof(Page));
    }
    std::byte* const page = spare_.back();
    spare_.pop_back();
    ++slabOf(page)->used;
    --missing_;
    return page;
  }

  std::vector<Page*> pages_;  ///< null where one is missing
  std::size_t missing_ = 0;
  std::vector<Slab> slabs_;
  std::vector<std::byte*> spare_;  ///< pages of slabs that are not given out
};

}  // namespace lgs::detail
