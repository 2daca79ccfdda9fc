// No body is moved and nothing is refused: bodies are cut out of new ground. Link LocalGridSeg::brush as well.
//
//   paint(world, region, 7, lgs::PaintMode::fill);
//   cutOut(terrain, world, world.commit());
//   …
//   world.rollBack(mark);
//   cutOut(terrain, world, world.changesOfRollBack());
//
// What is painted can also go around bodies from the first:
//
//   if (const auto room = withoutBodies(terrain, region)) paint(world, *room, 7, lgs::PaintMode::fill);
//   terrain.commit(world);
#pragma once

#include <lgs/box2d/bodies_in.h>
#include <lgs/box2d/terrain.h>
#include <lgs/brush.h>

#include <utility>

namespace lgs::box2d {

/// Shows the last changes of a world, as sync() does. But a body that they overlap stays where it is: its outline is
/// carved out of the ground, and that is committed and shown as well. If a brush is refused somewhere, because a cell
/// is full to its limits, the terrain treats bodies by its options. Errors as of sync().
inline tl::expected<void, SyncError> cutOut(Terrain& terrain, World& world, const Changes& changes) noexcept {
  bool isCut = true;
  for (const Overlap& overlap : terrain.overlapsWith(changes)) {
    for (const Ring& outline : terrain.outlinesOf(overlap.body))
      isCut = carve(world, Region{{outline}}).has_value() && isCut;
  }
  const auto done = isCut ? terrain.sync(changes, OnOverlap::leave) : terrain.sync(changes);
  return done ? terrain.sync(world.commit()) : done;
}

/// A region but for the outlines of the bodies in it. Refused: as by without().
inline Expected<Region> withoutBodies(Terrain& terrain, const Region& region) noexcept {
  Region bodies;
  for (const auto& body : bodiesIn(terrain, region))
    for (Ring& outline : terrain.outlinesOf(body)) bodies.rings.push_back(std::move(outline));
  return bodies.rings.empty() ? region : without(region, bodies);
}

}  // namespace lgs::box2d
