// What a world answers when it is asked about places, against the slow way: all polygons, all segments, exact fractions.
#pragma once

#include "oracle/calls/random.h"

#include "oracle/reference/outline.h"
#include "oracle/reference/scene.h"

#include <lgs/world.h>
#include <span>
#include <string>
#include <vector>

namespace lgs::oracle {

/// All segments of a world. All of its chunks are in memory.
std::vector<Segment> segmentsOf(const World& world);

/// A point in or near the polygons of a world: as a rule one where something happens.
Point somePoint(const World& world, Random& random);

/// What is wrong about World::at(), nearest() or rayCast(); nothing, if all is right. The segments are those of the world,
/// or of all of it where some is not in memory; what is asked for is within reach.
std::string wrongSpot(const World& world, Point p);
std::string wrongNearest(const World& world, std::span<const Segment> segments, Point p, double radius);
std::string wrongRay(const World& world, std::span<const Segment> segments, Point from, Point to);

/// Asks some questions of each kind at random. Chunks may be out of memory: `scene` and `whole` are all polygons, and the
/// outline of these. What would have to look where nothing is in memory says so; all else is as in the whole world.
std::string wrongAnswers(const World& world, const Scene& scene, const Outline& whole, Random& random,
                         std::size_t count);

/// What is wrong about samePolygons(), if anything is: `other` holds the same polygons.
std::string wrongComparison(const World& world, World other);

}  // namespace lgs::oracle
