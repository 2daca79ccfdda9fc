// Doors of brushes.
#include "door.h"

#include <lgs/brush.h>

#include <algorithm>

namespace lgs::test {
namespace {

bool isNoLength(std::int64_t v) { return v < 1 || v > kMaxRegionCells / 2 * kUnitsPerCell; }

/// What functions of regions make is used at once: a region may be refused, but nothing else.
void use(Scene& s, const Region& region) {
  const auto painted = paint(s.other, region, 4, PaintMode::fill);
  if (!painted) return;
  const auto carved = carve(s.other, region);  // of what was full before, it may leave too much for a cell
  EXPECT_TRUE(carved || carved.error().code == ErrorCode::capacity);
}

}  // namespace

void addDoorsOfBrushes(Doors& door) {
  door("region(span<const vector<DoublePoint>>, FillRule)", [](Scene& s, const std::vector<Reals<double>>& rings,
                                                               FillRule rule) {
    const Region made = region(rings, rule);
    std::vector<Ring> expected(rings.size());
    for (std::size_t k = 0; k < rings.size(); ++k)
      std::ranges::transform(rings[k], std::back_inserter(expected[k]), [](DoublePoint p) { return latticePoint(p); });
    EXPECT_EQ(made.rings, expected);  // no vertex is lost, so the message can name the one that is no number
    use(s, made);
  });
  door("circle(Point, int64_t, int)", [](Scene& s, Point center, std::int64_t radius, int corners) {
    return refusedIf(!inRange(center) || isNoLength(radius), carve(s.world, circle(center, radius, corners)));
  });
  door("rectangle(Point, Point, int64_t, int64_t)",
       [](Scene& s, Point center, Point along, std::int64_t length, std::int64_t width) {
         return refusedIf(!inRange(center) || isNoLength(length) || isNoLength(width),
                          carve(s.world, rectangle(center, along, length, width)));
       });
  door("thickLine(span<const Point>, int64_t, int)",
       [](Scene& s, const std::vector<Point>& points, std::int64_t radius, int corners) {
         const std::vector<Point> some(
             points.begin(), points.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(points.size(), 9)));
         return refusedIf(!some.empty() && isNoLength(radius), carve(s.world, thickLine(some, radius, corners)));
       });
  door("boundsOf(const Region&)", [](Scene&, const Region& region) { return boundsOf(region); });
  door("cellsOf(const Region&)", [](Scene&, const Region& region) {
    const auto cells = cellsOf(region);
    EXPECT_TRUE(!cells || std::ranges::all_of(*cells, [](Cell cell) { return inRange(cell); }));
    return cells;
  });
  door("without(const Region&, const Region&)", [](Scene&, const Region& region, const Region& except) {
    const auto rest = without(region, except);
    EXPECT_TRUE(!rest || cellsOf(*rest));
    return rest;
  });
  door("meets(const Region&, const Ring&)",
       [](Scene&, const Region& region, const std::vector<Point>& ring) { return meets(region, ring); });
  door("paint(World&, const Region&, Block, PaintMode, const StayingBlocks&)",
       [](Scene& s, const Region& region, Block b, PaintMode mode, const StayingBlocks& staying) {
         return paint(s.world, region, b, mode, staying);
       });
  door("carve(World&, const Region&, const StayingBlocks&)",
       [](Scene& s, const Region& region, const StayingBlocks& staying) { return carve(s.world, region, staying); });
}

}  // namespace lgs::test
