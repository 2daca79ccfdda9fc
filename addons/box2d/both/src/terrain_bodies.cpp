// Bodies in ground that changes: law 13.
#include <lgs/box2d/terrain_base.h>
#include "calls.h"
#include "footing.h"
#include "new_ground.h"
#include "places.h"
#include "way_out.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_set>
#include <utility>

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

}  // namespace

std::vector<Form> TerrainBase::formsOf(ConstBodyHandle body, const Pose& at) {
  const auto units = [&](b2Vec2 local) { return frame_.units(placed(local, at)); };
  std::vector<Form> forms;
  for (const auto shape : shapesToHold(body)) {
    Form form;
    for (const b2Vec2 corner : hullOf(shape)) form.hull.push_back(units(corner));
    form.radius = frame_.units(radiusOf(shape));
    form.middle = units(middleOf(shape));
    form.holds = [this, filter = filterOf(shape)](Block block) { return holds(materials_.of(block), filter); };
    forms.push_back(std::move(form));
  }
  return forms;
}

b2Vec2 TerrainBase::metres(DoublePoint units) const { return {frame_.metres(units.x), frame_.metres(units.y)}; }

std::vector<BodyHandle> TerrainBase::catchableIn(const Box& box) const {
  std::vector<BodyHandle> bodies;
  std::unordered_set<std::uint64_t> known;
  forEachShapeIn(physics_, toBox2D(frame_.placeOf(box.min)), {0, 0},
                 metres({box.max.x - box.min.x, box.max.y - box.min.y}), [&](ShapeHandle shape) {
                   const BodyHandle body = bodyOf(shape);
                   if (canOverlap(body) && !isSensor(shape) && known.insert(numberOf(body)).second)
                     bodies.push_back(body);
                 });
  return bodies;
}

// Box2D is asked once for each place. A body may be at several of them.
std::vector<BodyHandle> TerrainBase::bodiesAt(std::span<const Box> boxes, std::size_t firstToWake) {
  std::vector<BodyHandle> bodies;
  std::unordered_set<std::uint64_t> known;
  for (const ChangedPlace& place : placesOf(boxes)) {
    const auto first = std::lower_bound(place.boxes.begin(), place.boxes.end(), firstToWake);
    const std::span waking(first, place.boxes.end());
    for (const BodyHandle body : catchableIn(place.box)) {
      if (known.insert(numberOf(body)).second) bodies.push_back(body);
      if (!waking.empty() && reachesOne(body, boxes, waking)) wakeUp(body);
    }
  }
  return bodies;
}

bool TerrainBase::reachesOne(ConstBodyHandle body, std::span<const Box> boxes, std::span<const std::uint32_t> which) {
  std::vector<Box> own;
  for (const Form& form : formsOf(body, box2d::poseOf(body))) own.push_back(boxOf({&form, 1}));
  return std::ranges::any_of(which, [&](std::uint32_t k) {
    return std::ranges::any_of(own, [&](const Box& box) { return overlap(box, boxes[k]); });
  });
}

std::vector<BodyHandle> TerrainBase::wakeAround(const EdgeChanges& changes, std::vector<Box> boxes) {
  if (isAlone()) return {};
  const std::size_t others = boxes.size();
  const double far = frame_.units(wakingDistance());
  const auto add = [&](const std::vector<EdgeId>& ids) {
    for (const EdgeId id : ids) {
      const auto [min, max] = boxOf(edges_.edge(id).start, edges_.edge(id).end);
      boxes.push_back({{min.x - far, min.y - far}, {max.x + far, max.y + far}});
    }
  };
  if (!kDestroyingWakes) add(changes.removed);
  add(changes.added);
  add(changes.turned);
  return bodiesAt(boxes, others);
}

std::vector<Overlap> TerrainBase::find(const std::vector<BodyHandle>& bodies, const NewGround& ground, Whose whose) {
  std::vector<Overlap> overlaps;
  for (const BodyHandle body : bodies) addIfOverlapping(body, ground, whose, overlaps);
  return overlaps;
}

