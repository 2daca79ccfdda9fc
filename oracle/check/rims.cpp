#include "oracle/check/rims.h"

#include "oracle/reference/vector.h"
#include "oracle/reference/words.h"

#include <fmt/format.h>
#include <algorithm>
#include <cstdlib>
#include <set>
#include <utility>
#include <vector>

namespace lgs::oracle {
namespace {

struct RimEdge {
  Point a, b;
};
using Edges = std::vector<RimEdge>;
using Axis = std::int64_t Point::*;

// Whether a point of a line is the lattice point next to where an edge crosses that, or one of two.
bool isCrossing(Point v, const RimEdge& edge, Axis across, Axis along) {
  const std::int64_t run = edge.b.*across - edge.a.*across, to = v.*across - edge.a.*across;
  if (run == 0 || (run > 0 ? to < 0 || to > run : to > 0 || to < run)) return false;
  const std::int64_t off = (v.*along - edge.a.*along) * run - (edge.b.*along - edge.a.*along) * to;
  return 2 * std::abs(off) <= std::abs(run);
}

// Whether an edge passes through the square of two units around a point, or near it.
bool passes(const RimEdge& edge, Point v) {
  const auto isWithin = [&](Axis axis) {
    const auto [min, max] = std::minmax(edge.a.*axis, edge.b.*axis);
    return min - 1 <= v.*axis && v.*axis <= max + 1;
  };
  const Vector d = edge.b - edge.a;
  return isWithin(&Point::x) && isWithin(&Point::y) && std::abs(cross(d, v - edge.a)) <= std::abs(d.x) + std::abs(d.y);
}

bool isOnLine(std::int64_t k) { return k % kUnitsPerCell == 0; }

}  // namespace

std::string wrongRim(const BrushEdit& brush, const Scene& before, const Scene& after) {
  std::set<Point> known;
  Edges ofRegion, ofGround;
  const auto add = [&](Edges& edges, Point a, Point b) {
    known.insert(a);
    if (a != b) edges.push_back({a, b});
  };
  for (const auto& ring : brush.rings)
    for (std::size_t k = 0; k < ring.size(); ++k) add(ofRegion, ring[k], ring[(k + 1) % ring.size()]);
  for (const auto& [cell, block, vertices] : before.polygons)
    for (std::size_t k = 0; k < vertices.size(); ++k)
      add(ofGround, toWorld(cell, vertices[k]), toWorld(cell, vertices[(k + 1) % vertices.size()]));
  for (const auto& [cell, block, vertices] : after.polygons)
    for (const LocalPoint& vertex : vertices) {
      const Point v = toWorld(cell, vertex);
      const bool isVertical = isOnLine(v.x);
      if (isVertical == isOnLine(v.y) || known.contains(v)) continue;  // no rim, or a corner
      const Axis across = isVertical ? &Point::x : &Point::y, along = isVertical ? &Point::y : &Point::x;
      const auto crossesHere = [&](const RimEdge& edge) { return isCrossing(v, edge, across, along); };
      const auto comes = [&](const RimEdge& edge) {  // from elsewhere
        return (edge.a.*across != v.*across || edge.b.*across != v.*across) && passes(edge, v);
      };
      if (std::ranges::any_of(ofRegion, crossesHere) || std::ranges::any_of(ofGround, comes) ||
          std::ranges::count_if(ofRegion, comes) > 1)
        continue;
      return fmt::format("the vertex {} is not where the region crosses the line between the cells", inWords(v));
    }
  return "";
}

}  // namespace lgs::oracle
