#include "addons/box2d/fuzz/body_watch.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace lgs::fuzz {

bool BodyWatch::isFree(b2Vec2 middle) const {
  const Spot spot = world_.at(terrain_.latticePoint(middle));
  return spot.where == Spot::Where::outside || spot.block == kPassable || spot.block == kFiltered;
}

std::vector<b2Body*> BodyWatch::bodies() const {
  std::vector<b2Body*> all;
  for (b2Body* body = physics_.GetBodyList(); body; body = body->GetNext())
    if (body->GetType() == b2_dynamicBody) all.push_back(body);
  return all;
}

std::string BodyWatch::look(const char* after) {
  for (b2Body* const body : bodies()) {
    Watched& watched = watched_[body];
    const bool isDisabled = !body->IsEnabled();
    const auto disabled = terrain_.disabled();
    if (isDisabled && std::ranges::find(disabled, body) == disabled.end())
      return fmt::format("{}, a disabled body is not in disabled()", after);
    const Point at = terrain_.latticePoint(body->GetPosition());
    if (isDisabled && watched.isDisabled &&
        std::hypot(at.x - watched.at.x, at.y - watched.at.y) > kUnitsPerCell / 100.0)
      return fmt::format("{}, a body moved while it was disabled", after);
    std::vector<bool> free;
    for (const b2Fixture* f = body->GetFixtureList(); f; f = f->GetNext()) {
      const b2Shape& shape = *f->GetShape();
      const bool isRound = shape.GetType() == b2Shape::e_circle;
      free.push_back(isFree(body->GetWorldPoint(isRound ? static_cast<const b2CircleShape&>(shape).m_p
                                                        : static_cast<const b2PolygonShape&>(shape).m_centroid)));
    }
    for (std::size_t k = 0; k < free.size(); ++k) {
      const bool wasFree = !watched.isDisabled && k < watched.free.size() && watched.free[k];
      if (!isDisabled && wasFree && !free[k])
        return fmt::format("{}, a body is in the ground at ({}, {})", after, at.x, at.y);
    }
    watched = {std::move(free), isDisabled, at};
  }
  return "";
}

std::string BodyWatch::ask(Point p, Point q, double reach) const {
  if (!terrain_.isCurrent()) return "the terrain is not current";
  const b2Vec2 from = terrain_.position(p), to = terrain_.position(q);
  const auto near = terrain_.nearest(from, static_cast<float>(reach));
  const auto nearest = world_.nearest(terrain_.latticePoint(from), 2);
  if (near.has_value() != bool{nearest->segment} || (near && near->hit.segment != nearest->segment))
    return "nearest() finds another segment than the world's";
  const auto hit = terrain_.rayCast(from, to);
  const auto ray = world_.rayCast(terrain_.latticePoint(from), terrain_.latticePoint(to));
  if (hit.has_value() != bool{ray->segment} || (hit && hit->hit.segment != ray->segment))
    return "rayCast() meets another segment than the world's";
  for (b2Contact* contact = physics_.GetContactList(); contact; contact = contact->GetNext()) {
    const auto touch = terrain_.hit(*contact);
    if (touch && !world_.segment(touch->hit.segment)) return "a contact is with a segment that is not there";
  }
  for (const b2Body* body = physics_.GetBodyList(); body; body = body->GetNext())
    for (const b2Fixture* f = body->GetFixtureList(); f; f = f->GetNext())
      if (terrain_.hit(*f, from).has_value() != (f->GetType() == b2Shape::e_edge)) return "hit() takes another shape";
  World other;
  Changes none;
  none.after = world_.version() + 1;
  if (terrain_.commit(other) || terrain_.sync(none)) return "changes that are not the next ones are shown";
  const std::size_t there = terrain_.bodiesIn(CellRect{{-50, -50}, {50, 50}}).size();
  return there <= bodies().size() ? "" : "bodiesIn() finds too many bodies";
}

}  // namespace lgs::fuzz
