// Signed integers of 128 bits: areas of loops and bodies need them. They are plain values of two words, since not every
// compiler has such a type.
#pragma once

#include <compare>
#include <cstdint>

namespace lgs {

/// In two's complement. What overflows wraps around; no value that the library hands out does.
struct Int128 {
  std::int64_t high = 0;  ///< the upper half, with the sign
  std::uint64_t low = 0;  ///< the lower half

  constexpr Int128() = default;
  /// upper × 2^64 + lower.
  constexpr Int128(std::int64_t upper, std::uint64_t lower) : high(upper), low(lower) {}
  /// The same number.
  constexpr explicit Int128(std::int64_t value) : high(value < 0 ? -1 : 0), low(static_cast<std::uint64_t>(value)) {}

  constexpr bool isNegative() const { return high < 0; }  ///< whether it is less than 0
  /// The nearest number that is a `double`; of two that are as near the even one.
  double toDouble() const;

  /// The sum.
  friend constexpr Int128 operator+(Int128 a, Int128 b) {
    const std::uint64_t sum = a.low + b.low;
    const std::uint64_t carry = sum < a.low ? 1 : 0;
    return {static_cast<std::int64_t>(static_cast<std::uint64_t>(a.high) + static_cast<std::uint64_t>(b.high) + carry),
            sum};
  }
  /// The same distance from 0, on the other side.
  friend constexpr Int128 operator-(Int128 a) {
    const std::uint64_t negated = ~a.low + 1;
    return {static_cast<std::int64_t>(~static_cast<std::uint64_t>(a.high) + (negated == 0 ? 1 : 0)), negated};
  }
  friend constexpr Int128 operator-(Int128 a, Int128 b) { return a + -b; }  ///< the difference
  constexpr Int128& operator+=(Int128 b) { return *this = *this + b; }      ///< adds
  constexpr Int128& operator-=(Int128 b) { return *this = *this - b; }      ///< takes away
  friend constexpr auto operator<=>(const Int128&, const Int128&) = default;
};

/// The whole product.
Int128 multiply(std::int64_t a, std::int64_t b);

}  // namespace lgs
