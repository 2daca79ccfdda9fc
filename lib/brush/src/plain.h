// The usual cell: it is empty, or one block fills it, and the region's part of it is convex.
#pragma once

#include "cell_edit.h"

#include <optional>

namespace lgs::brush {

/// What a stroke does in such a cell, as arrangedEdit() would find it out. Nothing if the cell is another one, or if
/// rounding bends an edge of the region there: that is left to arrangedEdit(). Cost: O(n²), and n is small.
std::optional<CellEdit> plainEdit(std::span<const PlacedPolygon> polygons, PieceSpan region, const Stroke& stroke);

}  // namespace lgs::brush
