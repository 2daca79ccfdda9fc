// Which of the segments behind one edge was hit.
#pragma once

#include <lgs/box2d/edges.h>

#include <optional>

namespace lgs::box2d {

/// Of the segments that an edge stands for, the first, or the one nearest to a point of the physics world. Nothing where a
/// commit of which the set does not know yet has removed one of those, or linked them otherwise.
std::optional<Segment> firstSegment(const World& world, const EdgeSet& set, EdgeId id);
std::optional<Segment> nearestSegment(const World& world, const EdgeSet& set, EdgeId id, const Frame& frame,
                                      Metres point);

}  // namespace lgs::box2d
