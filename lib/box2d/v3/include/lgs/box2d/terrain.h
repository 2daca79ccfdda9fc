// The boundary of a lgs::World as terrain in a Box2D 3 world: static bodies, one per chunk of cells, with a chain segment
// and its ghost vertices for each segment, brought up to date with exactly what each commit changed.
//
//   lgs::box2d::Terrain terrain(physics, world, {.cellSize = 0.5});
//   …
//   world.remove(handle);
//   terrain.sync(world.commit());
//   …
//   if (auto hit = terrain.hit(event.shapeIdA)) dig(hit->cell);
//
// From Box2D 3.2 on the segments are loose ones (b2CreateChainSegmentShape), and a ghost that changes is set in place;
// before, each is an open chain of four points, and made anew. Bodies that rest on changed ground, or where new ground
// appears, wake up. Nothing else is touched.
#pragma once

#include <box2d/box2d.h>
#include <lgs/box2d/edges.h>

#include <functional>
#include <optional>
#include <vector>

namespace lgs::box2d {

/// What a block is like. The defaults are Box2D's.
struct Material {
  b2SurfaceMaterial surface = b2DefaultSurfaceMaterial();
  b2Filter filter = b2DefaultFilter();
};

/// What is out of range is a mistake of the program: an assertion, or undefined behaviour where NDEBUG leaves those out.
struct TerrainOptions {
  double cellSize = 1;                           ///< metres; finite, at least 2e-6
  Cell origin = {};                              ///< the cell whose lower left corner is at (0, 0) of the physics world
  std::int32_t chunkCells = 16;                  ///< cells along the side of the chunk that is one body, 1 … 4,096
  bool merge = false;                            ///< collinear neighbours of equal material in a chunk become one edge
  std::function<Material(Block)> material = {};  ///< asked once for each block. Empty: the defaults for all
};

/// What a shape stands for.
struct Hit {
  SegmentId segment;
  PolygonHandle polygon;
  Block block = 0;
  Cell cell;
};

class Terrain {
 public:
  /// Makes the terrain of what the world held at its last commit. Both worlds must outlive it, and `world` stay in place.
  Terrain(b2WorldId physics, const World& world, TerrainOptions options = {});
  ~Terrain();  ///< destroys its bodies
  Terrain(const Terrain&) = delete;
  Terrain(Terrain&&) = delete;
  Terrain& operator=(const Terrain&) = delete;
  Terrain& operator=(Terrain&&) = delete;

  /// Applies a commit: to be called once after each one, before the next edit, not during b2World_Step().
  void sync(const Changes& changes);

  /// What a shape of the terrain stands for; nothing if it is not one. Where edges are merged or welded, the segment
  /// nearest to a point in the physics world, or the first one. After a commit and before its sync(): nothing where the
  /// commit took such a segment away.
  std::optional<Hit> hit(b2ShapeId shape) const;
  std::optional<Hit> hit(b2ShapeId shape, b2Vec2 point) const;

  /// The shape that stands for a segment; null if it was left out as too short.
  b2ShapeId shape(SegmentId segment) const;

  /// The edges behind the shapes: counts, ends, ghosts. A shape's user data is its EdgeId; it is the terrain's.
  const EdgeSet& edges() const { return edges_; }
  /// Of a live edge; null for the null id.
  b2ShapeId shape(EdgeId edge) const { return shapes_[edge.value].shape; }
  std::size_t bodyCount() const { return bodyCount_; }  ///< chunks with at least one shape

  b2Vec2 position(Point p) const;  ///< where a lattice point is in the physics world
  Cell cellAt(b2Vec2 p) const;     ///< which cell that is

 private:
  struct Body {
    b2BodyId body = b2_nullBodyId;
    std::size_t shapes = 0;
  };
  struct Shape {
    b2ShapeId shape = b2_nullShapeId;
    b2ChainId chain = b2_nullChainId;  // before 3.2: what owns it
  };
  EdgeId edgeOf(b2ShapeId shape) const;  // null if it is none of the terrain's
  void apply(const EdgeChanges& changes);
  void create(EdgeId id);
  void destroy(EdgeId id);
  void make(EdgeId id, b2BodyId body);
  void unmake(EdgeId id);
  void relink(EdgeId id);
  void wakeAround(EdgeId id);
  std::uint32_t materialNumber(Block block);

  b2WorldId physics_;
  const World& world_;
  Frame frame_;
  std::function<Material(Block)> materialOf_;
  std::vector<Material> materials_;  // distinct ones
  std::unordered_map<Block, std::uint32_t> materialNumbers_;
  EdgeSet edges_;
  std::vector<Shape> shapes_ = std::vector<Shape>(1);  // by EdgeId
  std::vector<Body> bodies_;                           // by number of chunk
  std::size_t bodyCount_ = 0;
};

}  // namespace lgs::box2d
