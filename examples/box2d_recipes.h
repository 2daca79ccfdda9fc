// Recipes for the terrain that are the same in Box2D 2.4 and 3: docs/box2d.md says why they are as they are.
#pragma once

#include <lgs/box2d/terrain.h>
#include <lgs/world.h>

#include <vector>

namespace recipes {

/// Digs a rectangle. Bodies that rest on it wake up by themselves, and wake what rests on them.
inline bool dig(lgs::World& world, lgs::box2d::Terrain& terrain, const lgs::CellRect& cells) {
  return world.clear(cells) && terrain.commit(world);
}

/// A step that can be undone: how the world was before it, and all cells that were edited since.
struct Step {
  lgs::Mark before;
  std::vector<lgs::CellRect> edited;
};

/// Undoes a step if no body is where it was edited: what was dug there comes back, and a body in it would fall through
/// the ground. A game may rather wait, or lift the bodies.
inline bool undo(lgs::World& world, lgs::box2d::Terrain& terrain, const Step& step) {
  for (const lgs::CellRect& cells : step.edited)
    if (!terrain.bodiesIn(cells).empty()) return false;
  return world.rollBack(step.before) && terrain.sync(world.changesOfRollBack());
}

}  // namespace recipes
