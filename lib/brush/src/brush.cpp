#include <lgs/brush.h>

#include "apply.h"
#include "geometry/predicates.h"
#include "geometry/ring.h"

#include <algorithm>
#include <utility>

namespace lgs {
namespace {

/// The first cell begins one cell nearer to the origin than the last one ends. inRange() does not look at that.
bool isInACell(Point p) {
  constexpr std::int64_t kLeast = -std::int64_t{kMaxCell} * kUnitsPerCell;
  return inRange(p) && p.x >= kLeast && p.y >= kLeast;
}

/// Turned inside out, if there is no vertex.
detail::Box<Point> boxOf(const Region& region) {
  detail::Box<Point> box{{INT64_MAX, INT64_MAX}, {INT64_MIN, INT64_MIN}};
  for (const Ring& ring : region.rings) {
    for (const Point p : ring) {
      box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
      box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
    }
  }
  return box;
}

Expected<void> checked(const Region& region) {
  constexpr std::int64_t kExtent = kMaxRegionCells * kUnitsPerCell;
  for (std::size_t r = 0; r < region.rings.size(); ++r) {
    for (std::size_t v = 0; v < region.rings[r].size(); ++v) {
      const Point p = region.rings[r][v];
      if (!isInACell(p))
        return tl::unexpected(Error{.code = ErrorCode::outOfReach,
                                    .polygon = static_cast<std::int32_t>(r),
                                    .vertex = static_cast<std::int32_t>(v)});
    }
  }
  const auto [min, max] = boxOf(region);
  if (min.x > max.x) return {};  // no vertex
  if (max.x - min.x > kExtent || max.y - min.y > kExtent) return tl::unexpected(Error{.code = ErrorCode::outOfReach});
  return {};
}

Expected<BrushResult> brushed(World& world, const Region& region, const brush::Stroke& stroke) {
  if (const auto done = checked(region); !done) return tl::unexpected(done.error());
  const brush::Frame frame;
  const brush::Coverage coverage = brush::coverage(region);
  if (coverage.crowded) return tl::unexpected(Error{.code = ErrorCode::capacity, .cell = *coverage.crowded});
  BrushResult result;
  Transaction group = world.edit();
  if (const auto done = brush::apply(world, coverage, stroke, result); !done) return tl::unexpected(done.error());
  group.keep();
  return result;
}

/// Relative to the lower left corner of what both have: so that no product overflows.
brush::Points relative(const Ring& ring, Point origin) {
  brush::Points points;
  points.reserve(ring.size());
  for (const Point p : ring) points.push_back({p.x - origin.x, p.y - origin.y});
  return points;
}

}  // namespace

Expected<CellRect> boundsOf(const Region& region) noexcept {
  if (const auto done = checked(region); !done) return tl::unexpected(done.error());
  const detail::Box<Point> box = boxOf(region);
  if (box.min.x >= box.max.x || box.min.y >= box.max.y) return CellRect{{0, 0}, {-1, -1}};
  return CellRect{cellAt(box.min), cellAt({box.max.x - 1, box.max.y - 1})};
}

Expected<std::vector<Cell>> cellsOf(const Region& region) noexcept {
  if (const auto done = checked(region); !done) return tl::unexpected(done.error());
  const brush::Frame frame;
  const brush::Coverage coverage = brush::coverage(region);
  if (coverage.crowded) return tl::unexpected(Error{.code = ErrorCode::capacity, .cell = *coverage.crowded});
  std::vector<Cell> cells;
  for (const CellRect& whole : coverage.whole)
    for (std::int32_t j = whole.min.j; j <= whole.max.j; ++j)
      for (std::int32_t i = whole.min.i; i <= whole.max.i; ++i) cells.push_back({i, j});
  for (const brush::CutCell& cut : coverage.cut)
    if (!cut.pieces.empty()) cells.push_back(cut.cell);
  return cells;
}

// The outline has the solid on its left. So its loops run once around each point of it, and around no other.
Expected<Region> without(const Region& region, const Region& except) noexcept {
  World world;
  if (const auto done = paint(world, region, 0, PaintMode::fill); !done) return tl::unexpected(done.error());
  if (const auto done = carve(world, except); !done) {
    Error error = done.error();
    if (error.polygon >= 0) error.polygon += static_cast<std::int32_t>(region.rings.size());
    return tl::unexpected(error);
  }
  world.commit();
  Region result;
  for (Loop& loop : world.loops(Collinear::merge)) result.rings.push_back(std::move(loop.vertices));
  return result;
}

bool meets(const Region& region, const Ring& polygon) noexcept {
  const Region other{{polygon}};
  if (polygon.size() < 3 || !checked(region) || !checked(other)) return false;
  const detail::Box<Point> a = boxOf(region), b = boxOf(other);
  if (!detail::boxesMeet(a.min, a.max, b.min, b.max)) return false;
  const brush::Frame frame;
  brush::Pieces pieces;
  for (const Ring& ring : region.rings)
    if (ring.size() >= 3) {
      const brush::Pieces more = brush::piecesOf(relative(ring, a.min));
      pieces.insert(pieces.end(), more.begin(), more.end());
    }
  return brush::meets(pieces, region.rule, relative(polygon, a.min));
}

Expected<BrushResult> paint(World& world, const Region& region, Block block, PaintMode mode,
                            const StayingBlocks& staying) noexcept {
  const brush::Staying stays(staying);
  const brush::Deed deed = mode == PaintMode::fill ? brush::Deed::fill : brush::Deed::replace;
  return brushed(world, region, {deed, block, region.rule, &stays});
}

Expected<BrushResult> carve(World& world, const Region& region, const StayingBlocks& staying) noexcept {
  const brush::Staying stays(staying);
  return brushed(world, region, {brush::Deed::carve, 0, region.rule, &stays});
}

}  // namespace lgs
