// Coordinates through floats and back. (Imported maps: addons/tiled/tests/round_trip_test.cpp.)
#include "proptests/support/law.h"
#include "proptests/support/shapes.h"
#include "proptests/support/traces.h"
#include "proptests/support/worlds.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace lgs::test {
namespace {

// --- Coordinates -----------------------------------------------------------------------------------------------------

/// Places a polygon of real coordinates, and takes it away. What it was on the lattice.
template <class Real>
LocalPolygon onLattice(const std::vector<RealPoint<Real>>& polygon) {
  static World world;
  const auto handle = world.add({}, std::span<const RealPoint<Real>>(polygon), 1);
  if (!handle) failIf(message(handle.error()));
  const auto vertices = world.polygon(*handle)->vertices;
  LocalPolygon result(vertices.begin(), vertices.end());
  failUnless(world.remove(*handle).has_value(), "it can not be removed");
  return result;
}

/// Each coordinate of a lattice polygon at most `away` lattice units off, often as much as that.
template <class Real>
std::vector<RealPoint<Real>> near(const LocalPolygon& polygon, double away, Chance& chance) {
  std::vector<RealPoint<Real>> out;
  const auto real = [&](std::int32_t v) { return static_cast<Real>((v + away * (chance.below(5) - 2) / 2) / U); };
  for (const LocalPoint& v : polygon) {
    const Real x = real(v.x);
    out.push_back({x, real(v.y)});
  }
  return out;
}

/// `away` is below a half, so that rounding gives the polygon again.
template <class Real>
void comesBack(const LocalPolygon& polygon, double away, Chance& chance) {
  failUnless(onLattice<Real>(near<Real>(polygon, 0, chance)) == polygon, "a lattice point is rounded elsewhere");
  failUnless(onLattice<Real>(near<Real>(polygon, away, chance)) == polygon, "rounded, but not to the nearest");
}

LGS_LAW(RoundTrip, LatticeToFloatsToLattice, 4'000, (const AnyPolygon& polygon, Chance chance)) {
  comesBack<float>(polygon.vertices, 0.49, chance);  // it has room for at least 1/256 of a unit
  comesBack<double>(polygon.vertices, 0.499'999, chance);
}

/// What is wrong with `v`, of the lattice, as what became of `real`. All of it is exact; v - units would not be.
template <class Real>
void expectNearest(Real real, std::int32_t v) {
  const double units = double{real} * U, below = v - 0.5, above = v + 0.5;
  const bool isNear = below <= units && units <= above;
  if (isNear && units != (units > 0 ? above : below)) return;
  failIf(fmt::format("{:a} is {} units, and becomes {}: {}", real, units, v,
                     isNear ? "not away from zero" : "more than half a unit away"));
}

/// To the lattice, which is at most half a unit away, and back; and again, which changes nothing.
template <class Real>
void isRounded(const AnyReal<Real>& x, const AnyReal<Real>& y) {
  // A triangle with that side of the cell, lower or upper, that is farther from the point.
  const Real side = y.value < Real(0.5) ? 1 : 0;
  const LocalPolygon rounded = onLattice<Real>({{x.value, y.value}, {side, side}, {1 - side, side}});
  expectNearest(x.value, rounded[0].x);
  expectNearest(y.value, rounded[0].y);
  std::vector<RealPoint<Real>> back;
  for (const LocalPoint& q : rounded) back.push_back({static_cast<Real>(q.x) / U, static_cast<Real>(q.y) / U});
  failUnless(onLattice<Real>(back) == rounded, "once rounded, it is rounded elsewhere");
}

LGS_LAW(RoundTrip, FloatsToLatticeToFloats, 20'000, (const AnyReal<float>& x, const AnyReal<float>& y)) {
  isRounded(x, y);
}

LGS_LAW(RoundTrip, DoublesToLatticeToDoubles, 20'000, (const AnyReal<double>& x, const AnyReal<double>& y)) {
  isRounded(x, y);
}

}  // namespace
}  // namespace lgs::test