void TerrainBase::addIfOverlapping(BodyHandle body, const NewGround& ground, Whose whose,
                                   std::vector<Overlap>& overlaps) {
  const auto found = catchOf(ground, formsOf(body, box2d::poseOf(body)), whose, frame_.units(slop()));
  if (!found) return;
  Overlap one{body, frame_.metres(found->depth), found->way.has_value()};
  if (found->way) one.displacement = metres(*found->way);
  overlaps.push_back(one);
}

std::vector<Overlap> TerrainBase::overlapsWith(const Changes& changes) noexcept {
  if (edges_.misfit(world_, changes)) return {};
  const NewGround ground(world_, edges_, changes);
  const std::vector<Box> boxes = ground.boxes();
  return find(bodiesAt(boxes, boxes.size()), ground, Whose::free);
}

// Those that were disabled before come first. So a body that overlaps now is not tried twice.
void TerrainBase::settle(const std::optional<Box>& changed, OnOverlap onOverlap) {
  disabled_.eraseIf([&](BodyHandle body) { return isEnabled(body) || (changed && release(body, *changed)); });
  for (const Overlap& overlap : overlaps_) {
    if (overlap.isFree && onOverlap == OnOverlap::push) {
      push(overlap.body, overlap.displacement);
    } else {
      stop(overlap.body);
      setEnabled(overlap.body, false);
      disabled_.add(overlap.body);
    }
  }
}

bool TerrainBase::release(BodyHandle body, const Box& changed) {
  const auto way = releaseOf(world_, formsOf(body, box2d::poseOf(body)), changed, frame_.units(slop()));
  if (!way) return false;
  setEnabled(body, true);
  push(body, metres(*way));
  return true;
}

void TerrainBase::push(BodyHandle body, b2Vec2 way) {
  Pose at = box2d::poseOf(body);
  at.p.x += way.x;
  at.p.y += way.y;
  moveTo(body, freeNear(body, at).value_or(at).p);
  const b2Vec2 velocity = velocityOf(body);
  const float inward = b2Dot(velocity, way);
  if (inward < 0) {
    const float part = inward / b2Dot(way, way);
    setVelocity(body, {velocity.x - part * way.x, velocity.y - part * way.y});
  }
  wakeUp(body);
  note(body);
}

bool TerrainBase::isFree(ConstBodyHandle body, const Pose& at) {
  for (const auto shape : shapesToHold(body)) {
    const Spot spot = world_.at(frame_.latticePoint(placed(middleOf(shape), at)));
    if (spot.where == Spot::Where::outside) continue;
    if (spot.where == Spot::Where::unloaded || holds(materials_.of(spot.block), filterOf(shape))) return false;
  }
  return true;
}

// Places are floats. Where one is rounded, as the origin moved since or as a way ends there, a middle may come onto the
// outline. Then the nearest of the places around is taken that is free.
std::optional<Pose> TerrainBase::freeNear(ConstBodyHandle body, const Pose& at) {
  constexpr int kMostSteps = 3;
  if (isFree(body, at)) return at;
  using Real = decltype(at.p.x);
  const auto most = std::max(std::abs(at.p.x), std::abs(at.p.y));
  const auto rounding = std::nextafter(most, std::numeric_limits<Real>::max()) - most;
  const auto unit = std::max(rounding, static_cast<Real>(frame_.cellSize / kUnitsPerCell));
  for (int far = 1; far <= kMostSteps; ++far) {
    for (int x = -far; x <= far; ++x) {
      for (int y = -far; y <= far; ++y) {
        if (std::abs(x) != far && std::abs(y) != far) continue;
        Pose near = at;
        near.p.x += static_cast<Real>(x) * unit;
        near.p.y += static_cast<Real>(y) * unit;
        if (isFree(body, near)) return near;
      }
    }
  }
  return std::nullopt;
}

