// Which of the segments behind an edge was hit, and which one is nearest to a place.
#pragma once

#include <lgs/box2d/edges.h>
#include <lgs/box2d/hit.h>

#include <optional>

namespace lgs::box2d {

/// The first segment that an edge stands for. Nothing if a commit that the set does not know yet took it away.
std::optional<Hit> firstHit(const World& world, const EdgeSet& set, EdgeId id);

/// The segment nearest to a point of the physics world, among those that an edge stands for and that have its material:
/// a welded edge has that of its first one. Nothing if a commit that
/// the set does not know yet took one of them away or gave it other links. Cost: the segments of the edge.
std::optional<Hit> nearestHit(const World& world, const EdgeSet& set, EdgeId id, const Frame& frame, Place point);

/// The outward unit normal of an edge.
Metres normalOf(const Edge& edge);

/// What Terrain::nearest() finds.
struct NearestOnFrame {
  Hit hit;
  Place point;
  Metres normal;
  float distance = 0;
};

/// The segment of the outline nearest to a point of the physics world, at most `radius` metres away.
std::optional<NearestOnFrame> nearestTo(const World& world, const Frame& frame, Place point, float radius);

/// What Terrain::rayCast() finds.
struct RayOnFrame {
  Hit hit;
  Place point;
  Metres normal;
  float fraction = 1;
};

/// The first segment that a ray of the physics world meets on its outward side.
std::optional<RayOnFrame> rayCast(const World& world, const Frame& frame, Place from, Place to);

}  // namespace lgs::box2d
