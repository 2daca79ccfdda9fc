// What brushes do, as removes and adds: for whoever knows no brushes.
#pragma once

#include "oracle/trace/trace.h"

#include <lgs/brush.h>
#include <vector>

namespace lgs::oracle {

Region regionOf(const BrushEdit& brush);

/// Makes the edit.
Expected<BrushResult> stroke(World& world, const BrushEdit& brush);

/// The cells that a region may reach: those of its box.
CellRect cellsUnder(const BrushEdit& brush);

/// Whether a region is refused: a vertex lies in no cell, or it is too wide or high.
bool isOutOfReach(const BrushEdit& brush);

/// For each edit of a trace what a brush did there: removes, then adds. Nothing for other edits, and where the brush is
/// refused. The engine makes the edits.
std::vector<std::vector<Edit>> brushedBy(const Trace& trace);

/// The same world by adds and removes alone. What brushes put there has names that are not in the trace. Brushes that
/// are refused are left out.
Trace withoutBrushes(const Trace& trace);

}  // namespace lgs::oracle
