// What the report says of an outline that was put on the lattice.
#pragma once

#include "collision_object.h"
#include "pixel_grid.h"

#include <lgs/tiled/import.h>

namespace lgs::tiled {

/// Adds the notes on one object that is taken: curves, hidden ones, coordinates on the grid, near misses.
void noteSnapping(const CollisionObject& object, const Snapped& snapped, std::vector<Note>& notes);

/// A number of pixels as the notes write it, with at most two decimals: "1.25 px".
std::string pixels(double value);

}  // namespace lgs::tiled
