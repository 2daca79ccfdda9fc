#include "storage/hash_index.h"

#ifndef __wasm__
#include <chrono>
#endif

namespace lgs::detail {

std::uint64_t anySeed(const void* where) {
#ifdef __wasm__
  static_cast<void>(where);
  return 0x9e37'79b9'7f4a'7c15;
#else
  const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
  return mix(mix(0, static_cast<std::uint64_t>(now)), reinterpret_cast<std::uintptr_t>(where));
#endif
}

}  // namespace lgs::detail
