#include "addons/box2d/ride/ground.h"

#include "oracle/cgal/cgal_union.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace lgs::bench {
namespace {

using oracle::Scene;
using oracle::ScenePolygon;

class Builder {
 public:
  Builder(b2World& physics, const box2d::TerrainOptions& options)
      : frame_{options.cellSize, options.origin, options.chunkCells}, options_(options) {
    const b2BodyDef definition;
    body_ = physics.CreateBody(&definition);
  }

  void addLoose(const World& world) {
    for (const SegmentId id : world.segments()) {
      const Segment s = *world.segment(id);
      b2EdgeShape edge;
      edge.SetTwoSided(at(s.start), at(s.end));
      add(edge, s.block);
    }
  }

  // The loops carry no blocks, so all get the material of the scene's first one.
  void addChains(const Scene& scene, bool straight) {
    const auto united = oracle::cgalUnion(scene);
    if (!united) throw std::invalid_argument("CGAL can not unite this world: its preserve relation is no partition");
    for (const std::vector<Point>& loop : straight ? oracle::canonical(united->loops) : united->loops)
      addLoop(loop, scene.polygons[0].block);
  }

  void addPolygons(const Scene& scene) {
    for (const ScenePolygon& p : scene.polygons) {
      std::vector<Point> vertices;
      vertices.reserve(p.vertices.size());
      for (const LocalPoint v : p.vertices) vertices.push_back(toWorld(p.cell, v));
      if (isConvex(vertices) && vertices.size() <= b2_maxPolygonVertices) {
        std::vector<b2Vec2> points;
        points.reserve(vertices.size());
        for (const Point v : vertices) points.push_back(at(v));
        b2PolygonShape shape;
        shape.Set(points.data(), static_cast<int32>(points.size()));
        add(shape, p.block);
      } else {
        addLoop(vertices, p.block);
      }
    }
  }

 private:
  b2Vec2 at(Point p) const {
    const box2d::Place m = frame_.position(p);
    return {static_cast<float>(m.x), static_cast<float>(m.y)};
  }

  // Leaves out vertices that are closer than Box2D's slop, because Box2D aborts on them.
  void addLoop(const std::vector<Point>& loop, Block block) {
    std::vector<b2Vec2> points;
    const auto isFar = [](b2Vec2 a, b2Vec2 b) { return b2Distance(a, b) > 1.1F * b2_linearSlop; };
    for (const Point p : loop) {
      if (points.empty() || isFar(points.back(), at(p))) points.push_back(at(p));
    }
    while (points.size() > 1 && !isFar(points.back(), points.front())) points.pop_back();
    if (points.size() < 3) return;
    b2ChainShape chain;
    chain.CreateLoop(points.data(), static_cast<int32>(points.size()));
    add(chain, block);
  }

  static bool isConvex(const std::vector<Point>& v) {
    for (std::size_t k = 0; k < v.size(); ++k) {
      const Point& a = v[k];
      const Point& b = v[(k + 1) % v.size()];
      const Point& c = v[(k + 2) % v.size()];
      if ((b.x - a.x) * (c.y - b.y) < (b.y - a.y) * (c.x - b.x)) return false;
    }
    return true;
  }

  void add(const b2Shape& shape, Block block) {
    const box2d::Material material = options_.material ? options_.material(block) : box2d::Material{};
    b2FixtureDef definition;
    definition.shape = &shape;
    definition.friction = material.friction;
    definition.restitution = material.restitution;
    definition.filter = material.filter;
    body_->CreateFixture(&definition);
  }

  box2d::Frame frame_;
  const box2d::TerrainOptions& options_;
  b2Body* body_;
};

}  // namespace

std::string_view name(Way way) {
  switch (way) {
    case Way::terrain:
      return "terrain";
    case Way::merged:
      return "terrain, merged";
    case Way::chains:
      return "CGAL chains";
    case Way::straight:
      return "CGAL chains, straight runs joined";
    case Way::loose:
      return "edges without ghosts";
    case Way::polygons:
      return "polygons";
  }
  return {};
}

Ground::Ground(b2World& physics, const World& world, const Scene& scene, Way way,
               const box2d::TerrainOptions& options) {
  if (way == Way::terrain || way == Way::merged) {
    box2d::TerrainOptions own = options;
    own.merge = way == Way::merged;
    terrain_ = std::make_unique<box2d::Terrain>(physics, world, own);
    return;
  }
  Builder builder(physics, options);
  if (way == Way::chains || way == Way::straight) builder.addChains(scene, way == Way::straight);
  if (way == Way::loose) builder.addLoose(world);
  if (way == Way::polygons) builder.addPolygons(scene);
}

}  // namespace lgs::bench
