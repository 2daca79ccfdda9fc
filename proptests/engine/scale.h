// How much the tests of the engine do. LGS_TEST_SCALE multiplies the number of random cases (default 1; 0.05 under
// sanitizers, 100 for a long run). Below 1 it also thins out the exhaustive tests, which then say so by their counts.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace lgs::engine_test {

inline double testScale() {
  static const double scale = [] {
    const char* text = std::getenv("LGS_TEST_SCALE");
    const double value = text ? std::atof(text) : 1.0;
    return value > 0 ? value : 1.0;
  }();
  return scale;
}

/// `count` random cases at scale 1, at least one.
inline std::int64_t scaled(std::int64_t count) {
  return std::max<std::int64_t>(1, std::llround(static_cast<double>(count) * testScale()));
}

/// Of exhaustive tests: every how many-th case is looked at.
inline std::int64_t exhaustStride() {
  return testScale() >= 1 ? 1 : static_cast<std::int64_t>(std::ceil(1 / testScale()));
}

/// How many of `total` cases a stride of exhaustStride() looks at.
inline std::int64_t exhausted(std::int64_t total) { return (total + exhaustStride() - 1) / exhaustStride(); }

}  // namespace lgs::engine_test
