// Memory, and what happens when there is none left: the call ends in a trap, which JavaScript sees as an exception.
// libc++ would print a message first, and bring all of printf() along for it.
#include "bridge.h"

#include <__verbose_abort>
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <utility>

/// Where malloc() takes memory from; it asks for whole pages, and gives none back. The C library's own grows by just
/// that, and each time costs a millisecond in Node. So this one grows by an eighth at least. What nobody writes to costs
/// the system nothing.
extern "C" void* sbrk(std::intptr_t more) {  // NOLINT: the name is the C library's
  constexpr std::size_t kPage = std::size_t{1} << 16;
  static std::size_t given = 0, end = 0;  // pages between them are ours, and not given out
  const std::size_t there = __builtin_wasm_memory_size(0), wanted = static_cast<std::size_t>(more) / kPage;
  if (there != end) given = end = there;  // at first, and where JavaScript made memory grow: that is not ours
  if (wanted > end - given) {
    const std::size_t needed = wanted - (end - given);
    const auto grow = [](std::size_t pages) { return __builtin_wasm_memory_grow(0, pages) != SIZE_MAX; };
    if (more < 0 || (!grow(std::max(needed, end / 8)) && !grow(needed))) return reinterpret_cast<void*>(SIZE_MAX);
    end = __builtin_wasm_memory_size(0);
  }
  return reinterpret_cast<void*>(kPage * std::exchange(given, given + wanted));
}

// Here memory is taken and given back by hand, for all code above.
// NOLINTBEGIN(cppcoreguidelines-no-malloc)
namespace {
bool isMemoryOut = false;
}

LGS_EXPORT("isMemoryOut") std::int32_t isMemoryOutNow() { return isMemoryOut; }

void* operator new(std::size_t bytes) {
  if (void* const memory = std::malloc(bytes)) return memory;
  isMemoryOut = true;
  __builtin_trap();
}
void* operator new[](std::size_t bytes) { return operator new(bytes); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
// NOLINTEND(cppcoreguidelines-no-malloc)

_LIBCPP_BEGIN_NAMESPACE_STD
void __libcpp_verbose_abort(const char*, ...) { __builtin_trap(); }
_LIBCPP_END_NAMESPACE_STD

// Of sines and cosines only directions are made. JavaScript has them; those of the C library weigh six kilobytes.
extern "C" {
__attribute__((import_module("lgs"), import_name("cos"))) double cosInJavaScript(double angle);
__attribute__((import_module("lgs"), import_name("sin"))) double sinInJavaScript(double angle);
double cos(double angle) { return cosInJavaScript(angle); }
double sin(double angle) { return sinInJavaScript(angle); }
}
