// The oracle of brushes: CGAL's Boolean set operations, with exact numbers, and how far a world is from their result.
#pragma once

#include "oracle/reference/brush_edit.h"
#include "oracle/reference/scene.h"

#include <optional>
#include <string>

namespace lgs::oracle {

/// Law 8: says where the polygons after an edit differ from the exact result in a point that is farther than one
/// lattice unit from every edge of that result. Each block is compared by itself, with the edges of all blocks; and
/// the solid as a whole, with the edges of the solid alone: a seam between two blocks would be far from those (law 10).
std::optional<std::string> farFromExact(const Scene& before, const BrushEdit& edit, const Scene& after);

/// Law 10: ground of one block from which a region was carved, and which was then filled with the same region. Says
/// where that has left a seam, farther than two units (one for each stroke) from every edge of the ground of that block.
/// Nothing, if the region is not all in it. The scenes are as before the first stroke and after the second one.
std::optional<std::string> seamIn(const Scene& before, const BrushEdit& filled, const Scene& after);

}  // namespace lgs::oracle
