// What is behind an edge that something touched.
#pragma once

#include <lgs/ids.h>
#include <lgs/lattice.h>

namespace lgs::box2d {

/// A segment of the world, with its owner: "which tile did I hit?"
struct Hit {
  SegmentId segment;
  PolygonHandle polygon;
  Block block = 0;
  Cell cell;
};

}  // namespace lgs::box2d
