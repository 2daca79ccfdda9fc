// Regions, and painting and carving them.
#include "bridge.h"

#include <algorithm>

namespace lgs::web {
namespace {

/// The regions of JavaScript: the number of rings, the rule, for each ring the number of its vertices, and then all
/// vertices in cells.
Region inputRegion(std::size_t numbers) {
  const auto in = input<double>(numbers);
  const auto ringCount = static_cast<std::size_t>(in[0]);
  std::vector<std::vector<DoublePoint>> rings(ringCount);
  std::size_t next = 2 + ringCount;
  for (std::size_t k = 0; k < ringCount; ++k) {
    const auto vertices = static_cast<std::size_t>(in[2 + k]);
    rings[k].reserve(vertices);
    for (std::size_t v = 0; v < vertices; ++v, next += 2) rings[k].push_back({in[next], in[next + 1]});
  }
  return region(rings, in[1] != 0 ? FillRule::evenOdd : FillRule::nonZero);
}

void putHandles(const std::vector<PolygonHandle>& handles) {
  answer().push_back(static_cast<double>(handles.size()));
  for (const PolygonHandle handle : handles) answer().push_back(toNumber(handle));
}

/// Lists with their lengths before them: went, came, bent, and for each change the old polygon with the new ones.
std::size_t answered(const Expected<BrushResult>& result) {
  if (!result) return refused(result.error(), std::size_t{0});
  answer().clear();
  putHandles(result->went);
  putHandles(result->came);
  putHandles(result->bent);
  answer().push_back(static_cast<double>(result->changed.size()));
  for (const BrushChange& change : result->changed) {
    answer().push_back(toNumber(change.old));
    putHandles(change.now);
  }
  return answer().size();
}

/// For each ring the number of its vertices and these in cells.
std::size_t answered(const Region& region) {
  auto& out = answer();
  out.clear();
  for (const Ring& ring : region.rings) {
    out.push_back(static_cast<double>(ring.size()));
    for (const Point v : ring) out.insert(out.end(), {cellsOf(v.x), cellsOf(v.y)});
  }
  return out.size();
}

/// A length in lattice units. JavaScript has checked that it is a number of cells within the limits of a brush;
/// what is below a lattice unit is taken for one.
std::int64_t units(double cells) { return std::max<std::int64_t>(1, std::llround(cells * kUnitsPerCell)); }

}  // namespace

LGS_EXPORT("paint") std::size_t paintRegion(Bridge* bridge, std::size_t numbers, Block block, std::int32_t replace) {
  return answered(
      paint(bridge->world, inputRegion(numbers), block, replace != 0 ? PaintMode::replace : PaintMode::fill));
}

LGS_EXPORT("carve") std::size_t carveRegion(Bridge* bridge, std::size_t numbers) {
  return answered(carve(bridge->world, inputRegion(numbers)));
}

LGS_EXPORT("circle") std::size_t circleRegion(double x, double y, double radius, std::int32_t corners) {
  return answered(circle(latticePoint({x, y}), units(radius), corners));
}

LGS_EXPORT("rectangle")
std::size_t rectangleRegion(double x, double y, double alongX, double alongY, double halfLength, double halfWidth) {
  return answered(rectangle(latticePoint({x, y}), latticePoint({alongX, alongY}), units(halfLength), units(halfWidth)));
}

/// The points are in the input.
LGS_EXPORT("thickLine") std::size_t thickLineRegion(std::size_t count, double radius, std::int32_t corners) {
  std::vector<Point> points;
  points.reserve(count);
  for (const DoublePoint p : inputPoints(count)) points.push_back(latticePoint(p));
  return answered(thickLine(points, units(radius), corners));
}

}  // namespace lgs::web
