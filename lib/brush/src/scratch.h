// Memory for the work on a stroke: blocks that the thread keeps, handed out from front to back.
//
// A List is a vector in such memory. It must not outlive the Frame in which it grew, as all memory of a frame is given
// back at its end. So a cell of a stroke allocates nothing, once a thread has had one as large.
#pragma once

#include <cstddef>
#include <vector>

namespace lgs::brush {

/// What is free in the block that memory is taken from.
struct Scratch {
  std::byte* next;
  std::byte* end;
};
inline constinit thread_local Scratch scratch{nullptr, nullptr};

/// Makes room in another block, and takes bytes from it.
void* takeFromNextBlock(std::size_t bytes);

/// Gives back at its end what was taken since its beginning. Frames may be nested. With the outermost one go the blocks
/// that it needed beyond the thread's first.
class Frame {
 public:
  Frame();
  ~Frame();
  Frame(const Frame&) = delete;
  Frame& operator=(const Frame&) = delete;

 private:
  std::size_t block_ = 0;
  Scratch before_{};
};

template <class T>
struct ScratchAllocator {
  using value_type = T;
  ScratchAllocator() = default;
  template <class U>
  ScratchAllocator(const ScratchAllocator<U>&) {}  // NOLINT(google-explicit-constructor): as the standard wants it

  static std::size_t bytesOf(std::size_t count) {
    constexpr std::size_t kAlignment = alignof(std::max_align_t);
    static_assert(alignof(T) <= kAlignment);
    return (count * sizeof(T) + kAlignment - 1) / kAlignment * kAlignment;
  }
  T* allocate(std::size_t count) {
    const std::size_t bytes = bytesOf(count);
    if (bytes > static_cast<std::size_t>(scratch.end - scratch.next)) return static_cast<T*>(takeFromNextBlock(bytes));
    std::byte* const taken = scratch.next;
    scratch.next += bytes;
    return static_cast<T*>(static_cast<void*>(taken));
  }
  void deallocate(T* taken, std::size_t count) {
    auto* const from = static_cast<std::byte*>(static_cast<void*>(taken));
    if (from + bytesOf(count) == scratch.next) scratch.next = from;  // it was the last to be taken
  }
  friend bool operator==(const ScratchAllocator&, const ScratchAllocator&) { return true; }
};

template <class T>
using List = std::vector<T, ScratchAllocator<T>>;

}  // namespace lgs::brush
