#include <lgs/brush.h>

#include "apply.h"

#include <algorithm>

namespace lgs {
namespace {

/// The first cell begins one cell nearer to the origin than the last one ends. inRange() does not look at that.
bool isInACell(Point p) {
  constexpr std::int64_t kLeast = -std::int64_t{kMaxCell} * kUnitsPerCell;
  return inRange(p) && p.x >= kLeast && p.y >= kLeast;
}

Expected<void> checked(const Region& region) {
  constexpr std::int64_t kExtent = kMaxRegionCells * kUnitsPerCell;
  Point min{INT64_MAX, INT64_MAX}, max{INT64_MIN, INT64_MIN};
  for (std::size_t r = 0; r < region.rings.size(); ++r) {
    for (std::size_t v = 0; v < region.rings[r].size(); ++v) {
      const Point p = region.rings[r][v];
      if (!isInACell(p))
        return tl::unexpected(Error{.code = ErrorCode::outOfReach,
                                    .polygon = static_cast<std::int32_t>(r),
                                    .vertex = static_cast<std::int32_t>(v)});
      min = {std::min(min.x, p.x), std::min(min.y, p.y)};
      max = {std::max(max.x, p.x), std::max(max.y, p.y)};
    }
  }
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

}  // namespace

Expected<BrushResult> paint(World& world, const Region& region, Block block, PaintMode mode) noexcept {
  return brushed(world, region,
                 {mode == PaintMode::fill ? brush::Deed::fill : brush::Deed::replace, block, region.rule});
}

Expected<BrushResult> carve(World& world, const Region& region) noexcept {
  return brushed(world, region, {brush::Deed::carve, 0, region.rule});
}

}  // namespace lgs
