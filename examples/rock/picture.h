// The example as an SVG picture: the ground at the end, what was dug, and the rock on its way.
#pragma once

#include <lgs/world.h>

#include <ostream>
#include <string>
#include <vector>

namespace examples {

/// Polygons in cells of the world that are drawn as one, and as what: a class of the picture's style.
struct Drawn {
  std::string look;
  std::vector<std::vector<lgs::DoublePoint>> polygons;
};

/// Puts a polygon to those of its look among the last ones, from `first` on.
void draw(std::vector<Drawn>& out, std::size_t first, const char* look, std::vector<lgs::DoublePoint> polygon);

/// The polygons of a world, a look for each block.
void drawGround(const lgs::World& world, const char* (*lookOf)(lgs::Block), std::vector<Drawn>& out);

void writePicture(std::ostream& out, const lgs::CellRect& cells, const std::vector<Drawn>& drawn);

}  // namespace examples
