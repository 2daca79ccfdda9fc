// Which of the segments behind an edge was hit.
#pragma once

#include <lgs/box2d/edges.h>
#include <lgs/box2d/hit.h>

#include <optional>

namespace lgs::box2d {

/// The first segment that an edge stands for. Nothing if a commit that the set does not know yet took it away.
std::optional<Hit> firstHit(const World& world, const EdgeSet& set, EdgeId id);

/// The segment nearest to a point of the physics world, among those that an edge stands for. Nothing if a commit that
/// the set does not know yet took one of them away or gave it other links. Cost: the segments of the edge.
std::optional<Hit> nearestHit(const World& world, const EdgeSet& set, EdgeId id, const Frame& frame, Place point);

}  // namespace lgs::box2d
