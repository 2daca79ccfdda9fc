// The game of box2d_game.h in Box2D 3.
#include "box2d_3_recipes.h"
#include "box2d_game.h"

#include <array>
#include <cmath>

namespace {

class World3 {
 public:
  World3() {
    b2WorldDef definition = b2DefaultWorldDef();
    definition.gravity = {0, -10};
    id = b2CreateWorld(&definition);
  }
  ~World3() { b2DestroyWorld(id); }
  World3(const World3&) = delete;
  World3& operator=(const World3&) = delete;

  b2WorldId id;
};

class Physics {
 public:
  explicit Physics(const lgs::World& world)
      : terrain_(physics_.id, world, {.cellSize = game::kCellSize, .merge = true, .material = recipes::materialOf}) {
    recipes::makePlatformsOneWay(physics_.id, terrain_);
  }

  void add(lgs::box2d::Place at, int kind) {
    using Real = decltype(lgs::box2d::Position::x);
    b2BodyDef definition = b2DefaultBodyDef();
    definition.type = b2_dynamicBody;
    definition.position = {static_cast<Real>(at.x), static_cast<Real>(at.y)};
    bodies_.push_back(b2CreateBody(physics_.id, &definition));
    b2ShapeDef shape = b2DefaultShapeDef();
    shape.enablePreSolveEvents = true;
    const b2Circle circle{{0, 0}, 0.2F};
    const b2Polygon box = b2MakeBox(kind == 1 ? 0.2F : 0.35F, 0.15F);
    if (kind == 0)
      b2CreateCircleShape(bodies_.back(), &shape, &circle);
    else
      b2CreatePolygonShape(bodies_.back(), &shape, &box);
  }
  void step() { b2World_Step(physics_.id, 1.0F / 60, 4); }
  lgs::box2d::Terrain& terrain() { return terrain_; }
  lgs::box2d::Position placeOf(int k) const { return b2Body_GetPosition(bodies_[static_cast<std::size_t>(k)]); }
  bool isHeld(int k) const { return !b2Body_IsEnabled(bodies_[static_cast<std::size_t>(k)]); }

  void save(const lgs::World& world) {
    saved_ = {};
    static_cast<void>(
        world.save([&](auto bytes) { saved_.world.insert(saved_.world.end(), bytes.begin(), bytes.end()); }));
    for (const b2BodyId body : bodies_) saved_.bodies.emplace_back(body, b2Body_GetTransform(body));
  }
  bool load(lgs::World& world) { return recipes::load(world, terrain_, saved_); }

  /// The bodies as SVG, in metres.
  std::string drawn() const {
    std::string svg;
    for (const b2BodyId body : bodies_) {
      b2ShapeId shape;
      if (b2Body_GetShapes(body, &shape, 1) != 1) continue;
      svg += "<polygon fill=\"#c33\" fill-opacity=\".8\" points=\"";
      const bool isRound = b2Shape_GetType(shape) == b2_circleShape;
      const b2Polygon box = isRound ? b2MakeBox(1, 1) : b2Shape_GetPolygon(shape);
      for (int k = 0; k < (isRound ? 16 : box.count); ++k) {
        const float angle = B2_PI * static_cast<float>(k) / 8;
        const b2Vec2 corner = isRound ? b2Vec2{0.2F * std::cos(angle), 0.2F * std::sin(angle)} : box.vertices[k];
        const auto at = b2Body_GetWorldPoint(body, corner);
        svg += std::to_string(at.x) + "," + std::to_string(at.y) + " ";
      }
      svg += "\"/>\n";
    }
    return svg;
  }

 private:
  World3 physics_;
  lgs::box2d::Terrain terrain_;
  std::vector<b2BodyId> bodies_;
  recipes::Saved saved_;
};

}  // namespace

int main(int count, char** arguments) { return game::run<Physics>(count, arguments); }
