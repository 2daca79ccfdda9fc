// Cells in which the region, rounded by itself, crosses nothing.
#pragma once

#include "arrangement.h"
#include "atoms.h"

#include <optional>

namespace lgs::brush {

/// The atoms of a cell, if it is calm (docs/internals/brushes.md, "Coming back"): the region's edges go through the
/// known points, and no outline bends. Nothing if it is not. Cost: O(n²).
std::optional<List<Atom>> calmAtoms(const Ground& ground, PieceSpan region, const Stroke& stroke);

}  // namespace lgs::brush
