// How much the tests of the engine do. LGS_TEST_SCALE multiplies the number of random cases (default 1; 0.05 under
// sanitizers, 100 for a long run). Below 1 it also thins out the exhaustive tests, which then say so by their counts.
// LGS_TEST_SEED picks other cases. A value that is no number ends the program: a long run of something else would be
// worse.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string_view>
#include <system_error>

namespace lgs::test {

/// What an environment variable says, `otherwise` where it is not set. `range` is least … most in words.
template <class Number>
Number fromEnvironment(const char* variable, Number otherwise, Number least, Number most, const char* range) {
  const char* const value = std::getenv(variable);
  if (value == nullptr) return otherwise;
  const std::string_view text = value;
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc() && end == text.data() + text.size() && number >= least && number <= most) return number;
  std::fprintf(stderr, "%s is '%s'; it may be %s\n", variable, value, range);
  std::exit(2);
}

inline double testScale() {
  static const double scale =
      fromEnvironment("LGS_TEST_SCALE", 1.0, 1e-6, 1e6, "a number from 0.000001 to 1000000, such as 0.05 or 25");
  return scale;
}

inline std::uint64_t testSeed() {
  static const auto seed =
      fromEnvironment<std::uint64_t>("LGS_TEST_SEED", 1, 0, std::numeric_limits<std::uint64_t>::max(),
                                     "a whole number from 0 to 18446744073709551615");
  return seed;
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

}  // namespace lgs::test
