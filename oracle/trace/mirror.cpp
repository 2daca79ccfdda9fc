#include "oracle/trace/mirror.h"

#include "oracle/reference/vector.h"
#include "oracle/reference/words.h"
#include "oracle/trace/dump.h"

#include <fmt/format.h>
#include <algorithm>

namespace lgs::oracle {
namespace {

std::string show(const Segment& s) {
  return fmt::format("segment {} (id {}, block {}, {})", inWords(s.start, s.end), s.id.value, s.block,
                     placeInWords(s.start, s.end));
}

bool sameGhosts(const Segment& a, const Segment& b) {
  return bool{a.predecessor} == bool{b.predecessor} && bool{a.successor} == bool{b.successor} &&
         (!a.predecessor || a.ghost1 == b.ghost1) && (!a.successor || a.ghost2 == b.ghost2);
}

bool sameSegment(const Segment& a, const Segment& b) {
  return a.start == b.start && a.end == b.end && a.polygon == b.polygon && a.block == b.block && a.cell == b.cell;
}

bool inCell(const Point& p, Cell cell) {
  const Point origin = toWorld(cell, {0, 0});
  return origin.x <= p.x && p.x <= origin.x + kUnitsPerCell && origin.y <= p.y && p.y <= origin.y + kUnitsPerCell;
}

// Whether a→b lies on u→v, in its direction. All in one cell, so nothing overflows.
bool liesOn(Point a, Point b, Point u, Point v) {
  return isOnSegment(a, u, v) && isOnSegment(b, u, v) && dot(v - u, b - a) > 0;
}

std::optional<std::string> checkOwner(const World& world, const Segment& s) {
  const auto owner = world.polygon(s.polygon);
  const auto cell = world.cellOf(s.polygon);
  if (!owner || !cell) return fmt::format("{} names an owner that is not placed", show(s));
  if (owner->block != s.block || *cell != s.cell) {
    return fmt::format("{} has an owner of another block or cell", show(s));
  }
  if (!inCell(s.start, *cell) || !inCell(s.end, *cell)) return fmt::format("{} lies outside its cell", show(s));
  const std::size_t n = owner->vertices.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Point u = toWorld(*cell, owner->vertices[k]);
    const Point v = toWorld(*cell, owner->vertices[(k + 1) % n]);
    if (liesOn(s.start, s.end, u, v)) return std::nullopt;
  }
  return fmt::format("{} lies on no edge of the polygon that owns it", show(s));
}

bool isUnloaded(const World& world, SegmentId id) {
  const auto segment = world.segment(id);
  return !segment && segment.error().code == ErrorCode::unloaded;
}

// `p` and `n` are the segments that its links name; null if they are not alive.
std::optional<std::string> checkLinks(const Segment& s, const Segment* p, const Segment* n) {
  if (s.predecessor) {
    if (!p) return fmt::format("{}: its predecessor, id {}, is not alive", show(s), s.predecessor.value);
    if (p->end != s.start) return fmt::format("{}: its predecessor, {}, does not end at its start", show(s), show(*p));
    if (p->start != s.ghost1) return fmt::format("{}: ghost1 is not the start of its predecessor", show(s));
  }
  if (s.successor) {
    if (!n) return fmt::format("{}: its successor, id {}, is not alive", show(s), s.successor.value);
    if (n->start != s.end) return fmt::format("{}: its successor, {}, does not start at its end", show(s), show(*n));
    if (n->end != s.ghost2) return fmt::format("{}: ghost2 is not the end of its successor", show(s));
  }
  return std::nullopt;
}

}  // namespace

Segment* Mirror::find(SegmentId id) {
  return id.value < segments_.size() && segments_[id.value].id ? &segments_[id.value] : nullptr;
}

Mirror::Complaint Mirror::about(const Segment& segment, std::string text) {
  blamed_.push_back(outlineSegment(segment));
  return text;
}

// Shows the segment as it was known, or else as the world has it, which may know none of this id.
Mirror::Complaint Mirror::about(const World& world, SegmentId id, std::string text) {
  if (const Segment* const old = find(id)) return about(*old, std::move(text));
  const auto now = world.segment(id);
  return now ? about(*now, std::move(text)) : std::move(text);
}

std::optional<std::string> Mirror::update(const World& world, const Changes& changes, After after) {
  after_ = after;
  listed_.clear();
  gone_.clear();
  for (const auto* ids : {&changes.removed, &changes.relinked, &changes.added}) {
    if (after != After::commit && !std::ranges::is_sorted(*ids)) return "what a roll-back did is not told by id";
    if (after != After::commit && ids != &changes.relinked) listed_.clear();
    for (const SegmentId id : *ids)
      if (!listed_.insert(id.value).second)
        return about(world, id, fmt::format("the change list names id {} twice", id.value));
  }
  if (auto complaint = remove(world, changes.removed)) return complaint;
  if (auto complaint = relink(world, changes.relinked)) return complaint;
  if (auto complaint = add(world, changes.added)) return complaint;
  if (auto complaint = compareAll(world)) return complaint;
  if (after != After::commit) segments_.resize(std::size_t{world.maxSegmentId()} + 1);  // a roll-back lowers it
  return std::nullopt;
}

