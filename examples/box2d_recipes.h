// Recipes for the terrain that are the same in Box2D 2.4 and 3: docs/box2d.md says why they are as they are.
#pragma once

#include <lgs/box2d/terrain.h>
#include <lgs/world.h>

namespace recipes {

/// Digs a rectangle. Bodies that rest on it wake up by themselves, and wake what rests on them.
inline bool dig(lgs::World& world, lgs::box2d::Terrain& terrain, const lgs::CellRect& cells) {
  return world.clear(cells) && terrain.commit(world);
}

/// Places a block, but on no body: then nothing has changed. A game that just adds and commits may do so, too: the
/// terrain pushes bodies out of the block.
inline bool placeIfFree(lgs::World& world, lgs::box2d::Terrain& terrain, lgs::Cell cell, lgs::ShapeId shape,
                        lgs::Block block) {
  const lgs::Mark before = world.mark();
  bool isPlaced = false;
  if (world.add(cell, shape, block)) {
    const lgs::Changes& changes = world.commit();
    isPlaced = terrain.overlapsWith(changes).empty() ? terrain.sync(changes).has_value() : !world.rollBack(before);
  }
  return world.forget(before) && isPlaced;
}

/// Rolls back to a mark. Who stands in a hole that is filled is pushed out, or held until it is free again.
inline bool undo(lgs::World& world, lgs::box2d::Terrain& terrain, lgs::Mark mark) {
  return world.rollBack(mark) && terrain.sync(world.changesOfRollBack());
}

}  // namespace recipes
