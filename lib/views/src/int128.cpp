#include "geometry/wide.h"

#include <lgs/int128.h>

#include <cmath>

namespace lgs {
namespace {

std::uint64_t magnitudeOf(std::int64_t v) {
  return v < 0 ? ~static_cast<std::uint64_t>(v) + 1 : static_cast<std::uint64_t>(v);
}

}  // namespace

Int128 multiply(std::int64_t a, std::int64_t b) {
  const detail::Wide wide = detail::multiply(magnitudeOf(a), magnitudeOf(b));
  const Int128 product{static_cast<std::int64_t>(wide.high), wide.low};
  return (a < 0) == (b < 0) ? product : -product;
}

double Int128::toDouble() const {
  const Int128 magnitude = isNegative() ? -*this : *this;
  const auto upper = static_cast<std::uint64_t>(magnitude.high);
  double value = static_cast<double>(magnitude.low);
  if (upper != 0) {
    // The first 64 bits, and in the last of them whether there are more: a double looks at 54 of them and at that.
    int shift = 0;
    while ((upper << shift >> 63) == 0) ++shift;
    const std::uint64_t first = shift == 0 ? upper : upper << shift | magnitude.low >> (64 - shift);
    const bool more = (magnitude.low << shift) != 0;
    value = std::ldexp(static_cast<double>(first | (more ? 1 : 0)), 64 - shift);
  }
  return isNegative() ? -value : value;
}

}  // namespace lgs
