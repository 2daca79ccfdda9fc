// The same ground, given to Box2D in different ways.
#pragma once

#include "oracle/reference/scene.h"

#include <box2d/box2d.h>
#include <lgs/box2d/terrain.h>
#include <lgs/world.h>

#include <memory>
#include <string_view>

namespace lgs::oracle {

enum class Way {
  terrain,   ///< lib/box2d: the engine's segments with their ghosts
  merged,    ///< the same with collinear neighbours merged
  chains,    ///< CGAL's union of the whole scene, each loop a b2ChainShape::CreateLoop
  straight,  ///< the same without the vertices in straight runs: a flat floor is one long edge
  loose,     ///< the engine's segments without ghosts: two-sided edges
  polygons,  ///< a fixture for each polygon of each cell
};
std::string_view name(Way way);

/// Made once; stays where it is while the physics world lives.
class Ground {
 public:
  /// `world` and `scene` hold the same polygons. Of `options` all ways use the cell size, the origin and the material.
  Ground(b2World& physics, const World& world, const Scene& scene, Way way, const box2d::TerrainOptions& options);

  /// The terrain, to be kept up to date; null unless the way is terrain or merged.
  box2d::Terrain* terrain() { return terrain_.get(); }

 private:
  std::unique_ptr<box2d::Terrain> terrain_;
};

}  // namespace lgs::oracle
