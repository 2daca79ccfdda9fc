// What is behind an edge that something touched.
#pragma once

#include <lgs/ids.h>
#include <lgs/lattice.h>

namespace lgs::box2d {

/// A segment of the world, with its owner: "which tile did I hit?"
struct Hit {
  SegmentId segment;      ///< where an edge stands for several, one of them
  PolygonHandle polygon;  ///< its owner
  Block block = 0;        ///< that of `polygon`
  Cell cell;              ///< that of `polygon`
};

}  // namespace lgs::box2d
