// Unsigned integers of 128 bits, as far as comparing fractions needs them. No compiler's own type: Microsoft's has
// none.
#pragma once

#include <compare>
#include <cstdint>

namespace lgs::detail {

struct Wide {
  std::uint64_t high = 0;
  std::uint64_t low = 0;
  friend constexpr auto operator<=>(const Wide&, const Wide&) = default;
};

/// The whole product: schoolbook multiplication of halves.
constexpr Wide multiply(std::uint64_t a, std::uint64_t b) {
  const std::uint64_t mask = 0xffff'ffff;
  const std::uint64_t low = (a & mask) * (b & mask);
  const std::uint64_t one = (a >> 32) * (b & mask) + (low >> 32);
  const std::uint64_t other = (a & mask) * (b >> 32) + (one & mask);
  return {(a >> 32) * (b >> 32) + (one >> 32) + (other >> 32), other << 32 | (low & mask)};
}

/// A product that is known to fit.
constexpr Wide multiply(Wide a, std::uint64_t b) {
  Wide product = multiply(a.low, b);
  product.high += a.high * b;
  return product;
}

}  // namespace lgs::detail
