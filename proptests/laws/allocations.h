// Counts what the calling thread allocates: the global operator new is replaced (allocations.cpp).
#pragma once

#include <cstdint>

namespace lgs::test {

struct Allocations {
  std::uint64_t count = 0;  ///< calls of operator new so far
  std::int64_t bytes = 0;   ///< asked for and not yet given back
};
Allocations allocations();

}  // namespace lgs::test
