// The boundary of a lgs::World as terrain in a world of Box2D 3.1 or later. Each chunk of cells is a static body, and each segment is
// a chain segment with its ghost vertices. After a commit sync() changes exactly those shapes that the commit changed.
//
//   lgs::box2d::Terrain terrain(physics, world, {.cellSize = 0.5});
//   …
//   world.remove(handle);
//   terrain.sync(world.commit());
//   …
//   if (auto hit = terrain.hit(event.shapeIdA)) dig(hit->cell);
//
// From Box2D 3.2 on the chain segments are loose (b2CreateChainSegmentShape), and a ghost that changes is written in
// place. Before 3.2 each is an open chain of four points, which is made anew when a ghost changes.
//
// Bodies that rest on changed ground wake up, and so do bodies where new ground appears. Nothing else is touched.
//
// No function fails. To be called from one thread at a time, and not during b2World_Step().
#pragma once

#include <box2d/box2d.h>
#include <lgs/box2d/edges.h>
#include <lgs/box2d/hit.h>
#include <lgs/box2d/materials.h>

#include <optional>
#include <vector>

namespace lgs::box2d {

/// A place in the physics world: b2Pos, which is b2Vec2 unless Box2D was built with BOX2D_DOUBLE_PRECISION. Before 3.2
/// Box2D has b2Vec2 alone.
using Position = decltype(b2BodyDef::position);

/// What a block is like. The defaults are Box2D's. The flags are those of b2ShapeDef. Sensor events need
/// theirs on both shapes, the others on one of the two. (In 2.4 listeners hear of every contact without a flag.)
struct Material {
  b2SurfaceMaterial surface = b2DefaultSurfaceMaterial();
  b2Filter filter = b2DefaultFilter();
  bool enableSensorEvents = false;  ///< sensors see the block
  bool enableContactEvents = false;
  bool enableHitEvents = false;
  bool enablePreSolveEvents = false;
  bool enableCustomFiltering = false;  ///< before 3.2 Box2D asks the custom filter about all shapes
  friend bool operator==(const Material& a, const Material& b);
};

using TerrainOptions = BasicTerrainOptions<Material>;

/// A segment in Box2D. Before 3.2 it is part of a chain.
struct SegmentShape {
  b2ShapeId shape = b2_nullShapeId;
  b2ChainId chain = b2_nullChainId;
};

class Terrain {
 public:
  /// Makes the terrain of what the world held at its last commit. Both worlds must outlive it, and `world` must stay
  /// where it is. Cost: O(segments).
  Terrain(b2WorldId physics, const World& world, TerrainOptions options = {});
  ~Terrain();  ///< destroys its bodies
  Terrain(const Terrain&) = delete;
  Terrain(Terrain&&) = delete;
  Terrain& operator=(const Terrain&) = delete;
  Terrain& operator=(Terrain&&) = delete;

  /// Applies a commit. Call it once after each commit, before the next edit. Cost: the number of changes, times the
  /// segments of an edge.
  void sync(const Changes& changes);

  /// What a shape stands for; nothing if it is none of the terrain's. If it stands for several segments, merged or
  /// welded, this is the one nearest to a point of the physics world; without a point, the first one. Between a commit
  /// and its sync(): nothing if the commit changed those segments.
  std::optional<Hit> hit(b2ShapeId shape) const;
  std::optional<Hit> hit(b2ShapeId shape, Position point) const;

  /// The shape that stands for a segment; null if the segment is left out, because it is too short, or is not alive.
  b2ShapeId shape(SegmentId segment) const;

  /// The edges behind the shapes: counts, ends, ghosts. A shape's user data is its EdgeId. The terrain needs it; do not
  /// write there.
  const EdgeSet& edges() const { return edges_; }
  /// The shape of a live edge; null for the null id.
  b2ShapeId shape(EdgeId edge) const { return shapes_[edge.value].shape; }
  std::size_t bodyCount() const { return bodyCount_; }  ///< chunks with at least one shape

  Position position(Point p) const;  ///< where a lattice point is in the physics world
  Cell cellAt(Position p) const;     ///< the cell at a place in the physics world

 private:
  struct Body {
    b2BodyId body = b2_nullBodyId;
    std::size_t shapes = 0;
  };
  EdgeId edgeOf(b2ShapeId shape) const;  // null if it is none of the terrain's
  void apply(const EdgeChanges& changes);
  void create(EdgeId id);
  void destroy(EdgeId id);
  void relink(EdgeId id);
  b2ShapeDef definitionOf(EdgeId id);
  b2ChainSegment segmentOf(EdgeId id) const;
  void wakeAround(EdgeId id);

  b2WorldId physics_;
  const World& world_;
  Frame frame_;
  Materials<Material> materials_;
  EdgeSet edges_;
  std::vector<SegmentShape> shapes_ = std::vector<SegmentShape>(1);  // by EdgeId
  std::vector<Body> bodies_;                                         // by number of the chunk
  std::size_t bodyCount_ = 0;
};

}  // namespace lgs::box2d
