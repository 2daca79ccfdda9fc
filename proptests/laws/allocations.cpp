#include "allocations.h"

#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

// For each thread: counters that threads share would cost the tests of this program a tenth of their time.
thread_local std::uint64_t newCalls;
thread_local std::int64_t liveBytes;
thread_local std::uint64_t mostCalls = UINT64_MAX;

// In front of each block: its size, and as much room as keeps the block aligned.
constexpr std::size_t kHeader = alignof(std::max_align_t);

void* allocate(std::size_t size, std::size_t alignment = kHeader) noexcept {
  if (newCalls >= mostCalls) return nullptr;
  const std::size_t whole = (alignment + size + alignment - 1) / alignment * alignment;
  void* const memory = alignment == kHeader ? std::malloc(whole) : std::aligned_alloc(alignment, whole);  // NOLINT
  auto* block = static_cast<std::byte*>(memory);
  if (!block) return nullptr;
  ::new (block) std::size_t(size);
  ++newCalls;
  liveBytes += static_cast<std::int64_t>(size);
  return block + alignment;
}

void release(void* p, std::size_t alignment = kHeader) noexcept {
  if (!p) return;
  std::byte* block = static_cast<std::byte*>(p) - alignment;
  liveBytes -= static_cast<std::int64_t>(*reinterpret_cast<std::size_t*>(block));
  std::free(block);  // NOLINT(cppcoreguidelines-no-malloc): for `delete`
}

void* allocateOrThrow(std::size_t size, std::size_t alignment = kHeader) {
  if (void* p = allocate(size, alignment)) return p;
  throw std::bad_alloc();
}

}  // namespace

// Of the aligned ones those that the engine uses.
void* operator new(std::size_t size) { return allocateOrThrow(size); }
void* operator new[](std::size_t size) { return allocateOrThrow(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return allocate(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return allocate(size); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocateOrThrow(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* p, std::align_val_t alignment) noexcept { release(p, static_cast<std::size_t>(alignment)); }
void operator delete(void* p, std::size_t, std::align_val_t alignment) noexcept {
  release(p, static_cast<std::size_t>(alignment));
}
void operator delete(void* p) noexcept { release(p); }
void operator delete[](void* p) noexcept { release(p); }
void operator delete(void* p, std::size_t) noexcept { release(p); }
void operator delete[](void* p, std::size_t) noexcept { release(p); }
void operator delete(void* p, const std::nothrow_t&) noexcept { release(p); }
void operator delete[](void* p, const std::nothrow_t&) noexcept { release(p); }

namespace lgs::test {

Allocations allocations() { return {newCalls, liveBytes}; }

void memoryRunsOutAfter(std::uint64_t allocations) { mostCalls = newCalls + allocations; }

}  // namespace lgs::test
