// Exact fractions whose numerators and denominators fill so many bits that products of two of them do not fit in 64.
#pragma once

#include <compare>
#include <cstdint>
#include <utility>

namespace lgs::tiled {

/// The quotient rounded down, and the rest: 0 <= rest < divisor.
struct Quotient {
  std::int64_t whole = 0;
  std::int64_t rest = 0;
};

constexpr Quotient divide(std::int64_t a, std::int64_t divisor) {
  const std::int64_t rest = a % divisor;
  return rest < 0 ? Quotient{a / divisor - 1, rest + divisor} : Quotient{a / divisor, rest};
}

/// The number whole + rest / divisor, 0 <= rest < divisor.
struct Fraction {
  std::int64_t whole = 0;
  std::int64_t rest = 0;
  std::int64_t divisor = 1;
};

/// a / divisor, for a positive divisor.
constexpr Fraction fraction(std::int64_t a, std::int64_t divisor) {
  const auto [whole, rest] = divide(a, divisor);
  return {whole, rest, divisor};
}

/// a · b / divisor, for |a| up to 2^40 and 0 <= b <= divisor <= 2^40. The product may need 80 bits, so b is taken in
/// two halves.
constexpr Fraction fractionOfProduct(std::int64_t a, std::int64_t b, std::int64_t divisor) {
  constexpr std::int64_t kHalf = std::int64_t{1} << 20;
  const Quotient high = divide(a * (b / kHalf), divisor);
  const Quotient low = divide(high.rest * kHalf + a * (b % kHalf), divisor);
  return {high.whole * kHalf + low.whole, low.rest, divisor};
}

/// Compares without products, by what Euclid's algorithm makes of both fractions: a < b exactly if 1 / b < 1 / a.
constexpr std::weak_ordering operator<=>(Fraction a, Fraction b) {
  while (a.whole == b.whole && a.rest != 0 && b.rest != 0) {
    const Fraction inverse = fraction(a.divisor, a.rest);
    a = fraction(b.divisor, b.rest);
    b = inverse;
  }
  if (a.whole != b.whole) return a.whole <=> b.whole;
  return (a.rest != 0) <=> (b.rest != 0);
}

constexpr bool operator==(Fraction a, Fraction b) { return (a <=> b) == 0; }

}  // namespace lgs::tiled
