#include "by_block.h"

#include <lgs/brush.h>
#include <lgs/falling.h>

#include <algorithm>
#include <utility>

namespace lgs {
namespace {

Point placed(Point p, const Placing& placing) {
  const double x = static_cast<double>(p.x) / kUnitsPerCell, y = static_cast<double>(p.y) / kUnitsPerCell;
  return latticePoint({placing.origin.x + (placing.cosine * x - placing.sine * y),
                       placing.origin.y + (placing.sine * x + placing.cosine * y)});
}

/// The loops of a world's outline, turned and moved: holes run the other way around, so their count is 0.
Region regionOf(const World& world, const Placing& placing) {
  Region region;
  std::vector<bool> seen(world.maxSegmentId() + std::size_t{1});
  for (const SegmentId start : world.segments()) {
    if (seen[start.value]) continue;
    Ring ring;
    SegmentId at = start;
    do {
      const Segment s = *world.segment(at);
      seen[at.value] = true;
      ring.push_back(placed(s.start, placing));
      at = s.successor;
    } while (at != start);
    region.rings.push_back(std::move(ring));
  }
  return region;
}

}  // namespace

// Each block by itself, and then the whole with the first of them: where an edge is cut at another block's vertex, and
// was not for its own, rounding leaves a gap of a unit.
Expected<void> putAsItLies(World& world, const Body& body, const Placing& placing) noexcept {
  const auto all = detail::worldOf(body);
  if (!all) return tl::unexpected(all.error());
  const std::vector<Block> blocks = detail::blocksOf(body);
  Transaction group = world.edit();
  const auto fill = [&](const World& part, Block block) {
    return paint(world, regionOf(part, placing), block, PaintMode::fill);
  };
  for (const Block block : blocks) {
    const auto part = detail::worldOf(body, block);
    if (!part) return tl::unexpected(part.error());
    if (const auto done = fill(*part, block); !done) return tl::unexpected(done.error());
  }
  if (blocks.size() > 1) {
    if (const auto done = fill(*all, blocks.front()); !done) return tl::unexpected(done.error());
  }
  group.keep();
  return {};
}

}  // namespace lgs
