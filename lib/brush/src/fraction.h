// Fractions rounded to integers, exactly: no product is too large.
#pragma once

#include "geometry/wide.h"

#include <cstdint>

namespace lgs::brush {

struct Rounded {
  std::uint64_t nearest = 0;  ///< a half goes up
  bool isHalf = false;
};

/// numerator / divisor. The quotient must be below 2^62, and so must the divisor.
constexpr Rounded rounded(detail::Wide numerator, std::uint64_t divisor) {
  std::uint64_t quotient = 0, rest = numerator.high;
  if (rest == 0) {  // nearly always
    quotient = numerator.low / divisor;
    rest = numerator.low % divisor;
  } else {
    for (int bit = 63; bit >= 0; --bit) {
      rest = rest << 1 | (numerator.low >> bit & 1);
      quotient <<= 1;
      if (rest < divisor) continue;
      rest -= divisor;
      quotient |= 1;
    }
  }
  return {quotient + (2 * rest >= divisor ? 1 : 0), 2 * rest == divisor};
}

/// ⌊a · b / divisor + 1/2⌋. The divisor is not 0.
constexpr std::int64_t roundedProduct(std::int64_t a, std::int64_t b, std::int64_t divisor) {
  const auto magnitude = [](std::int64_t v) { return static_cast<std::uint64_t>(v < 0 ? -v : v); };
  const bool isNegative = ((a < 0) != (b < 0)) != (divisor < 0);
  const Rounded r = rounded(detail::multiply(magnitude(a), magnitude(b)), magnitude(divisor));
  const auto nearest = static_cast<std::int64_t>(r.nearest);
  return isNegative ? -(nearest - (r.isHalf ? 1 : 0)) : nearest;
}

}  // namespace lgs::brush
