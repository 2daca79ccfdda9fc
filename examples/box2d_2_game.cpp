// The game of box2d_game.h in Box2D 2.4.
#include "box2d_2_recipes.h"
#include "box2d_game.h"

#include <algorithm>
#include <cmath>

namespace {

class Physics {
 public:
  explicit Physics(const lgs::World& world)
      : terrain_(physics_, world, {.cellSize = game::kCellSize, .merge = true, .material = recipes::materialOf}),
        ground_(terrain_) {
    physics_.SetContactListener(&ground_);
  }
  ~Physics() { physics_.SetContactListener(nullptr); }  // the terrain's destructor ends contacts
  Physics(const Physics&) = delete;
  Physics& operator=(const Physics&) = delete;

  void add(lgs::box2d::Place at, int kind) {
    b2BodyDef definition;
    definition.type = b2_dynamicBody;
    definition.position = {static_cast<float>(at.x), static_cast<float>(at.y)};
    bodies_.push_back(physics_.CreateBody(&definition));
    b2CircleShape circle;
    circle.m_radius = 0.2F;
    b2PolygonShape box;
    box.SetAsBox(kind == 1 ? 0.2F : 0.35F, 0.15F);
    bodies_.back()->CreateFixture(kind == 0 ? static_cast<b2Shape*>(&circle) : &box, 1);
  }
  void step() { physics_.Step(1.0F / 60, 8, 3); }
  lgs::box2d::Terrain& terrain() { return terrain_; }
  b2Vec2 placeOf(int k) const { return bodies_[static_cast<std::size_t>(k)]->GetPosition(); }
  bool isHeld(int k) const { return !bodies_[static_cast<std::size_t>(k)]->IsEnabled(); }

  void save(const lgs::World& world) {
    saved_ = {};
    static_cast<void>(
        world.save([&](auto bytes) { saved_.world.insert(saved_.world.end(), bytes.begin(), bytes.end()); }));
    for (b2Body* body : bodies_) saved_.bodies.emplace_back(body, body->GetTransform());
  }
  bool load(lgs::World& world) { return recipes::load(world, terrain_, saved_); }

  /// The bodies as SVG, in metres.
  std::string drawn() const {
    std::string svg;
    for (const b2Body* body : bodies_) {
      const b2Shape& shape = *body->GetFixtureList()->GetShape();
      svg += "<polygon fill=\"#c33\" fill-opacity=\".8\" points=\"";
      const bool isRound = shape.GetType() == b2Shape::e_circle;
      const auto& box = static_cast<const b2PolygonShape&>(shape);
      for (int k = 0; k < (isRound ? 16 : box.m_count); ++k) {
        const float angle = b2_pi * static_cast<float>(k) / 8;
        const b2Vec2 corner = isRound ? shape.m_radius * b2Vec2(std::cos(angle), std::sin(angle)) : box.m_vertices[k];
        const b2Vec2 at = body->GetWorldPoint(corner);
        svg += std::to_string(at.x) + "," + std::to_string(at.y) + " ";
      }
      svg += "\"/>\n";
    }
    return svg;
  }

 private:
  b2World physics_{{0, -10}};
  lgs::box2d::Terrain terrain_;
  recipes::Ground ground_;
  std::vector<b2Body*> bodies_;
  recipes::Saved saved_;
};

}  // namespace

int main(int count, char** arguments) { return game::run<Physics>(count, arguments); }
