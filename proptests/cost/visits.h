// Counts how much the library does, and not how long it takes. For these tests it is compiled so that it counts the
// basic blocks that it runs through (-fsanitize-coverage=trace-pc). A loop counts each time it goes round. Calls into
// other libraries do not count.
#pragma once

#include <cstdint>

namespace lgs::cost_test {

/// Basic blocks since the program began.
std::uint64_t visits();

template <class Work>
std::uint64_t visitsOf(Work&& work) {
  const std::uint64_t before = visits();
  work();
  return visits() - before;
}

}  // namespace lgs::cost_test
