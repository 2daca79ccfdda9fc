// The notations of a polygon that World takes, all of which mean the same.
#pragma once

#include <lgs/lattice.h>
#include <array>
#include <initializer_list>
#include <limits>
#include <span>
#include <vector>

namespace lgs::oracle {

enum class Notation {
  lattice,
  list,     ///< an initializer list, if there are three or four vertices
  floats,   ///< exact
  doubles,  ///< off the lattice by less than half a unit
};

/// Offsets that are no offset: the last vertex is not finite (two of them), or very far away.
inline constexpr unsigned kSpoiltOffset = 4;
inline constexpr unsigned kOffsets = 7;

constexpr bool isReal(Notation notation) { return notation == Notation::floats || notation == Notation::doubles; }

template <class Real>
std::vector<RealPoint<Real>> realPoints(const std::vector<LocalPoint>& vertices, unsigned offset, bool isExact) {
  using Limits = std::numeric_limits<Real>;
  constexpr std::array kOff{0.0, 0.25, -0.25, 0.49};  // rounded, all are the same
  constexpr std::array kNone{Limits::quiet_NaN(), -Limits::infinity(), Limits::max()};
  const double off = offset < kSpoiltOffset && !isExact ? kOff[offset] : 0;
  std::vector<RealPoint<Real>> points;
  for (const LocalPoint& p : vertices)
    points.push_back({static_cast<Real>((p.x + off) / kUnitsPerCell), static_cast<Real>((p.y - off) / kUnitsPerCell)});
  if (offset >= kSpoiltOffset && !points.empty()) points.back().y = kNone[offset - kSpoiltOffset];
  return points;
}

/// Calls `call` with a polygon in this notation. `offset`, below kOffsets, says how far off the lattice it is.
template <class Call>
auto inNotation(const std::vector<LocalPoint>& v, Notation notation, unsigned offset, Call call) {
  if (notation == Notation::floats) {
    const auto points = realPoints<float>(v, offset, true);
    return call(std::span<const FloatPoint>(points));
  }
  if (notation == Notation::doubles) {
    const auto points = realPoints<double>(v, offset, false);
    return call(std::span<const DoublePoint>(points));
  }
  if (notation == Notation::list && v.size() == 3) return call(std::initializer_list<LocalPoint>{v[0], v[1], v[2]});
  if (notation == Notation::list && v.size() == 4)
    return call(std::initializer_list<LocalPoint>{v[0], v[1], v[2], v[3]});
  return call(std::span<const LocalPoint>(v));
}

}  // namespace lgs::oracle
