// Random numbers and polygons. The standard's distributions give other numbers in each library, so there are none here.
#pragma once

#include <lgs/lattice.h>

#include <cstdint>
#include <vector>

namespace platform {

/// SplitMix64 (Steele, Lea, Flood 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    state_ += 0x9e37'79b9'7f4a'7c15;
    std::uint64_t z = state_;
    z = (z ^ z >> 30) * 0xbf58'476d'1ce4'e5b9;
    z = (z ^ z >> 27) * 0x94d0'49bb'1331'11eb;
    return z ^ z >> 31;
  }
  /// 0 … count − 1.
  std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>((bits() >> 32) * count >> 32); }
  /// Both included.
  std::int32_t between(std::int32_t low, std::int32_t high) {
    return low + static_cast<std::int32_t>(below(static_cast<std::uint32_t>(high - low) + 1));
  }
  bool oneIn(std::uint32_t count) { return below(count) == 0; }
  template <class Values>
  const auto& of(const Values& values) {
    return values[below(static_cast<std::uint32_t>(values.size()))];
  }

 private:
  std::uint64_t state_;
};

using Polygon = std::vector<lgs::LocalPoint>;

/// Mostly what tiles of a game are: full, half and quarter squares, ramps, diamonds, and triangles anywhere. One in ten
/// must be refused, for any reason.
Polygon randomPolygon(Random& random);

/// One polygon to four: mostly disjoint parts of a cell.
std::vector<Polygon> randomShape(Random& random);

/// Near to the polygon in cells, so that rounding has something to do. Few coordinates are infinite or no number.
template <class Real>
std::vector<lgs::RealPoint<Real>> inReals(Random& random, const Polygon& polygon);

}  // namespace platform