Mirror::Complaint Mirror::remove(const World& world, const std::vector<SegmentId>& ids) {
  for (const SegmentId id : ids) {
    Segment* const old = find(id);
    if (!old) return about(world, id, fmt::format("reported as removed, but was not there: id {}", id.value));
    gone_.emplace(identityOf(*old), *old);
    *old = {};
    --alive_;
  }
  return std::nullopt;
}

Mirror::Complaint Mirror::relink(const World& world, const std::vector<SegmentId>& ids) {
  for (const SegmentId id : ids) {
    Segment* const old = find(id);
    if (!old) return about(world, id, fmt::format("reported as relinked, but was not there: id {}", id.value));
    const auto now = world.segment(id);
    if (!now) return about(*old, fmt::format("reported as relinked, but is gone: {}", show(*old)));
    if (sameGhosts(*now, *old)) {
      return about(*now, fmt::format("reported as relinked, but its ghosts are as before: {}", show(*now)));
    }
    if (!sameSegment(*now, *old)) {
      return about(*now,
                   fmt::format("reported as relinked, but is another segment now: {}, was {}", show(*now), show(*old)));
    }
    *old = *now;
  }
  return std::nullopt;
}

Mirror::Complaint Mirror::add(const World& world, const std::vector<SegmentId>& ids) {
  for (const SegmentId id : ids) {
    const auto now = world.segment(id);
    if (!now) return about(world, id, fmt::format("reported as added, but is not there: id {}", id.value));
    if (const auto old = gone_.find(identityOf(*now)); after_ == After::commit && old != gone_.end()) {
      return about(*now, fmt::format("reported as removed and added, but is the same segment: {}, was {}", show(*now),
                                     show(old->second)));
    }
    if (find(id)) return about(*now, fmt::format("reported as added, but was there before: {}", show(*now)));
    if (id.value >= segments_.size()) segments_.resize(std::size_t{id.value} + 1);
    segments_[id.value] = *now;
    ++alive_;
  }
  return std::nullopt;
}

// `id` is one that the world lists as alive.
Mirror::Complaint Mirror::compare(const World& world, SegmentId id) {
  const auto now = world.segment(id);
  if (!now || now->id != id) return fmt::format("listed as alive, but can not be read: id {}", id.value);
  const Segment* const old = find(id);
  if (!old) return about(*now, fmt::format("new, but not reported as added: {}", show(*now)));
  if (!sameSegment(*now, *old)) {
    return about(*now, fmt::format("changed without a report: {}, was {}", show(*now), show(*old)));
  }
  if (!sameGhosts(*now, *old)) {
    return about(*now, fmt::format("has new ghosts, but is not reported as relinked: {}", show(*now)));
  }
  if (now->predecessor != old->predecessor || now->successor != old->successor) {
    // The ghosts are the same, but other segments lead there. A commit does not report that.
    segments_[id.value] = *now;
  }
  if (after_ == After::goingBackToPending) return std::nullopt;
  auto complaint = checkOwner(world, *now);
  return complaint ? about(*now, std::move(*complaint)) : std::nullopt;
}

Mirror::Complaint Mirror::compareAll(const World& world) {
  const std::vector<SegmentId> alive = world.segments();
  for (const SegmentId id : alive)
    if (auto complaint = compare(world, id)) return complaint;
  for (std::size_t k = 1; k < alive.size(); ++k) {
    if (alive[k] <= alive[k - 1])
      return about(world, alive[k],
                   fmt::format("id {} is listed as alive after {}", alive[k].value, alive[k - 1].value));
  }
  if (alive.size() != alive_) {
    const std::unordered_set<SegmentId> aliveSet(alive.begin(), alive.end());
    for (const Segment& segment : segments_) {
      if (segment.id && !aliveSet.contains(segment.id)) {
        return about(segment, fmt::format("gone, but not reported as removed: {}", show(segment)));
      }
    }
  }
  // By now all segments here are those of the world, so their links can be followed here.
  for (const SegmentId id : alive) {
    Segment s = segments_[id.value];
    for (SegmentId* const link : {&s.predecessor, &s.successor})
      if (*link && !find(*link) && isUnloaded(world, *link)) *link = {};
    if (auto complaint = checkLinks(s, find(s.predecessor), find(s.successor))) return about(s, std::move(*complaint));
  }
  return std::nullopt;
}

}  // namespace lgs::oracle
