// What is done in Box2D 2.4 in its own way. The rest is the same for both (both/src/).
#include <lgs/box2d/terrain.h>
#include "calls.h"
#include "find_hit.h"
#include "footing.h"

#include <algorithm>
#include <utility>

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

bool operator==(const Material& a, const Material& b) {
  return a.friction == b.friction && a.restitution == b.restitution &&
         a.restitutionThreshold == b.restitutionThreshold && a.filter.categoryBits == b.filter.categoryBits &&
         a.filter.maskBits == b.filter.maskBits && a.filter.groupIndex == b.filter.groupIndex &&
         a.isPassable == b.isPassable;
}

Terrain::Terrain(b2World& physics, const World& world, TerrainOptions options) noexcept
    : TerrainBase(physics, world, std::move(options)) {}

bool Terrain::fits(const b2Body& body, const b2Transform& at) noexcept { return fitsAt(&body, {at.p, at.q, 0}); }

EdgeId TerrainBase::edgeOf(const b2Fixture& fixture) const {
  const std::uintptr_t id = const_cast<b2Fixture&>(fixture).GetUserData().pointer;  // NOLINT: Box2D's is not const
  if (id >= shapes_.size() || shapes_[id] != &fixture) return {};
  return EdgeId{static_cast<std::uint32_t>(id)};
}

// In Box2D an edge is always fixture A: edges touch circles and polygons, and are before both in the order of types.
std::optional<Touch> Terrain::hit(b2Contact& contact) const noexcept {
  const EdgeId id = edgeOf(*contact.GetFixtureA());
  if (!id || !contact.IsTouching()) return {};
  b2Fixture& other = *contact.GetFixtureB();
  const std::optional<Hit> found = hit(*contact.GetFixtureA(), middleOf(contact, other));
  if (!found) return {};
  return Touch{*found, toBox2D(normalOf(edges_.edge(id))), &other};
}

std::vector<b2Body*> TerrainBase::bodiesInRect(const CellRect& cells) const noexcept {
  if (isEmpty(cells)) return {};
  const b2AABB bounds{position(toWorld(cells.min, {})), position(toWorld(cells.max, {kUnitsPerCell, kUnitsPerCell}))};
  b2PolygonShape box;
  box.SetAsBox(bounds.GetExtents().x, bounds.GetExtents().y, bounds.GetCenter(), 0);
  box.m_radius = 0;  // the cells as they are, without a skin
  std::vector<b2Body*> bodies;
  forEachShapeIn(physics_, bounds.lowerBound, {0, 0}, bounds.upperBound - bounds.lowerBound, [&](b2Fixture* fixture) {
    b2Body* const body = fixture->GetBody();
    if (fixture->IsSensor() || edgeOf(*fixture) || std::find(bodies.begin(), bodies.end(), body) != bodies.end())
      return;
    if (overlap(*fixture, box)) bodies.push_back(body);
  });
  return bodies;
}

void TerrainBase::beforeStep() noexcept {
  for (const b2Body* body = physics_.GetBodyList(); body != nullptr; body = body->GetNext()) {
    if (canOverlap(body)) noteIfElsewhere(body);
  }
}

// Box2D does not say who moved.
const std::vector<b2Body*>& TerrainBase::afterStep() noexcept {
  putBack_.clear();
  Footings before;  // those of this step are noted anew, so that nobody is known who is gone
  std::swap(before, *footings_);
  for (b2Body* body = physics_.GetBodyList(); body != nullptr; body = body->GetNext()) {
    if (!canOverlap(body)) continue;
    const std::optional<Footing> last = before.of(numberOf(body));
    if (last && !body->IsAwake()) {
      footings_->set(numberOf(body), *last);
    } else {
      lookAt(body, last);
    }
  }
  return putBack_;
}

}  // namespace lgs::box2d
