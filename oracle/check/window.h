// Checking the surroundings of an edit instead of the whole world.
//
// Let `cells` be some cells. The segments that belong to them, with their ends, blocks and ghosts, depend on no polygon
// further than one cell away:
//  - a segment's cuts and cancelling depend on its own cell and those that touch it;
//  - its links depend on the segments that meet at its ends. An end lies in its cell or on the rim of it, so what meets
//    there, and what cancels that, belongs to cells that touch its own;
//  - its ghosts are the far ends of those segments. A far end depends on the cell of its segment or, on a rim, on the
//    two cells beside the rim. All of these touch the common vertex.
// So a reference that is given the polygons within one cell of `cells`, and no others, must agree with the engine on
// the segments of `cells`.
#pragma once

#include "oracle/reference/outline.h"
#include "oracle/reference/scene.h"
#include "oracle/trace/standing.h"

#include <set>

namespace lgs::oracle {

using CellSet = std::set<Cell>;

/// The cells that touch these, and these.
CellSet around(const CellSet& cells);

/// The polygons of these cells.
Scene sceneOf(const Standing& standing, const PreservePairs& preserve, const CellSet& cells);

/// The same for a rectangle, without the relation.
Scene sceneOf(const Standing& standing, const CellRect& cells);

/// The cell whose polygon a segment belongs to: the one on the left of it.
Cell cellOf(const OutlineSegment& segment);

/// The segments that belong to these cells.
void keepOnly(Outline& outline, const CellSet& cells);

}  // namespace lgs::oracle
