// Pages that never move, by number. One that is not needed can be given back, and made again. A large world has many, and
// looks at them in no order. Then a good part of the time goes into finding where memory is, and with large pages of the
// processor it has less to look up. So once there are many they are parts of slabs, for which Linux is asked for such
// pages. Where there are none nothing is lost.
#pragma once

#include "storage/vectors.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace lgs::detail {

/// Memory for pages of one size.
class PageMemory {
 public:
  /// For one more page, when so many are in use.
  std::byte* take(std::size_t pageBytes, std::size_t inUse);
  /// Of a page that is not needed any more. A slab of which no page is left is given back.
  void giveBack(std::byte* page);
  std::uint64_t bytes() const;

 private:
  struct Free {
    bool isLarge = false;
    void operator()(std::byte* memory) const;
  };
  /// Memory for one or more pages.
  struct Slab {
    std::unique_ptr<std::byte, Free> memory;
    std::size_t bytes = 0;
    std::size_t used = 0;  ///< pages of it that are given out
    bool contains(const std::byte* page) const;
  };
  static Slab slabFor(std::size_t pageBytes, std::size_t inUse);
  std::vector<Slab>::iterator slabOf(const std::byte* page);

  std::vector<Slab> slabs_;
  std::vector<std::byte*> spare_;  ///< pages of slabs that are not given out
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
    if constexpr (!std::is_trivially_destructible_v<Page>)
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
  /// It is missing from now on.
  void drop(std::size_t k) {
    assert(has(k));
    Page* const page = std::exchange(pages_[k], nullptr);
    page->~Page();
    ++missing_;
    memory_.giveBack(reinterpret_cast<std::byte*>(page));
  }
  /// There are so many from now on. The others are missing.
  void shorten(std::size_t size) {
    assert(std::all_of(pages_.begin() + static_cast<std::ptrdiff_t>(size), pages_.end(), [](auto* p) { return !p; }));
    missing_ -= pages_.size() - size;
    pages_.resize(size);
    giveBackSpare(pages_);
  }
  std::uint64_t bytes() const { return pages_.capacity() * sizeof pages_[0] + memory_.bytes(); }

 private:
  void swap(Pages& other) noexcept {
    pages_.swap(other.pages_);
    std::swap(missing_, other.missing_);
    std::swap(memory_, other.memory_);
  }
  /// Memory for a page that is missing.
  std::byte* place() {
    std::byte* const page = memory_.take(sizeof(Page), pages_.size() - missing_);
    --missing_;
    return page;
  }

  std::vector<Page*> pages_;  ///< null where one is missing
  std::size_t missing_ = 0;
  PageMemory memory_;
};

}  // namespace lgs::detail
