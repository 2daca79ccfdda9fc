// Which of the segments behind one edge was hit.
#pragma once

#include <lgs/box2d/edges.h>

namespace lgs::box2d {

/// Of the segments that an edge stands for, the one nearest to a point of the physics world.
Segment nearestSegment(const World& world, const Edge& edge, const Frame& frame, Metres point);

}  // namespace lgs::box2d
