// Whose each side of each atom is after a brush, and which polygons that makes.
#pragma once

#include "atoms.h"
#include "cell_edit.h"

#include <vector>

namespace lgs::brush {

/// The polygons of a cell after a stroke. `reached` says which ones the atoms are of: their numbers there are their
/// indices plus 1.
CellEdit divided(const std::vector<CellPolygon>& polygons, const std::vector<bool>& reached,
                 const std::vector<Atom>& atoms, const Stroke& stroke);

}  // namespace lgs::brush
