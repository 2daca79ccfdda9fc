// A world that is cut into regions, one for each rank: a process, or a machine.
//
// What a cell puts out depends on its 3×3 neighbourhood alone. So a rank that also has the polygons of all cells that
// touch its region, the *halo*, gets the segments of its own cells right, and their links.
// docs/internals/beyond-one-process.md says why.
#pragma once

#include <lgs/lattice.h>

#include <optional>
#include <vector>

namespace regions {

/// The region of each rank. They do not overlap. Together they have all cells that are ever edited.
using Cutting = std::vector<lgs::CellRect>;

inline constexpr int kHalo = 1;  ///< cells around a region

/// Whether a rank with this region needs the polygons of a cell: one of its own, or of its halo.
constexpr bool needs(const lgs::CellRect& region, lgs::Cell c) {
  return c.i >= region.min.i - kHalo && c.i <= region.max.i + kHalo && c.j >= region.min.j - kHalo &&
         c.j <= region.max.j + kHalo;
}

/// Who decides about a cell; nothing if it is in no region. Cost: in proportion to the ranks.
std::optional<int> ownerOf(const Cutting& cutting, lgs::Cell cell);

/// A rectangle in `ranks` pieces of about the same size and not too long. It has at least so many cells on each side.
Cutting cutInto(const lgs::CellRect& cells, int ranks);

}  // namespace regions
