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

std::int32_t kept(Bridge& bridge, Expected<BrushResult> result) {
  if (!result) return refused(result.error(), 0);
  bridge.brushed = std::move(*result);
  bridge.isEdited = true;
  return 1;
}

void putHandles(const std::vector<PolygonHandle>& handles) {
  for (const PolygonHandle handle : handles) answer().push_back(toNumber(handle));
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

LGS_EXPORT("paint")
std::int32_t paintRegion(Bridge* bridge, std::size_t numbers, Block block, std::int32_t replace) {
  const PaintMode mode = replace != 0 ? PaintMode::replace : PaintMode::fill;
  return kept(*bridge, paint(bridge->world, inputRegion(numbers), block, mode));
}

LGS_EXPORT("carve") std::int32_t carveRegion(Bridge* bridge, std::size_t numbers) {
  return kept(*bridge, carve(bridge->world, inputRegion(numbers)));
}

/// What the last brush of a world did: 0 removed, 1 added, 2 rounded.
LGS_EXPORT("brushed") std::size_t brushed(const Bridge* bridge, std::int32_t list) {
  const BrushResult& result = bridge->brushed;
  answer().clear();
  putHandles(list == 0 ? result.removed : list == 1 ? result.added : result.rounded);
  return answer().size();
}

/// For each change the old polygon, the number of new ones, and these.
LGS_EXPORT("brushChanges") std::size_t brushChanges(const Bridge* bridge) {
  answer().clear();
  for (const BrushChange& change : bridge->brushed.changed) {
    answer().insert(answer().end(), {toNumber(change.old), static_cast<double>(change.now.size())});
    putHandles(change.now);
  }
  return answer().size();
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
