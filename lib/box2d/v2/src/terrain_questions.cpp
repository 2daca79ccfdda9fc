// What the terrain answers: what was hit, what is near, who is there.
#include <lgs/box2d/terrain.h>
#include "find_hit.h"
#include "to_box2d.h"

#include <algorithm>

namespace lgs::box2d {

namespace {

/// The middle of where a contact touches, or else of its second fixture.
b2Vec2 middleOf(b2Contact& contact, const b2Fixture& second) {
  const int32 points = contact.GetManifold()->pointCount;
  if (points == 0) return second.GetAABB(contact.GetChildIndexB()).GetCenter();
  b2WorldManifold manifold;
  contact.GetWorldManifold(&manifold);
  return points == 1 ? manifold.points[0] : 0.5F * (manifold.points[0] + manifold.points[1]);
}

class Collector : public b2QueryCallback {
 public:
  bool ReportFixture(b2Fixture* fixture) override {
    fixtures.push_back(fixture);
    return true;
  }
  std::vector<b2Fixture*> fixtures;
};

bool overlap(const b2Fixture& fixture, const b2PolygonShape& box) {
  const b2Shape& shape = *fixture.GetShape();
  b2Transform here;
  here.SetIdentity();
  for (int32 child = 0; child < shape.GetChildCount(); ++child) {
    if (b2TestOverlap(&shape, child, &box, 0, fixture.GetBody()->GetTransform(), here)) return true;
  }
  return false;
}

}  // namespace

EdgeId Terrain::edgeOf(const b2Fixture& fixture) const {
  const std::uintptr_t id = const_cast<b2Fixture&>(fixture).GetUserData().pointer;  // NOLINT: Box2D's is not const
  if (id >= fixtures_.size() || fixtures_[id] != &fixture) return {};
  return EdgeId{static_cast<std::uint32_t>(id)};
}

std::optional<Hit> Terrain::hit(const b2Fixture& fixture) const {
  const EdgeId id = edgeOf(fixture);
  return id ? firstHit(world_, edges_, id) : std::nullopt;
}

std::optional<Hit> Terrain::hit(const b2Fixture& fixture, const b2Vec2& point) const {
  const EdgeId id = edgeOf(fixture);
  return id ? nearestHit(world_, edges_, id, frame_, {point.x, point.y}) : std::nullopt;
}

// In Box2D an edge is always fixture A: edges touch circles and polygons, and are before both in the order of types.
std::optional<Touch> Terrain::hit(b2Contact& contact) const {
  const EdgeId id = edgeOf(*contact.GetFixtureA());
  if (!id || !contact.IsTouching()) return {};
  b2Fixture& other = *contact.GetFixtureB();
  const std::optional<Hit> found = hit(*contact.GetFixtureA(), middleOf(contact, other));
  if (!found) return {};
  return Touch{*found, toBox2D(normalOf(edges_.edge(id))), &other};
}

std::optional<NearestHit> Terrain::nearest(const b2Vec2& point, float radius) const {
  const auto found = nearestTo(world_, frame_, {point.x, point.y}, radius);
  if (!found) return {};
  return NearestHit{found->hit, toBox2D(found->point), toBox2D(found->normal), found->distance};
}

std::optional<GroundRayHit> Terrain::rayCast(const b2Vec2& from, const b2Vec2& to) const {
  const auto ray = box2d::rayCast(world_, frame_, {from.x, from.y}, {to.x, to.y});
  if (!ray) return {};
  return GroundRayHit{ray->hit, toBox2D(ray->point), toBox2D(ray->normal), ray->fraction};
}

std::vector<b2Body*> Terrain::bodiesInRect(const CellRect& cells) const {
  if (isEmpty(cells)) return {};
  const b2AABB bounds{position(toWorld(cells.min, {})), position(toWorld(cells.max, {kUnitsPerCell, kUnitsPerCell}))};
  b2PolygonShape box;
  box.SetAsBox(bounds.GetExtents().x, bounds.GetExtents().y, bounds.GetCenter(), 0);
  box.m_radius = 0;  // the cells as they are, without a skin
  Collector near;
  physics_.QueryAABB(&near, bounds);
  std::vector<b2Body*> bodies;
  for (b2Fixture* const fixture : near.fixtures) {
    b2Body* const body = fixture->GetBody();
    if (fixture->IsSensor() || edgeOf(*fixture) || std::find(bodies.begin(), bodies.end(), body) != bodies.end())
      continue;
    if (overlap(*fixture, box)) bodies.push_back(body);
  }
  return bodies;
}

}  // namespace lgs::box2d
