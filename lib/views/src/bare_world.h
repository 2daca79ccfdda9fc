// The ground of a world with a preserve relation once more, in a world without one. The same chunks are unloaded. What
// those hold that were unloaded before it began is not known here, nor what a roll-back made of unloaded ground: they
// count as solid.
#pragma once

#include <lgs/world.h>

#include <set>
#include <vector>

namespace lgs::detail {

class BareWorld {
 public:
  /// Takes over all polygons and commits them.
  explicit BareWorld(const World& world);

  /// Makes what the last commit or roll-back of the followed world changed, and commits it.
  const Changes& follow(const World& world);

  const World& world() const { return world_; }

 private:
  void fillUnknown(const CellRect& chunk);
  void know(const CellRect& chunk);
  void dropForgotten(const World& world, Cell cell);

  World world_;
  std::set<Cell> unknown_;           // lower-left cells of unloaded chunks that count as solid
  std::vector<PlacedPolygon> held_;  // working memory
  std::vector<PolygonHandle> gone_;
  std::vector<NewPolygon> come_;
};

}  // namespace lgs::detail
