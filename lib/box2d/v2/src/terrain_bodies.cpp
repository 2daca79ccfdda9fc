// Bodies in ground that changes: law 13.
#include <lgs/box2d/terrain.h>
#include "footing.h"
#include "new_ground.h"
#include "to_box2d.h"
#include "way_out.h"

#include <algorithm>
#include <unordered_set>

namespace lgs::box2d {

namespace {

/// As b2ContactFilter does.
bool collide(const b2Filter& a, const b2Filter& b) {
  if (a.groupIndex == b.groupIndex && a.groupIndex != 0) return a.groupIndex > 0;
  return (a.maskBits & b.categoryBits) != 0 && (a.categoryBits & b.maskBits) != 0;
}

/// Whether a block keeps out what has this filter.
bool holds(const Material& material, const b2Filter& filter) {
  return !material.isPassable && collide(material.filter, filter);
}

/// By this Box2D judges on which side of an edge a fixture is; nothing for fixtures that edges do not hold.
std::optional<b2Vec2> middleOf(const b2Fixture& fixture) {
  const b2Shape& shape = *fixture.GetShape();
  if (fixture.IsSensor()) return {};
  if (shape.GetType() == b2Shape::e_circle) return static_cast<const b2CircleShape&>(shape).m_p;
  if (shape.GetType() == b2Shape::e_polygon) return static_cast<const b2PolygonShape&>(shape).m_centroid;
  return {};  // edges do not collide with edges
}

bool canBeCaught(const b2Body& body) { return body.GetType() == b2_dynamicBody && body.IsEnabled(); }

std::uint64_t numberOf(const b2Body& body) { return reinterpret_cast<std::uintptr_t>(&body); }

class BodyCollector : public b2QueryCallback {
 public:
  bool ReportFixture(b2Fixture* fixture) override {
    b2Body* const body = fixture->GetBody();
    if (canBeCaught(*body) && !fixture->IsSensor() && known_.insert(body).second) bodies.push_back(body);
    return true;
  }
  std::vector<b2Body*> bodies;

