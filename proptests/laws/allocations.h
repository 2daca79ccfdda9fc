// Counts what the calling thread allocates: the global operator new is replaced (allocations.cpp).
#pragma once

#include <cstdint>

namespace lgs::test {

struct Allocations {
  std::uint64_t count = 0;  ///< calls of operator new so far
  std::int64_t bytes = 0;   ///< asked for and not yet given back
};
Allocations allocations();

/// From now on the calling thread gets memory so many times, and then never again.
void memoryRunsOutAfter(std::uint64_t allocations);

}  // namespace lgs::test
