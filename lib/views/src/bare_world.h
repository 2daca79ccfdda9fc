// The ground of a world once more, without its preserve relation. Either the same chunks are unloaded: what those hold
// that were unloaded before it began is not known here, nor what a roll-back made of unloaded ground, and they count as
// solid. Or all is loaded, and what is unloaded there counts as empty.
#pragma once

#include <lgs/unloaded.h>
#include <lgs/world.h>

#include <set>
#include <span>
#include <vector>

namespace lgs::detail {

class BareWorld {
 public:
  /// Takes over all polygons and commits them.
  BareWorld(const World& world, AtEdge atEdge);

  /// Makes what the last commit or roll-back of the followed world changed, and commits it.
  const Changes& follow(const World& world);

  const World& world() const { return world_; }

 private:
  void become(Cell cell, std::span<const PlacedPolygon> polygons);
  void fillUnknown(const CellRect& chunk);
  void know(const CellRect& chunk);
  void dropForgotten(const World& world, Cell cell);

  World world_;
  bool isOpen_;
  std::set<Cell> unknown_;           // lower-left cells of unloaded chunks that count as solid
  std::vector<PlacedPolygon> held_;  // working memory
  std::vector<PolygonHandle> gone_;
  std::vector<NewPolygon> come_;
};

}  // namespace lgs::detail
