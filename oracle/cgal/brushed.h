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

}  // namespace lgs::oracle
