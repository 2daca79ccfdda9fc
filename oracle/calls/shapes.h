// Shapes that are apt to break a boundary algorithm, each a set of polygons that may stand in one cell together.
#pragma once

#include "oracle/reference/validity.h"

#include <vector>

namespace lgs::oracle {

struct NamedShape {
  const char* name;
  std::vector<LocalPolygon> polygons;
};

const std::vector<NamedShape>& degenerateShapes();

/// One of the eight symmetries of the cell, 0 to 7; 0 changes nothing. Counter-clockwise stays counter-clockwise.
LocalPolygon turned(const LocalPolygon& polygon, int symmetry);

}  // namespace lgs::oracle
