#include "by_block.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

namespace lgs::detail {
namespace {

template <class IsIn>
Expected<World> worldOfThose(const Body& body, World world, IsIn&& isIn) {
  for (std::size_t k = 0; k < body.polygons.size(); ++k) {
    const BodyPolygon& p = body.polygons[k];
    if (!isIn(p.block)) continue;
    if (const auto done = world.add(p.cell, std::span<const LocalPoint>(p.vertices), p.block); !done) {
      Error error = done.error();
      error.index = static_cast<std::int32_t>(k);
      return tl::unexpected(error);
    }
  }
  world.commit();
  return world;
}

}  // namespace

std::vector<Block> blocksOf(const Body& body) {
  std::vector<Block> blocks;
  for (const BodyPolygon& p : body.polygons) blocks.push_back(p.block);
  std::ranges::sort(blocks);
  blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
  return blocks;
}

Expected<World> worldOf(const Body& body, Block block) {
  return worldOfThose(body, World(), [block](Block b) { return b == block; });
}

Expected<World> worldOf(const Body& body) {
  return worldOfThose(body, World([](Block a, Block b) { return a != b; }), [](Block /*any*/) { return true; });
}

}  // namespace lgs::detail
