#include "by_block.h"

#include <lgs/ground_window.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

namespace lgs::detail {
namespace {

/// Of those polygons that nameOf(index) has a block for.
template <class NameOf>
Expected<World> worldOfThose(const Body& body, World world, NameOf&& nameOf) {
  for (std::size_t k = 0; k < body.polygons.size(); ++k) {
    const BodyPolygon& p = body.polygons[k];
    const std::optional<Block> name = nameOf(k);
    if (!name) continue;
    if (const auto done = world.add(p.cell, std::span<const LocalPoint>(p.vertices), *name); !done) {
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

CellRect cellsOf(const Body& body) {
  std::optional<CellRect> cells;
  for (const BodyPolygon& p : body.polygons) {
    const Cell at{body.origin.i + p.cell.i, body.origin.j + p.cell.j};
    cells = cells ? boxOf(*cells, {at, at}) : CellRect{at, at};
  }
  return cells.value_or(CellRect{body.origin, body.origin});
}

Expected<World> worldOf(const Body& body, Block block) {
  return worldOfThose(body, World(), [&](std::size_t k) {
    return body.polygons[k].block == block ? std::optional(block) : std::nullopt;
  });
}

Expected<World> worldOf(const Body& body, std::span<const Block> names) {
  return worldOfThose(body, World([](Block a, Block b) { return a != b; }),
                      [&](std::size_t k) { return std::optional(names[k]); });
}

}  // namespace lgs::detail
