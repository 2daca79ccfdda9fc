// Memory, and what happens when there is none left: the call ends in a trap, which JavaScript sees as an exception.
// libc++ would print a message first, and bring all of printf() along for it.
#include "bridge.h"

#include <__verbose_abort>
#include <cstdlib>
#include <new>

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

/// Runs a destructor when its thread ends. There is one thread here, and it never ends.
extern "C" int __cxa_thread_atexit(void (*)(void*), void*, void*) { return 0; }  // NOLINT: the name is the compiler's

// Of sines and cosines only directions are made. JavaScript has them; those of the C library weigh six kilobytes.
extern "C" {
__attribute__((import_module("lgs"), import_name("cos"))) double cosInJavaScript(double angle);
__attribute__((import_module("lgs"), import_name("sin"))) double sinInJavaScript(double angle);
double cos(double angle) { return cosInJavaScript(angle); }
double sin(double angle) { return sinInJavaScript(angle); }
}
