#include "random.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

namespace platform {
namespace {

constexpr std::int32_t kUnit = lgs::kUnitsPerCell;

/// A box on multiples of an eighth.
Polygon randomBox(Random& random) {
  const std::int32_t left = random.between(0, 7), low = random.between(0, 7);
  const std::int32_t right = random.between(left + 1, 8), high = random.between(low + 1, 8);
  constexpr std::int32_t k = kUnit / 8;
  return {{left * k, low * k}, {right * k, low * k}, {right * k, high * k}, {left * k, high * k}};
}

/// Half of the cell.
Polygon randomRamp(Random& random) {
  Polygon square{{0, 0}, {kUnit, 0}, {kUnit, kUnit}, {0, kUnit}};
  square.erase(square.begin() + static_cast<std::ptrdiff_t>(random.below(4)));
  return square;
}

/// Corners on a lattice of this many steps, which may fall together.
Polygon randomCorners(Random& random, std::uint32_t corners, std::int32_t steps) {
  Polygon polygon;
  for (std::uint32_t k = 0; k < corners; ++k) {
    const std::int32_t x = random.between(0, steps), y = random.between(0, steps);
    polygon.push_back({x * (kUnit / steps), y * (kUnit / steps)});
  }
  return polygon;
}

Polygon counterClockwise(Polygon triangle) {
  const auto [a, b, c] = std::tuple(triangle[0], triangle[1], triangle[2]);
  const std::int64_t turn = std::int64_t{b.x - a.x} * (c.y - a.y) - std::int64_t{b.y - a.y} * (c.x - a.x);
  if (turn < 0) std::swap(triangle[1], triangle[2]);
  return triangle;
}

Polygon badPolygon(Random& random) {
  Polygon polygon = randomBox(random);
  switch (random.below(6)) {
    case 0:  // two vertices
      polygon.resize(2);
      break;
    case 1:  // clockwise
      std::reverse(polygon.begin(), polygon.end());
      break;
    case 2:  // out of the cell
      polygon[random.below(4)].x += kUnit + 1;
      break;
    case 3:  // a vertex twice
      polygon.push_back(polygon[random.below(4)]);
      break;
    case 4:  // a bow tie
      std::swap(polygon[1], polygon[2]);
      break;
    default:  // any quadrangle
      return randomCorners(random, 4, 4);
  }
  return polygon;
}

}  // namespace

Polygon randomPolygon(Random& random) {
  switch (random.below(10)) {
    case 0:
    case 1:
      return {{0, 0}, {kUnit, 0}, {kUnit, kUnit}, {0, kUnit}};
    case 2:
    case 3:
      return randomRamp(random);
    case 4:
    case 5:
      return randomBox(random);
    case 6:
    case 7:
      return counterClockwise(randomCorners(random, 3, random.oneIn(2) ? 4 : 16));
    case 8:
      return counterClockwise(randomCorners(random, 3, kUnit));
    default:
      return badPolygon(random);
  }
}

std::vector<Polygon> randomShape(Random& random) {
  constexpr std::int32_t h = kUnit / 2;
  switch (random.below(5)) {
    case 0:  // both halves along the diagonal
      return {{{0, 0}, {kUnit, 0}, {kUnit, kUnit}}, {{0, 0}, {kUnit, kUnit}, {0, kUnit}}};
    case 1:  // two quarters that touch in the middle
      return {{{0, 0}, {h, 0}, {h, h}, {0, h}}, {{h, h}, {kUnit, h}, {kUnit, kUnit}, {h, kUnit}}};
    case 2:  // four triangles around the middle
      return {{{0, 0}, {kUnit, 0}, {h, h}},
              {{kUnit, 0}, {kUnit, kUnit}, {h, h}},
              {{kUnit, kUnit}, {0, kUnit}, {h, h}},
              {{0, kUnit}, {0, 0}, {h, h}}};
    case 3:  // an edge that ends on another one
      return {{{0, 0}, {kUnit, 0}, {kUnit, h}, {0, h}}, {{0, h}, {h, h}, {0, kUnit}}};
    default: {  // anything
      std::vector<Polygon> polygons;
      for (std::uint32_t k = random.below(4); k > 0; --k) polygons.push_back(randomPolygon(random));
      return polygons;
    }
  }
}

template <class Real>
std::vector<lgs::RealPoint<Real>> inReals(Random& random, const Polygon& polygon) {
  std::vector<lgs::RealPoint<Real>> reals;
  for (const lgs::LocalPoint p : polygon)
    reals.push_back({static_cast<Real>(p.x) / kUnit, static_cast<Real>(p.y) / kUnit});
  if (reals.empty()) return reals;
  lgs::RealPoint<Real>& moved = reals[random.below(static_cast<std::uint32_t>(reals.size()))];
  switch (random.below(24)) {
    case 0:
      moved.x = std::numeric_limits<Real>::quiet_NaN();
      break;
    case 1:
      moved.y = -std::numeric_limits<Real>::infinity();
      break;
    case 2:
      moved.x = std::numeric_limits<Real>::max();
      break;
    case 3:
      moved.y = -std::numeric_limits<Real>::denorm_min();
      break;
    default:  // by whole, half and quarter units: halves are rounded away from zero
      moved.x += static_cast<Real>(random.between(-6, 6)) / (4 * kUnit);
      moved.y += static_cast<Real>(random.between(-6, 6)) / (4 * kUnit);
  }
  return reals;
}

template std::vector<lgs::FloatPoint> inReals(Random& random, const Polygon& polygon);
template std::vector<lgs::DoublePoint> inReals(Random& random, const Polygon& polygon);

}  // namespace platform
