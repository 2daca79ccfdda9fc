#include "by_block.h"

#include <lgs/brush.h>
#include <lgs/falling.h>

#include <algorithm>
#include <tuple>
#include <utility>

namespace lgs {
namespace {

Point placed(Point p, const Placing& placing) {
  const double x = static_cast<double>(p.x) / kUnitsPerCell, y = static_cast<double>(p.y) / kUnitsPerCell;
  return latticePoint({placing.origin.x + (placing.cosine * x - placing.sine * y),
                       placing.origin.y + (placing.sine * x + placing.cosine * y)});
}

/// What a block of a body covers.
struct Covered {
  Block block = 0;
  Region region;
};

/// The outline of each block by itself, turned and moved: holes run the other way around, so their count is 0. In a world
/// that keeps what lies between two blocks both have the same vertices there: so rounding leaves no gap.
std::vector<Covered> coveredBy(const World& world, const Placing& placing) {
  std::vector<Segment> edges;
  for (const SegmentId id : world.segments()) edges.push_back(*world.segment(id));
  const auto key = [](const Segment& s) { return std::tie(s.block, s.start); };
  std::ranges::sort(edges, {}, key);
  std::vector<bool> isTaken(edges.size());
  std::vector<Covered> covered;
  for (std::size_t first = 0; first < edges.size(); ++first) {
    if (isTaken[first]) continue;
    const Block block = edges[first].block;
    if (covered.empty() || covered.back().block != block) covered.push_back({block, {}});
    Ring ring;
    std::size_t at = first;
    do {  // as many begin at a point as end there, so one of them goes on
      isTaken[at] = true;
      ring.push_back(placed(edges[at].start, placing));
      const Point end = edges[at].end;
      if (end == edges[first].start) break;
      at = static_cast<std::size_t>(std::ranges::lower_bound(edges, std::tie(block, end), {}, key) - edges.begin());
      while (isTaken[at]) ++at;
    } while (true);
    covered.back().region.rings.push_back(std::move(ring));
  }
  return covered;
}

}  // namespace

Expected<void> putAsItLies(World& world, const Body& body, const Placing& placing) noexcept {
  const auto blocks = detail::worldOf(body);
  if (!blocks) return tl::unexpected(blocks.error());
  Transaction group = world.edit();
  for (const auto& [block, region] : coveredBy(*blocks, placing))
    if (const auto done = paint(world, region, block, PaintMode::fill); !done) return tl::unexpected(done.error());
  group.keep();
  return {};
}

}  // namespace lgs
