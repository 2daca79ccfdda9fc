// Bodies in ground that changes: law 13.
#include <lgs/box2d/terrain.h>
#include "footing.h"
#include "new_ground.h"
#include "segment_shape.h"
#include "to_box2d.h"
#include "way_out.h"

#include <algorithm>
#include <unordered_set>

namespace lgs::box2d {

namespace {

/// As Box2D does.
bool collide(const b2Filter& a, const b2Filter& b) {
  if (a.groupIndex == b.groupIndex && a.groupIndex != 0) return a.groupIndex > 0;
  return (a.maskBits & b.categoryBits) != 0 && (a.categoryBits & b.maskBits) != 0;
}

/// Whether a block keeps out what has this filter.
bool holds(const Material& material, const b2Filter& filter) {
  return !material.isPassable && collide(material.filter, filter);
}

/// A shape in its body; by its middle Box2D judges on which side of an edge it is.
struct Outline {
  std::vector<b2Vec2> hull;
  float radius = 0;
  b2Vec2 middle{};
};

/// Nothing for shapes that edges do not hold.
std::optional<Outline> outlineOf(b2ShapeId shape) {
  if (b2Shape_IsSensor(shape)) return {};
  switch (b2Shape_GetType(shape)) {
    case b2_circleShape: {
      const b2Circle circle = b2Shape_GetCircle(shape);
      return Outline{{circle.center}, circle.radius, circle.center};
    }
    case b2_capsuleShape: {
      const b2Capsule capsule = b2Shape_GetCapsule(shape);
      return Outline{
          {capsule.center1, capsule.center2}, capsule.radius, b2Lerp(capsule.center1, capsule.center2, 0.5F)};
    }
    case b2_polygonShape: {
      const b2Polygon polygon = b2Shape_GetPolygon(shape);
      return Outline{{polygon.vertices, polygon.vertices + polygon.count}, polygon.radius, polygon.centroid};
    }
    default:
      return {};
  }
}

std::vector<b2ShapeId> shapesOf(b2BodyId body) {
  std::vector<b2ShapeId> shapes(static_cast<std::size_t>(b2Body_GetShapeCount(body)));
  b2Body_GetShapes(body, shapes.data(), static_cast<int>(shapes.size()));
  return shapes;
}

bool canBeCaught(b2BodyId body) { return b2Body_GetType(body) == b2_dynamicBody && b2Body_IsEnabled(body); }

struct Collected {
  std::vector<b2BodyId> bodies;
  std::unordered_set<std::uint64_t> known;
};

bool collectBody(b2ShapeId shape, void* context) {
  auto& collected = *static_cast<Collected*>(context);
  const b2BodyId body = b2Shape_GetBody(shape);
  if (canBeCaught(body) && !b2Shape_IsSensor(shape) && collected.known.insert(b2StoreBodyId(body)).second)
    collected.bodies.push_back(body);
  return true;
}

/// Where a point of a body is when the body is at a place.
Place placed(b2Vec2 local, Position at, b2Rot rotation) {
  const b2Vec2 turned = b2RotateVector(rotation, local);
  return {at.x + double{turned.x}, at.y + double{turned.y}};
}

}  // namespace

std::vector<Form> Terrain::formsOf(b2BodyId body, Position at, b2Rot rotation) {
  const auto units = [&](b2Vec2 local) { return frame_.units(placed(local, at, rotation)); };
  std::vector<Form> forms;
  for (const b2ShapeId shape : shapesOf(body)) {
    const std::optional<Outline> outline = outlineOf(shape);
    if (!outline) continue;
    Form form;
    for (const b2Vec2 corner : outline->hull) form.hull.push_back(units(corner));
    form.radius = frame_.units(outline->radius);
    form.middle = units(outline->middle);
    form.holds = [this, filter = b2Shape_GetFilter(shape)](Block block) { return holds(materials_.of(block), filter); };
    forms.push_back(std::move(form));
  }
  return forms;
}

b2Vec2 Terrain::metres(DoublePoint units) const { return {frame_.metres(units.x), frame_.metres(units.y)}; }

std::vector<b2BodyId> Terrain::catchableIn(const Box& box) const {
  b2QueryFilter all = b2DefaultQueryFilter();
  all.categoryBits = UINT64_MAX;
  all.maskBits = UINT64_MAX;
  Collected near;
  forEachShapeIn(physics_, toBox2D(frame_.placeOf(box.min)),
                 {{0, 0}, metres({box.max.x - box.min.x, box.max.y - box.min.y})}, all, collectBody, &near);
  return std::move(near.bodies);
}

std::vector<Caught> Terrain::find(const NewGround& ground) {
  std::vector<Caught> caught;
  if (!ground.box()) return caught;
  for (const b2BodyId body : catchableIn(*ground.box())) addIfCaught(body, ground, Whose::free, caught);
  return caught;
}

std::vector<Caught> Terrain::findAll(const NewGround& ground) {
  std::vector<Caught> caught;
  for (const b2BodyId body : catchableIn(kEverywhere)) addIfCaught(body, ground, Whose::all, caught);
  return caught;
}

void Terrain::addIfCaught(b2BodyId body, const NewGround& ground, Whose whose, std::vector<Caught>& caught) {
  const auto forms = formsOf(body, b2Body_GetPosition(body), b2Body_GetRotation(body));
  const auto found = catchOf(ground, forms, whose, frame_.units(slop()));
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
  std::erase_if(held_, [&](b2BodyId body) {
    return !b2Body_IsValid(body) || b2Body_IsEnabled(body) || (changed && release(body, *changed));
  });
  for (const Caught& caught : caught_) {
    if (caught.isFree && onCaught == OnCaught::push) {
      push(caught.body, caught.way);
    } else {
      b2Body_SetLinearVelocity(caught.body, {0, 0});
      b2Body_SetAngularVelocity(caught.body, 0);
      b2Body_Disable(caught.body);
      held_.push_back(caught.body);
    }
  }
}

bool Terrain::release(b2BodyId body, const Box& changed) {
  const std::vector<Form> forms = formsOf(body, b2Body_GetPosition(body), b2Body_GetRotation(body));
  const auto way = releaseOf(world_, forms, changed, frame_.units(slop()));
  if (!way) return false;
  b2Body_Enable(body);
  push(body, metres(*way));
  return true;
}

void Terrain::push(b2BodyId body, b2Vec2 way) {
  Position at = b2Body_GetPosition(body);
  at.x += way.x;
  at.y += way.y;
  b2Body_SetTransform(body, at, b2Body_GetRotation(body));
  const b2Vec2 velocity = b2Body_GetLinearVelocity(body);
  const float inward = b2Dot(velocity, way);
  if (inward < 0) b2Body_SetLinearVelocity(body, b2MulSub(velocity, inward / b2Dot(way, way), way));
  b2Body_SetAwake(body, true);
  note(body);
}

bool Terrain::isFree(b2BodyId body, Position at, b2Rot rotation) {
  for (const b2ShapeId shape : shapesOf(body)) {
    const std::optional<Outline> outline = outlineOf(shape);
    if (!outline) continue;
    const Spot spot = world_.at(frame_.latticePoint(placed(outline->middle, at, rotation)));
    if (spot.where != Spot::Where::outside && holds(materials_.of(spot.block), b2Shape_GetFilter(shape))) return false;
  }
  return true;
}

// Of bodies that are elsewhere since, what was noted says nothing any more.
void Terrain::noteAll() {
  *footings_ = {};
  for (const b2BodyId body : catchableIn(kEverywhere))
    if (isFree(body, b2Body_GetPosition(body), b2Body_GetRotation(body))) note(body);
}

void Terrain::moved(b2BodyId body) { footings_->forget(b2StoreBodyId(body)); }

void Terrain::note(b2BodyId body) {
  const Position at = b2Body_GetPosition(body);
  const b2Rot rotation = b2Body_GetRotation(body);
  footings_->set(b2StoreBodyId(body), {frame_.units(Place{at.x, at.y}), rotation.c, rotation.s});
}

bool Terrain::hasCrossed(b2BodyId body, const Footing& last) {
  const Position at = b2Body_GetPosition(body);
  if (!isFar(last, frame_.units(Place{at.x, at.y}))) return false;
  const Position from = toBox2D(frame_.placeOf(last.at));
  return box2d::hasCrossed(world_, formsOf(body, from, {last.cosine, last.sine}),
                           formsOf(body, at, b2Body_GetRotation(body)));
}

const std::vector<b2BodyId>& Terrain::afterStep() {
  putBack_.clear();
  const b2BodyEvents events = b2World_GetBodyEvents(physics_);
  for (int k = 0; k < events.moveCount; ++k) {
    const b2BodyId body = events.moveEvents[k].bodyId;
    if (!b2Body_IsValid(body) || !canBeCaught(body)) continue;
    const std::optional<Footing> last = footings_->of(b2StoreBodyId(body));
    if (isFree(body, b2Body_GetPosition(body), b2Body_GetRotation(body)) && !(last && hasCrossed(body, *last))) {
      note(body);
      continue;
    }
    if (!last) continue;
    const Position at = toBox2D(frame_.placeOf(last->at));
    const b2Rot rotation{last->cosine, last->sine};
    if (!isFree(body, at, rotation)) continue;
    b2Body_SetTransform(body, at, rotation);
    b2Body_SetLinearVelocity(body, {0, 0});
    b2Body_SetAngularVelocity(body, 0);
    putBack_.push_back(body);
  }
  const auto bodies = static_cast<std::size_t>(b2World_GetCounters(physics_).bodyCount);
  footings_->prune(2 * bodies + 64, [](std::uint64_t body) { return b2Body_IsValid(b2LoadBodyId(body)); });
  return putBack_;
}

std::vector<b2BodyId> Terrain::held() const { return held_; }

bool Terrain::fits(b2BodyId body) { return fits(body, b2Body_GetPosition(body), b2Body_GetRotation(body)); }

bool Terrain::fits(b2BodyId body, Position at, b2Rot rotation) {
  const std::vector<Form> forms = formsOf(body, at, rotation);
  const NewGround ground(world_);
  return WayOut(ground, forms, frame_.units(slop())).isFree();
}

std::vector<std::vector<Point>> Terrain::outlinesOf(b2BodyId body) {
  std::vector<std::vector<Point>> outlines;
  for (const Form& form : formsOf(body, b2Body_GetPosition(body), b2Body_GetRotation(body)))
    outlines.push_back(outlineOf(form));
  return outlines;
}

}  // namespace lgs::box2d
