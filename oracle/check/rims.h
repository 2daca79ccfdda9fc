// Law 10 where a stroke cuts the rim of a cell.
#pragma once

#include "oracle/reference/brush_edit.h"
#include "oracle/reference/scene.h"

#include <string>

namespace lgs::oracle {

/// Cells on both sides of a line are cut in the same point: the lattice point of the line next to where an edge of the
/// region crosses it. So each new vertex on a rim is such a point, or other edges meet there. Says which is not.
std::string wrongRim(const BrushEdit& brush, const Scene& before, const Scene& after);

}  // namespace lgs::oracle
