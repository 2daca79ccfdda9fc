// Whole numbers of 320 bits without a sign, as far as moments of bodies need them: the sums are exact, and what is
// handed out is rounded once.
#pragma once

#include <lgs/int128.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace lgs::detail {

class Exact {
 public:
  explicit Exact(std::uint64_t value)
      : words_{static_cast<std::uint32_t>(value), static_cast<std::uint32_t>(value >> 32)} {}
  /// The magnitude of a number.
  static Exact of(Int128 value);

  Exact& operator+=(const Exact& b);
  Exact& operator-=(const Exact& b);  ///< of one that is not greater
  friend Exact operator*(const Exact& a, const Exact& b);
  Exact operator<<(unsigned bits) const;
  bool operator>=(const Exact& b) const;
  unsigned bits() const;  ///< how many there are up to the highest one that is set

  /// a / b, as the nearest `double`. b is not 0.
  static double ratio(Exact a, Exact b);

 private:
  static constexpr std::size_t kWords = 10;
  std::array<std::uint32_t, kWords> words_{};  // the lowest first
};

}  // namespace lgs::detail
