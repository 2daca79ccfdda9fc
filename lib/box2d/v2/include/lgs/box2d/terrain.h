// The boundary of a lgs::World as terrain in a Box2D 2.4 world: static bodies, one per chunk of cells, with a one-sided
// edge shape and its ghost vertices for each segment, brought up to date with exactly what each commit changed.
//
//   lgs::box2d::Terrain terrain(physics, world, {.cellSize = 0.5F});
//   …
//   world.remove(handle);
//   terrain.sync(world.commit());
//   …
//   if (auto hit = terrain.hit(*contact->GetFixtureA())) dig(hit->cell);
//
// Bodies that rest on changed ground, or where new ground appears, wake up. Nothing else is touched.
#pragma once

#include <box2d/box2d.h>
#include <lgs/box2d/edges.h>

#include <functional>
#include <optional>
#include <vector>

namespace lgs::box2d {

/// What a block is like. The defaults are Box2D's.
struct Material {
  float friction = 0.2F;
  float restitution = 0;
  float restitutionThreshold = 1.0F * b2_lengthUnitsPerMeter;
  b2Filter filter = {};
};

/// What is out of range is a mistake of the program: an assertion, or undefined behaviour where NDEBUG leaves those out.
struct TerrainOptions {
  double cellSize = 1;  ///< metres; finite, at least 2e-6
  Cell origin =
      {};  ///< the cell whose lower left corner is at (0, 0) of the physics world: choose one where things happen
  std::int32_t chunkCells = 16;  ///< cells along the side of the chunk that is one body, 1 … 4,096; docs/box2d.md
  bool merge = false;            ///< collinear neighbours of equal material in a chunk become one edge
  std::function<Material(Block)> material = {};  ///< asked once for each block. Empty: the defaults for all
};

/// What a fixture stands for.
struct Hit {
  SegmentId segment;
  PolygonHandle polygon;
  Block block = 0;
  Cell cell;
};

class Terrain {
 public:
  /// Makes the terrain of what the world held at its last commit. Both worlds must outlive it and stay where they are.
  Terrain(b2World& physics, const World& world, TerrainOptions options = {});
  ~Terrain();  ///< destroys its bodies
  Terrain(const Terrain&) = delete;
  Terrain(Terrain&&) = delete;
  Terrain& operator=(const Terrain&) = delete;
  Terrain& operator=(Terrain&&) = delete;

  /// Applies a commit: to be called once after each one, before the next edit, not during b2World::Step().
  void sync(const Changes& changes);

  /// What a fixture of the terrain stands for; nothing if it is not one. Where edges are merged or welded, the segment
  /// nearest to a point in the physics world, or the first one. After a commit and before its sync(): nothing where the
  /// commit took such a segment away.
  std::optional<Hit> hit(const b2Fixture& fixture) const;
  std::optional<Hit> hit(const b2Fixture& fixture, const b2Vec2& point) const;

  /// The fixture that stands for a segment; null if it was left out as too short.
  b2Fixture* fixture(SegmentId segment) const;

  /// The edges behind the fixtures: counts, ends, ghosts. A fixture's userData.pointer is its EdgeId; it is the terrain's.
  const EdgeSet& edges() const { return edges_; }
  /// Of a live edge; null for the null id.
  b2Fixture* fixture(EdgeId edge) const { return fixtures_[edge.value]; }
  std::size_t bodyCount() const { return bodyCount_; }  ///< chunks with at least one fixture

  b2Vec2 position(Point p) const;      ///< where a lattice point is in the physics world
  Cell cellAt(const b2Vec2& p) const;  ///< which cell that is

 private:
  struct Chunk {
    b2Body* body = nullptr;
    std::size_t fixtures = 0;
  };
  EdgeId edgeOf(const b2Fixture& fixture) const;  // null if it is none of the terrain's
  void apply(const EdgeChanges& changes);
  void create(EdgeId id);
  void destroy(EdgeId id);
  b2EdgeShape shapeOf(const Edge& edge) const;
  void wakeAround(b2Fixture& fixture);
  std::uint32_t materialNumber(Block block);

  b2World& physics_;
  const World& world_;
  Frame frame_;
  std::function<Material(Block)> materialOf_;
  std::vector<Material> materials_;  // distinct ones
  std::unordered_map<Block, std::uint32_t> materialNumbers_;
  EdgeSet edges_;
  std::vector<b2Fixture*> fixtures_ = {nullptr};  // by EdgeId
  std::vector<Chunk> chunks_;                     // by number
  std::size_t bodyCount_ = 0;
};

}  // namespace lgs::box2d
