// The notations of a polygon that World takes, all of which mean the same.
#pragma once

#include <lgs/lattice.h>
#include <array>
#include <initializer_list>
#include <span>
#include <vector>

namespace lgs::oracle {

enum class Notation {
  lattice,
  list,     ///< an initializer list, if there are three or four vertices
  floats,   ///< exact
  doubles,  ///< off the lattice by less than half a unit
};

template <class Real>
std::vector<RealPoint<Real>> realPoints(const std::vector<LocalPoint>& vertices, double off) {
  std::vector<RealPoint<Real>> points;
  points.reserve(vertices.size());
  for (const LocalPoint& p : vertices)
    points.push_back({static_cast<Real>((p.x + off) / kUnitsPerCell), static_cast<Real>((p.y - off) / kUnitsPerCell)});
  return points;
}

/// Calls `call` with a polygon in this notation. `offset`, below 4, says how far off the lattice it is.
template <class Call>
auto inNotation(const std::vector<LocalPoint>& v, Notation notation, unsigned offset, Call call) {
  constexpr std::array kOff{0.0, 0.25, -0.25, 0.49};  // rounded, all are the same
  if (notation == Notation::floats) {
    const std::vector<FloatPoint> points = realPoints<float>(v, 0);
    return call(std::span<const FloatPoint>(points));
  }
  if (notation == Notation::doubles) {
    const std::vector<DoublePoint> points = realPoints<double>(v, kOff[offset]);
    return call(std::span<const DoublePoint>(points));
  }
  if (notation == Notation::list && v.size() == 3) return call(std::initializer_list<LocalPoint>{v[0], v[1], v[2]});
  if (notation == Notation::list && v.size() == 4)
    return call(std::initializer_list<LocalPoint>{v[0], v[1], v[2], v[3]});
  return call(std::span<const LocalPoint>(v));
}

}  // namespace lgs::oracle
