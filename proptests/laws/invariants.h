// What holds in every world without a preserve relation, and needs no reference to be checked: so it can be checked on
// worlds of any size.
#pragma once

#include <lgs/world.h>

#include <optional>
#include <string>

namespace lgs::test {

/// What is wrong with the output in these cells, which must be all that hold polygons, if anything:
///  - links are mutual and lead on from end to start, ghosts are the far ends; ids and counts agree;
///  - at each vertex as many segments end as start;
///  - the loops hold every segment once, each closed;
///  - the loops' signed area is the sum of the polygons' areas;
///  - no vertex of a polygon or of a segment lies inside a segment.
/// Cells and the area must be small enough for 64-bit products: within a thousand cells or so of the origin.
std::optional<std::string> brokenInvariant(const World& world, const CellRect& cells);

}  // namespace lgs::test
