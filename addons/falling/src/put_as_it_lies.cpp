#include "by_block.h"

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

/// The outline of each block by itself, turned and moved: holes run the other way around, so their count is 0. In a world
/// that keeps what lies between two blocks both have the same vertices there: so rounding leaves no gap.
std::vector<LyingBlock> coveredBy(const World& world, const Placing& placing) {
  std::vector<Segment> edges;
  for (const SegmentId id : world.segments()) edges.push_back(*world.segment(id));
  const auto key = [](const Segment& s) { return std::tie(s.block, s.start); };
  std::ranges::sort(edges, {}, key);
  std::vector<bool> isTaken(edges.size());
  std::vector<LyingBlock> covered;
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

// A part and a block have a name together, in this order. So what lies between two parts is kept, too.
Expected<std::vector<std::vector<LyingBlock>>> partsAsTheyLie(const Body& body, const Placing& placing,
                                                              std::size_t polygonsAtOnce) noexcept {
  polygonsAtOnce = std::max<std::size_t>(polygonsAtOnce, 1);
  std::vector<std::pair<std::size_t, Block>> named;
  for (std::size_t k = 0; k < body.polygons.size(); ++k) named.emplace_back(k / polygonsAtOnce, body.polygons[k].block);
  std::vector<std::pair<std::size_t, Block>> known = named;
  std::ranges::sort(known);
  known.erase(std::unique(known.begin(), known.end()), known.end());
  std::vector<Block> names;
  for (const auto& name : named)
    names.push_back(static_cast<Block>(std::ranges::lower_bound(known, name) - known.begin()));
  const auto world = detail::worldOf(body, names);
  if (!world) return tl::unexpected(world.error());
  std::vector<std::vector<LyingBlock>> parts(named.empty() ? 0 : named.back().first + 1);
  for (LyingBlock& one : coveredBy(*world, placing)) {
    const auto& [part, block] = known[one.block];
    parts[part].push_back({block, std::move(one.region)});
  }
  return parts;
}

Expected<void> putAsItLies(World& world, const Body& body, const Placing& placing) noexcept {
  const auto parts = partsAsTheyLie(body, placing, body.polygons.size());
  if (!parts) return tl::unexpected(parts.error());
  Transaction group = world.edit();
  for (const std::vector<LyingBlock>& part : *parts)
    if (const auto done = putPart(world, part); !done) return done;
  group.keep();
  return {};
}

Expected<void> putPart(World& world, std::span<const LyingBlock> part) noexcept {
  Transaction group = world.edit();
  for (const auto& [block, region] : part)
    if (const auto done = paint(world, region, block, PaintMode::fill); !done) return tl::unexpected(done.error());
  group.keep();
  return {};
}

}  // namespace lgs