 private:
  std::unordered_set<b2Body*> known_;
};

}  // namespace

std::vector<Form> Terrain::formsOf(const b2Body& body, const b2Transform& at) {
  const auto units = [&](const b2Vec2& local) {
    const b2Vec2 p = b2Mul(at, local);
    return frame_.units(Place{p.x, p.y});
  };
  std::vector<Form> forms;
  for (const b2Fixture* f = body.GetFixtureList(); f != nullptr; f = f->GetNext()) {
    const std::optional<b2Vec2> middle = middleOf(*f);
    if (!middle) continue;
    Form form;
    form.middle = units(*middle);
    if (f->GetType() == b2Shape::e_circle) {
      form.hull = {form.middle};
      form.radius = frame_.units(f->GetShape()->m_radius);
    } else {
      const auto& polygon = static_cast<const b2PolygonShape&>(*f->GetShape());
      for (int32 k = 0; k < polygon.m_count; ++k) form.hull.push_back(units(polygon.m_vertices[k]));
    }
    form.holds = [this, filter = f->GetFilterData()](Block block) { return holds(materials_.of(block), filter); };
    forms.push_back(std::move(form));
  }
  return forms;
}

b2Vec2 Terrain::metres(DoublePoint units) const { return {frame_.metres(units.x), frame_.metres(units.y)}; }

std::vector<b2Body*> Terrain::catchableIn(const Box& box) const {
  BodyCollector near;
  physics_.QueryAABB(&near, {toBox2D(frame_.placeOf(box.min)), toBox2D(frame_.placeOf(box.max))});
  return std::move(near.bodies);
}

std::vector<Caught> Terrain::find(const NewGround& ground) {
  std::vector<Caught> caught;
  if (!ground.box()) return caught;
  for (b2Body* const body : catchableIn(*ground.box())) addIfCaught(body, ground, Whose::free, caught);
  return caught;
}

std::vector<Caught> Terrain::findAll(const NewGround& ground) {
  std::vector<Caught> caught;
  for (b2Body* const body : catchableIn(kEverywhere)) addIfCaught(body, ground, Whose::all, caught);
  return caught;
}

void Terrain::addIfCaught(b2Body* body, const NewGround& ground, Whose whose, std::vector<Caught>& caught) {
  const auto found = catchOf(ground, formsOf(*body, body->GetTransform()), whose, frame_.units(b2_linearSlop));
  if (!found) return;
  Caught one{body, frame_.metres(found->depth), found->way.has_value()};
  if (found->way) one.way = metres(*found->way);
  caught.push_back(one);
}

std::vector<Caught> Terrain::caughtBy(const Changes& changes) {
  if (edges_.misfit(world_, changes)) return {};
  return find(NewGround(world_, edges_, changes));
}

// Those that were held before come first. So who is caught now is not tried twice.
void Terrain::settle(const std::optional<Box>& changed, OnCaught onCaught) {
  if (!held_.empty()) {
    std::unordered_set<const b2Body*> alive;  // the game may have destroyed some
    for (const b2Body* body = physics_.GetBodyList(); body != nullptr; body = body->GetNext()) alive.insert(body);
    std::erase_if(held_, [&](b2Body* body) { return !alive.contains(body) || body->IsEnabled(); });
    std::erase_if(held_, [&](b2Body* body) { return changed && release(*body, *changed); });
  }
  for (const Caught& caught : caught_) {
    b2Body& body = *caught.body;
    if (caught.isFree && onCaught == OnCaught::push) {
      push(body, caught.way);
    } else {
      body.SetLinearVelocity({0, 0});
      body.SetAngularVelocity(0);
      body.SetEnabled(false);
      held_.push_back(&body);
    }
  }
}

bool Terrain::release(b2Body& body, const Box& changed) {
  const std::vector<Form> forms = formsOf(body, body.GetTransform());
  const auto way = releaseOf(world_, forms, changed, frame_.units(b2_linearSlop));
  if (!way) return false;
  body.SetEnabled(true);
  push(body, metres(*way));
  return true;
}

void Terrain::push(b2Body& body, const b2Vec2& way) {
  body.SetTransform(body.GetPosition() + way, body.GetAngle());
  const b2Vec2 velocity = body.GetLinearVelocity();
  const float inward = b2Dot(velocity, way);
  if (inward < 0) body.SetLinearVelocity(velocity - (inward / b2Dot(way, way)) * way);
  body.SetAwake(true);
  note(body);
}

bool Terrain::isFree(const b2Body& body, const b2Transform& at) {
  for (const b2Fixture* f = body.GetFixtureList(); f != nullptr; f = f->GetNext()) {
    const std::optional<b2Vec2> middle = middleOf(*f);
    if (!middle) continue;
    const Spot spot = world_.at(latticePoint(b2Mul(at, *middle)));
    if (spot.where != Spot::Where::outside && holds(materials_.of(spot.block), f->GetFilterData())) return false;
  }
  return true;
}

// Of bodies that are elsewhere since, what was noted says nothing any more.
void Terrain::noteAll() {
  *footings_ = {};
  for (const b2Body* body : catchableIn(kEverywhere))
    if (isFree(*body, body->GetTransform())) note(*body);
}

void Terrain::moved(const b2Body& body) { footings_->forget(numberOf(body)); }

void Terrain::note(const b2Body& body) {
  const b2Transform& at = body.GetTransform();
  footings_->set(numberOf(body), {frame_.units(Place{at.p.x, at.p.y}), at.q.c, at.q.s});
}

const std::vector<b2Body*>& Terrain::afterStep() {
  putBack_.clear();
  Footings before;  // those of this step are noted anew, so that nobody is known who is gone
  std::swap(before, *footings_);
  for (b2Body* body = physics_.GetBodyList(); body != nullptr; body = body->GetNext()) {
    if (!canBeCaught(*body)) continue;
    const std::optional<Footing> last = before.of(numberOf(*body));
    if (last && !body->IsAwake()) {
      footings_->set(numberOf(*body), *last);
    } else if (isFree(*body, body->GetTransform()) && !(last && hasCrossed(*body, *last))) {
      note(*body);
    } else if (last && isFree(*body, transformOf(*last))) {
      putBack(*body, *last);
    }
  }
  return putBack_;
}

bool Terrain::hasCrossed(const b2Body& body, const Footing& last) {
  const b2Vec2 at = body.GetPosition();
  return isFar(last, frame_.units(Place{at.x, at.y})) &&
         box2d::hasCrossed(world_, formsOf(body, transformOf(last)), formsOf(body, body.GetTransform()));
}

b2Transform Terrain::transformOf(const Footing& footing) const {
  b2Transform at;
  at.p = toBox2D(frame_.placeOf(footing.at));
  at.q.c = footing.cosine;
  at.q.s = footing.sine;
  return at;
}

void Terrain::putBack(b2Body& body, const Footing& footing) {
  const b2Transform at = transformOf(footing);
  body.SetTransform(at.p, at.q.GetAngle());
  body.SetLinearVelocity({0, 0});
  body.SetAngularVelocity(0);
  footings_->set(numberOf(body), footing);
  putBack_.push_back(&body);
}

std::vector<b2Body*> Terrain::held() const { return held_; }

bool Terrain::fits(const b2Body& body) { return fits(body, body.GetTransform()); }

bool Terrain::fits(const b2Body& body, const b2Transform& at) {
  const std::vector<Form> forms = formsOf(body, at);
  const NewGround ground(world_);
  return WayOut(ground, forms, frame_.units(b2_linearSlop)).isFree();
}

std::vector<std::vector<Point>> Terrain::outlinesOf(const b2Body* body) {
  std::vector<std::vector<Point>> outlines;
  for (const Form& form : formsOf(*body, body->GetTransform())) outlines.push_back(outlineOf(form));
  return outlines;
}

}  // namespace lgs::box2d
