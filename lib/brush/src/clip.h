// What a hole leaves of the ground of a cell where rounding bends nothing.
#pragma once

#include "ground.h"

#include <optional>

namespace lgs::brush {

/// What is left of a cell's groups without a convex part of a region, as an arrangement would find it out. Nothing if
/// the stroke is another one, or if an edge passes the pixel of a vertex or of a crossing that is not its own: then
/// rounding may bend it (docs/internals/brushes.md, "Clipping"). Cost: O(n²), and n is small.
std::optional<CellEdit> clippedEdit(const Ground& ground, PieceSpan region, const Stroke& stroke);

}  // namespace lgs::brush
