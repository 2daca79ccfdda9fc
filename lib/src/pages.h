// Pages of plain data that never move. A large world has many, and looks at them in no order: then a good part of the
// time goes into finding where the memory is. With pages of 2 MiB the processor has to look up little. So pages beyond
// the first few are parts of slabs, and on Linux the system is asked for large pages for these. Where it has none, or is
// another one, nothing is lost.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>
#include <type_traits>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace lgs::detail {

template <class Page>
class Pages {
  static_assert(std::is_trivially_copyable_v<Page> && std::is_trivially_destructible_v<Page>);

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
  ~Pages() = default;

  Page& operator[](std::size_t k) const { return *pages_[k]; }
  std::size_t size() const { return pages_.size(); }
  /// One more. What it holds is not determined.
  void add() {
    if (spare_ == 0) addSlab();
    const std::size_t at = slabs_.back().pages - spare_--;
    pages_.push_back(new (slabs_.back().memory.get() + at * sizeof(Page)) Page);
  }
  std::uint64_t bytes() const {
    std::uint64_t sum = pages_.capacity() * sizeof pages_[0] + slabs_.capacity() * sizeof slabs_[0];
    for (const Slab& slab : slabs_) sum += slab.bytes();
    return sum;
  }

 private:
  static constexpr std::size_t kLarge = std::size_t{2} << 20;
  static constexpr std::size_t kInLarge = kLarge / sizeof(Page);
  static constexpr std::size_t kSmallWorld = 8;  ///< pages that are allocated one by one

  struct Free {
    void operator()(std::byte* memory) const { ::operator delete (memory, std::align_val_t{alignment}); }
    std::size_t alignment = alignof(Page);
  };
  struct Slab {
    std::unique_ptr<std::byte, Free> memory;
    std::size_t pages = 1;
    std::size_t bytes() const { return pages == 1 ? sizeof(Page) : kLarge; }
  };

  static Slab slab(std::size_t bytes, std::size_t alignment, std::size_t pages) {
    auto* memory = static_cast<std::byte*>(::operator new (bytes, std::align_val_t{alignment}));
    return {{memory, Free{alignment}}, pages};
  }
  void addSlab() {
#ifdef __linux__
    if (pages_.size() >= kSmallWorld && kInLarge > 1) {
      slabs_.push_back(slab(kLarge, kLarge, kInLarge));
      // Only a wish: if it is refused, the pages are small.
      static_cast<void>(madvise(slabs_.back().memory.get(), kLarge, MADV_HUGEPAGE));
      spare_ = kInLarge;
      return;
    }
#endif
    slabs_.push_back(slab(sizeof(Page), alignof(Page), 1));
    spare_ = 1;
  }

  std::vector<Page*> pages_;
  std::vector<Slab> slabs_;
  std::size_t spare_ = 0;  ///< pages of the last slab that are not given out yet
};

}  // namespace lgs::detail
