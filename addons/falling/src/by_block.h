// A body in worlds of its own: one with all of its polygons, or with those of one block.
#pragma once

#include <lgs/body.h>

#include <span>
#include <vector>

namespace lgs::detail {

/// The blocks of a body, each once, by number.
std::vector<Block> blocksOf(const Body& body);

/// The cells that it was in.
CellRect cellsOf(const Body& body);

/// The polygons that have a block, committed: the origin of the body is the corner of cell (0, 0).
Expected<World> worldOf(const Body& body, Block block);

/// All polygons, each with the name that is given for it as its block; what lies between two names is kept.
Expected<World> worldOf(const Body& body, std::span<const Block> names);

}  // namespace lgs::detail
