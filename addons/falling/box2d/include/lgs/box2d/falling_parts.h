// What a body of Box2D is made of: shapes in metres, and its mass. For lgs/box2d/falling.h of either Box2D.
#pragma once

#include <lgs/box2d/frame.h>
#include <lgs/falling.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <vector>

namespace lgs::box2d {

/// A convex polygon in metres, from the body's origin.
struct FallingPart {
  Block block = 0;             ///< what it is of
  std::vector<Place> corners;  ///< counter-clockwise, at most 8
};

/// Mass, where it lies, and rotational inertia about that place.
struct FallingMass {
  double mass = 0;     ///< kg
  Place center;        ///< metres from the body's origin
  double inertia = 0;  ///< kg m²
};

/// The least distance between two parallel lines that hold a convex polygon between them.
inline double widthOf(const std::vector<Place>& corners) {
  double width = HUGE_VAL;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Place a = corners[k], b = corners[k + 1 == corners.size() ? 0 : k + 1];
    const double dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
    double reach = 0;
    for (const Place& p : corners) reach = std::max(reach, (dx * (p.y - a.y) - dy * (p.x - a.x)) / length);
    width = std::min(width, reach);
  }
  return width;
}

/// The parts of a body that are wider than Box2D's slop, as `float` has their corners: of narrower ones it makes no
/// shape.
inline std::vector<FallingPart> fallingParts(const std::vector<ConvexPart>& parts, double cellSize, double slop) {
  const double scale = cellSize / kUnitsPerCell;
  const auto rounded = [&](std::int64_t units) {
    return static_cast<double>(static_cast<float>(static_cast<double>(units) * scale));
  };
  std::vector<FallingPart> out;
  for (const ConvexPart& part : parts) {
    FallingPart p{part.block, {}};
    for (const Point v : part.vertices) {
      const Place at{rounded(v.x), rounded(v.y)};
      const auto isThere = [&](const Place& c) { return c.x == at.x && c.y == at.y; };
      if (std::ranges::none_of(p.corners, isThere)) p.corners.push_back(at);
    }
    // A tenth more, as for edges.
    if (p.corners.size() > 2 && widthOf(p.corners) > 1.1 * slop) out.push_back(std::move(p));
  }
  return out;
}

/// The mass of a body whose blocks have these densities, in kg per square metre. What is too thin for a shape counts,
/// too.
inline FallingMass fallingMass(const Body& body, const std::function<float(Block)>& density, double cellSize) {
  std::map<Block, std::vector<BodyPolygon>> byBlock;
  for (const BodyPolygon& p : body.polygons) byBlock[p.block].push_back(p);
  FallingMass sum;
  const auto add = [&](double mass, Place center, double inertia) {
    const double all = sum.mass + mass;
    const double dx = center.x - sum.center.x, dy = center.y - sum.center.y;
    sum.inertia += inertia + (all > 0 ? sum.mass * mass / all * (dx * dx + dy * dy) : 0);
    if (all > 0) sum.center = {sum.center.x + dx * mass / all, sum.center.y + dy * mass / all};
    sum.mass = all;
  };
  const double area = cellSize * cellSize;
  for (const auto& [block, polygons] : byBlock) {
    const double weight = density ? static_cast<double>(density(block)) : 1;
    const MassOfPolygons mass = massOf(polygons);
    add(weight * mass.area * area, {mass.centroid.x * cellSize, mass.centroid.y * cellSize},
        weight * mass.secondMoment * area * area);
  }
  return sum;
}

}  // namespace lgs::box2d
