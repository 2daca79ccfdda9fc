// The boundary of a lgs::World as terrain in a Box2D 2.4 world. Each chunk of cells is a static body, and each segment
// is a one-sided edge shape with its ghost vertices. After a commit sync() changes exactly those fixtures that the
// commit changed.
//
//   lgs::box2d::Terrain terrain(physics, world, {.cellSize = 0.5F});
//   …
//   world.remove(handle);
//   terrain.sync(world.commit());
//   …
//   if (auto hit = terrain.hit(*contact->GetFixtureA())) dig(hit->cell);
//
// Bodies that rest on changed ground wake up, and so do bodies where new ground appears. Nothing else is touched.
//
// No function fails. To be called from one thread at a time, and not during b2World::Step().
#pragma once

#include <box2d/box2d.h>
#include <lgs/box2d/edges.h>
#include <lgs/box2d/hit.h>
#include <lgs/box2d/materials.h>

#include <optional>
#include <vector>

namespace lgs::box2d {

/// What a block is like. The defaults are Box2D's.
struct Material {
  float friction = 0.2F;
  float restitution = 0;
  float restitutionThreshold = 1.0F * b2_lengthUnitsPerMeter;
  b2Filter filter = {};
  friend bool operator==(const Material& a, const Material& b);
};

using TerrainOptions = BasicTerrainOptions<Material>;

class Terrain {
 public:
  /// Makes the terrain of what the world held at its last commit. Both worlds must outlive it and stay where they are.
  /// Cost: O(segments).
  Terrain(b2World& physics, const World& world, TerrainOptions options = {});
  ~Terrain();  ///< destroys its bodies
  Terrain(const Terrain&) = delete;
  Terrain(Terrain&&) = delete;
  Terrain& operator=(const Terrain&) = delete;
  Terrain& operator=(Terrain&&) = delete;

  /// Applies a commit. Call it once after each commit, before the next edit. Cost: the number of changes, times the
  /// segments of an edge; and for each fixture that goes the fixtures of its body, because Box2D looks for it there.
  void sync(const Changes& changes);

  /// What a fixture stands for; nothing if it is none of the terrain's. If it stands for several segments, merged or
  /// welded, this is the one nearest to a point of the physics world; without a point, the first one. Between a commit
  /// and its sync(): nothing if the commit changed those segments.
  std::optional<Hit> hit(const b2Fixture& fixture) const;
  std::optional<Hit> hit(const b2Fixture& fixture, const b2Vec2& point) const;

  /// The fixture that stands for a segment; null if the segment is left out, because it is too short, or is not alive.
  b2Fixture* fixture(SegmentId segment) const;

  /// The edges behind the fixtures: counts, ends, ghosts. A fixture's userData.pointer is its EdgeId. The terrain needs
  /// it; do not write there.
  const EdgeSet& edges() const { return edges_; }
  /// The fixture of a live edge; null for the null id.
  b2Fixture* fixture(EdgeId edge) const { return fixtures_[edge.value]; }
  std::size_t bodyCount() const { return bodyCount_; }  ///< chunks with at least one fixture

  b2Vec2 position(Point p) const;      ///< where a lattice point is in the physics world
  Cell cellAt(const b2Vec2& p) const;  ///< the cell at a place in the physics world

 private:
  struct Body {
    b2Body* body = nullptr;
    std::size_t fixtures = 0;
  };
  EdgeId edgeOf(const b2Fixture& fixture) const;  // null if it is none of the terrain's
  void apply(const EdgeChanges& changes);
  void create(EdgeId id);
  void destroy(EdgeId id);
  b2EdgeShape shapeOf(const Edge& edge) const;
  void wakeAround(b2Fixture& fixture);

  b2World& physics_;
  const World& world_;
  Frame frame_;
  Materials<Material> materials_;
  EdgeSet edges_;
  std::vector<b2Fixture*> fixtures_ = {nullptr};  // by EdgeId
  std::vector<Body> bodies_;                      // by number of the chunk
  std::size_t bodyCount_ = 0;
};

}  // namespace lgs::box2d
