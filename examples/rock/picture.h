// The example as an SVG picture: the ground at the end, what was dug, and the rock on its way.
#pragma once

#include <lgs/world.h>

#include <ostream>
#include <vector>

namespace examples {

/// A polygon in cells of the world, and what it is drawn as: a class of the picture's style.
struct Drawn {
  std::vector<lgs::DoublePoint> corners;
  const char* look;
};

/// The polygons of a world, a look for each block.
void drawGround(const lgs::World& world, const char* (*lookOf)(lgs::Block), std::vector<Drawn>& out);

void writePicture(std::ostream& out, const lgs::CellRect& cells, const std::vector<Drawn>& drawn);

}  // namespace examples
