// Gives the same ground to Box2D in different ways.
#pragma once

#include "oracle/reference/scene.h"

#include <box2d/box2d.h>
#include <lgs/box2d/terrain.h>
#include <lgs/world.h>

#include <memory>
#include <string_view>

namespace lgs::bench {

enum class Way {
  terrain,   ///< as addons/box2d does it: the engine's segments with their ghosts
  merged,    ///< like terrain, but with collinear neighbours merged
  chains,    ///< CGAL's union of the whole scene, each loop by b2ChainShape::CreateLoop
  straight,  ///< like chains, but without the vertices in straight runs: a flat floor is one long edge
  loose,     ///< the engine's segments without ghosts: two-sided edges
  polygons,  ///< a fixture for each polygon of each cell
};
std::string_view name(Way way);

/// The ground in a physics world. It must not outlive that world.
class Ground {
 public:
  /// `world` and `scene` must hold the same polygons. All ways use the cell size, the origin and the material of
  /// `options`.
  Ground(b2World& physics, const World& world, const oracle::Scene& scene, Way way,
         const box2d::TerrainOptions& options);

  /// The terrain, for edits to keep it up to date. Null unless the way is terrain or merged.
  box2d::Terrain* terrain() { return terrain_.get(); }

 private:
  std::unique_ptr<box2d::Terrain> terrain_;
};

}  // namespace lgs::bench
