#include "new_ground.h"

#include "geometry/sort.h"

#include <algorithm>
#include <cmath>

namespace lgs::box2d {

namespace {

constexpr double kDeep = 0.5;  // of the core

Point rounded(DoublePoint p) { return latticePoint({p.x / kUnitsPerCell, p.y / kUnitsPerCell}); }

/// What a line adds to the winding number of a point: 1 or -1, if the ray from there to the right meets it.
int windingOf(const Line& line, Point p) {
  const auto& [a, b] = line;
  const bool isUp = a.y <= p.y && p.y < b.y;
  const bool isDown = b.y <= p.y && p.y < a.y;
  if ((!isUp && !isDown) || p.x >= std::max(a.x, b.x)) return 0;
  if (p.x >= std::min(a.x, b.x)) {  // a segment is within a cell, so these are small numbers
    const std::int64_t side = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    if (isUp ? side <= 0 : side >= 0) return 0;
  }
  return isUp ? 1 : -1;
}

/// Clockwise, by so many quarters.
Point turned(Point p, int quarters) {
  for (; quarters > 0; --quarters) p = {p.y, -p.x};
  return p;
}

bool isBeside(const Line& line, const Box& box) { return !overlap(boxOf(line.start, line.end), box); }

Cell cellOf(DoublePoint p) {
  const auto index = [](double units) {
    const double cell = std::floor(units / kUnitsPerCell);
    return static_cast<std::int32_t>(std::clamp(cell, -double{kMaxCell}, double{kMaxCell}));
  };
  return {index(p.x), index(p.y)};
}

}  // namespace

NewGround::NewGround(const World& world, const EdgeSet& before, const Changes& changes) : world_(world) {
  for (const SegmentId id : changes.removed) add(went_, {*before.lineOf(id)});
  for (const SegmentId id : changes.added) {
    const Segment s = *world.segment(id);
    add(came_, {{s.start, s.end}, s.block});
  }
  cameIds_ = changes.added;
  detail::sort(cameIds_);
}

NewGround::NewGround(const World& world, const EdgeSet& before) : world_(world) {
  for (std::uint32_t k = 1; k <= std::max(before.maxSegmentId(), world.maxSegmentId()); ++k) {
    const std::optional<Line> line = before.lineOf({k});
    const Expected<Segment> s = world.segment(SegmentId{k});
    if (line && s && *line == Line{s->start, s->end}) continue;
    if (line) add(went_, {*line});
    if (!s) continue;
    add(came_, {{s->start, s->end}, s->block});
    cameIds_.push_back({k});
  }
}

void NewGround::add(std::vector<Piece>& list, const Piece& piece) {
  list.push_back(piece);
  const Box box = boxOf(piece.line.start, piece.line.end);
  box_ = box_ ? around(*box_, box) : box;
}

std::vector<Box> NewGround::boxes() const {
  std::vector<Box> boxes;
  for (const auto* list : {&went_, &came_})
    for (const Piece& piece : *list) boxes.push_back(boxOf(piece.line.start, piece.line.end));
  return boxes;
}

/// Whether a ray, by so many quarters from the right counter-clockwise, is in memory until it is beyond all that changed.
bool NewGround::isKnown(Point p, int quarters) const {
  const Cell cell = cellAt(p), min = cellOf({box_->min.x - 1, box_->min.y - 1}),
             max = cellOf({box_->max.x + 1, box_->max.y + 1});
  CellRect way{cell, cell};
  if (quarters == 0) way.max.i = std::max(max.i, cell.i);
  if (quarters == 1) way.max.j = std::max(max.j, cell.j);
  if (quarters == 2) way.min.i = std::min(min.i, cell.i);
  if (quarters == 3) way.min.j = std::min(min.j, cell.j);
  return !world_.firstUnloaded(way);
}

// At the edge of memory the outline is open, and what is there is not told. So the ray is one that does not come there.
// What leaves memory itself is told. Nothing, if there is no such ray.
std::optional<int> NewGround::becameSolid(Point p) const {
  const bool leaves = world_.at(p).where == Spot::Where::unloaded;
  for (int quarters = 0; quarters < 4; ++quarters) {
    if (!leaves && !isKnown(p, quarters)) continue;
    const auto windingIn = [&](const std::vector<Piece>& pieces) {
      int winding = 0;
      for (const auto& [line, block] : pieces)
        winding += windingOf({turned(line.start, quarters), turned(line.end, quarters)}, turned(p, quarters));
      return winding;
    };
    return windingIn(came_) - windingIn(went_);
  }
  return std::nullopt;
}

// What is not in memory has no block: it counts as ground for every body.
bool NewGround::isSolid(const Form& form, DoublePoint p) const {
  const Spot spot = world_.at(rounded(p));
  if (spot.where == Spot::Where::unloaded) return true;
  return spot.where != Spot::Where::outside && form.holds(spot.block);
}

bool NewGround::isFree(const Form& form) const { return !isSolid(form, form.middle); }

// On an edge it is not told from the winding number on which side a point is. So the points around it are asked.
bool NewGround::wasFree(const Form& form) const {
  if (!box_) return isFree(form);
  const Point middle = rounded(form.middle);
  const auto wasFreeAt = [&](Point p) {
    const Spot spot = world_.at(p);
    if (spot.where == Spot::Where::edge) return false;
    const std::optional<int> became = becameSolid(p);
    if (!became) return true;
    return spot.where == Spot::Where::inside && form.holds(spot.block) ? *became > 0 : *became >= 0;
  };
  if (world_.at(middle).where != Spot::Where::edge) return wasFreeAt(middle);
  const auto [x, y] = middle;
  return wasFreeAt({x - 1, y - 1}) || wasFreeAt({x + 1, y - 1}) || wasFreeAt({x - 1, y + 1}) ||
         wasFreeAt({x + 1, y + 1});
}

bool NewGround::catches(const Form& form) const {
  if (!isFree(form)) return true;
  const double deep = kDeep * coreOf(form);
  const Box box = boxOf({&form, 1});
  return std::any_of(came_.begin(), came_.end(), [&](const Piece& piece) {
    return !isBeside(piece.line, box) && form.holds(piece.block) &&
           reaches(form, real(piece.line.start), real(piece.line.end), deep);
  });
}

double NewGround::depthIn(const Form& form) const {
  const double core = coreOf(form);
  if (!isFree(form)) return core;
  double least = kDeep * core, most = core;
  for (int k = 0; k < 10; ++k) {
    const double depth = (least + most) / 2;
    const bool isDeeper = std::any_of(came_.begin(), came_.end(), [&](const Piece& piece) {
      return form.holds(piece.block) && reaches(form, real(piece.line.start), real(piece.line.end), depth);
    });
    (isDeeper ? least : most) = depth;
  }
  return least;
}

void NewGround::linesIn(const Box& box, std::vector<Piece>& now, std::vector<Piece>& before) const {
  now.clear();
  before.clear();
  // A polygon has edges on the rim of its cell, which may be the box's.
  const CellRect cells{cellOf({box.min.x - 1, box.min.y - 1}), cellOf({box.max.x + 1, box.max.y + 1})};
  for (const SegmentId id : world_.segments(cells)) {
    const Segment s = *world_.segment(id);
    const Piece piece{{s.start, s.end}, s.block};
    if (isBeside(piece.line, box)) continue;
    now.push_back(piece);
    if (!std::binary_search(cameIds_.begin(), cameIds_.end(), id)) before.push_back(piece);
  }
  for (const Piece& piece : went_)
    if (!isBeside(piece.line, box)) before.push_back(piece);
}

bool hasCrossed(const World& world, std::span<const Form> before, std::span<const Form> now) {
  for (std::size_t k = 0; k < now.size() && k < before.size(); ++k) {
    const DoublePoint from = before[k].middle, to = now[k].middle;
    if (std::hypot(to.x - from.x, to.y - from.y) <= 2 * coreOf(now[k])) continue;
    const Expected<RayHit> hit = world.rayCast(rounded(from), rounded(to));
    if (hit && hit->segment && now[k].holds(world.segment(hit->segment)->block)) return true;
  }
  return false;
}

}  // namespace lgs::box2d
