// Whose each side of each atom is after a brush, and which polygons that makes.
#pragma once

#include "ground.h"

namespace lgs::brush {

/// The polygons of a cell after a stroke.
CellEdit divided(const Ground& ground, const List<Atom>& atoms, const Stroke& stroke);

}  // namespace lgs::brush