// Of bodies that are elsewhere since, what was noted says nothing any more.
void TerrainBase::noteAll() {
  *footings_ = {};
  for (const BodyHandle body : catchableIn(kEverywhere))
    if (isFree(body, box2d::poseOf(body))) note(body);
}

void TerrainBase::moved(BodyArgument body) noexcept {
  const ConstBodyHandle handle = handleOf(body);
  footings_->forget(numberOf(handle));
  if (isFree(handle, box2d::poseOf(handle))) note(handle);
}

// Who is in the ground comes back to where it was free; unless another body was noted there.
void TerrainBase::noteIfElsewhere(ConstBodyHandle body) {
  const std::optional<Footing> last = footings_->of(numberOf(body));
  const Footing now = footingOf(body);
  if (last && *last == now) return;
  if (isFree(body, box2d::poseOf(body))) {
    footings_->set(numberOf(body), now);
  } else if (last && distance(last->at, now.at) > frame_.units(surelyTheSameWithin())) {
    footings_->forget(numberOf(body));
  }
}

void TerrainBase::note(ConstBodyHandle body) { footings_->set(numberOf(body), footingOf(body)); }

Footing TerrainBase::footingOf(ConstBodyHandle body) const {
  const Pose at = box2d::poseOf(body);
  return {frame_.units(Place{at.p.x, at.p.y}), at.q.c, at.q.s};
}

// One that moved in the step, and where it was free before.
void TerrainBase::lookAt(BodyHandle body, const std::optional<Footing>& last) {
  if (isFree(body, box2d::poseOf(body)) && !(last && hasCrossed(body, *last))) {
    note(body);
  } else if (last && returnTo(body, *last)) {
    stop(body);
    putBack_.push_back(body);
  }
}

bool TerrainBase::returnTo(BodyHandle body, const Footing& last) {
  const std::optional<Pose> free = freeNear(body, poseOf(last));
  if (!free) return false;
  setPose(body, *free);
  footings_->set(numberOf(body), last);
  return true;
}

// The game has moved bodies to other floats. One that is not near to where it was free is not moved yet.
void TerrainBase::afterRounding() {
  for (const BodyHandle body : catchableIn(kEverywhere)) {
    const Pose at = box2d::poseOf(body);
    const std::optional<Footing> last = footings_->of(numberOf(body));
    if (last && !isFar(*last, frame_.units(Place{at.p.x, at.p.y})) && !isFree(body, at)) returnTo(body, *last);
  }
}

bool TerrainBase::hasCrossed(ConstBodyHandle body, const Footing& last) {
  const Pose at = box2d::poseOf(body);
  return isFar(last, frame_.units(Place{at.p.x, at.p.y})) &&
         box2d::hasCrossed(world_, formsOf(body, poseOf(last)), formsOf(body, at));
}

Pose TerrainBase::poseOf(const Footing& footing) const {
  b2Rot rotation;
  rotation.c = footing.cosine;
  rotation.s = footing.sine;
  return settled(toBox2D(frame_.placeOf(footing.at)), rotation);
}

bool TerrainBase::fits(BodyArgument body) noexcept { return fitsAt(handleOf(body), box2d::poseOf(handleOf(body))); }

bool TerrainBase::fitsAt(ConstBodyHandle body, const Pose& at) {
  const std::vector<Form> forms = formsOf(body, at);
  const NewGround ground(world_);
  return WayOut(ground, forms, frame_.units(slop())).isFree();
}

std::vector<std::vector<Point>> TerrainBase::outlinesOf(ConstBodyHandle body) noexcept {
  std::vector<std::vector<Point>> outlines;
  for (const Form& form : formsOf(body, box2d::poseOf(body))) outlines.push_back(outlineOf(form));
  return outlines;
}

}  // namespace lgs::box2d
