#include "exact.h"

#include <bit>
#include <cmath>

namespace lgs::detail {

Exact Exact::of(Int128 value) {
  if (value.isNegative()) value = -value;
  Exact out(value.low);
  const auto high = static_cast<std::uint64_t>(value.high);
  out.words_[2] = static_cast<std::uint32_t>(high);
  out.words_[3] = static_cast<std::uint32_t>(high >> 32);
  return out;
}

Exact& Exact::operator+=(const Exact& b) {
  std::uint64_t carry = 0;
  for (std::size_t k = 0; k < kWords; ++k) {
    carry += std::uint64_t{words_[k]} + b.words_[k];
    words_[k] = static_cast<std::uint32_t>(carry);
    carry >>= 32;
  }
  return *this;
}

Exact& Exact::operator-=(const Exact& b) {
  std::uint64_t borrow = 0;
  for (std::size_t k = 0; k < kWords; ++k) {
    const std::uint64_t difference = std::uint64_t{words_[k]} - b.words_[k] - borrow;
    words_[k] = static_cast<std::uint32_t>(difference);
    borrow = difference >> 63;
  }
  return *this;
}

Exact operator*(const Exact& a, const Exact& b) {
  Exact out(0);
  for (std::size_t i = 0; i < Exact::kWords; ++i) {
    std::uint64_t carry = 0;
    for (std::size_t j = 0; i + j < Exact::kWords; ++j) {
      carry += std::uint64_t{a.words_[i]} * b.words_[j] + out.words_[i + j];
      out.words_[i + j] = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
  }
  return out;
}

Exact Exact::operator<<(unsigned bits) const {
  Exact out(0);
  const std::size_t words = bits / 32;
  for (std::size_t k = kWords; k-- > words;) {
    const std::uint64_t low = k > words ? words_[k - words - 1] : 0;
    const std::uint64_t both = std::uint64_t{words_[k - words]} << 32 | low;
    out.words_[k] = static_cast<std::uint32_t>(both << bits % 32 >> 32);
  }
  return out;
}

bool Exact::operator>=(const Exact& b) const {
  for (std::size_t k = kWords; k-- > 0;)
    if (words_[k] != b.words_[k]) return words_[k] > b.words_[k];
  return true;
}

unsigned Exact::bits() const {
  for (std::size_t k = kWords; k-- > 0;)
    if (words_[k] != 0) return static_cast<unsigned>(32 * k) + static_cast<unsigned>(std::bit_width(words_[k]));
  return 0;
}

// The quotient is brought between 2^62 and 2^64 and divided bit by bit. Its last bit says whether something is left
// over: a double takes 53 bits, so it only tells a half from more than that.
double Exact::ratio(Exact a, Exact b) {
  if (a.bits() == 0) return 0;
  const int shift = static_cast<int>(a.bits()) - static_cast<int>(b.bits()) - 63;
  if (shift > 0)
    b = b << static_cast<unsigned>(shift);
  else
    a = a << static_cast<unsigned>(-shift);
  std::uint64_t quotient = 0;
  for (unsigned bit = 64; bit-- > 0;) {
    const Exact part = b << bit;
    if (!(a >= part)) continue;
    a -= part;
    quotient |= std::uint64_t{1} << bit;
  }
  if (a.bits() != 0) quotient |= 1;
  return std::ldexp(static_cast<double>(quotient), shift);
}

}  // namespace lgs::detail
