#include <lgs/box2d/edges.h>

#include <algorithm>
#include <cassert>
#include <iterator>

namespace lgs::box2d {

EdgeSet::EdgeSet(EdgeOptions options) : options_(std::move(options)), slots_(1) {
  assert(options_.chunkCells >= 1 && options_.chunkCells <= 4'096);
  assert(options_.shortest >= 0 && options_.shortest <= std::int64_t{1} << 28);
}

const EdgeChanges& EdgeSet::load(const World& world) {
  assert(counts().segments == 0);
  Changes all;
  all.added = world.segments();
  return update(world, all);
}

const EdgeChanges& EdgeSet::update(const World& world, const Changes& changes) {
  world_ = &world;
  ++update_;
  for (const EdgeId id : changes_.removed) free_.push_back(id.value);
  changes_.removed.clear();
  changes_.added.clear();
  changes_.relinked.clear();
  seeds_.clear();
  retired_.clear();
  placed_.clear();
  ends_.clear();
  records_.resize(std::max(records_.size(), std::size_t{world.maxSegmentId()} + 1));

  // What can change lies in the edges of what was reported, and of what was or is linked to it.
  for (const SegmentId id : changes.removed) {
    Record& record = records_[id.value];
    seedLinks(record);
    retire(record.edge);
    setFate(record, Fate::dead);
    record.edge = 0;
  }
  for (const SegmentId id : changes.relinked) seedLinks(records_[id.value]);
  for (const SegmentId id : changes.added) setFate(records_[id.value], Fate::pending);
  for (const auto* ids : {&changes.added, &changes.relinked}) {
    for (const SegmentId id : *ids) {
      const Segment s = read(id);
      seed(id);
      seed(s.predecessor);
      seed(s.successor);
    }
  }
  for (std::size_t k = 0; k < seeds_.size(); ++k) {  // renewing may add some
    const SegmentId id = seeds_[k];
    const Record& record = records_[id.value];
    if (record.fate != Fate::dead && record.renewed != update_) renew(id);
  }
  for (const std::uint32_t edge : retired_) {
    Slot& slot = slots_[edge];
    if (slot.kept == update_) continue;
    slot.live = false;
    changes_.removed.push_back({edge});
  }
  for (const std::uint32_t edge : placed_) relink(edge);
  for (const auto& [first, last] : ends_) relinkAround(first, last);
  world_ = nullptr;
  return changes_;
}

EdgeId EdgeSet::edgeOf(SegmentId segment) const {
  return segment.value < records_.size() ? EdgeId{records_[segment.value].edge} : EdgeId{};
}

std::vector<EdgeId> EdgeSet::edges() const {
  std::vector<EdgeId> ids;
  for (std::uint32_t k = 1; k < slots_.size(); ++k) {
    if (slots_[k].live) ids.push_back({k});
  }
  return ids;
}

EdgeCounts EdgeSet::counts() const {
  const auto of = [&](Fate fate) { return fates_[static_cast<std::size_t>(fate)]; };
  EdgeCounts counts{0, 0, of(Fate::single), of(Fate::merged), of(Fate::welded), of(Fate::leftOut)};
  counts.segments = counts.single + counts.merged + counts.welded + counts.leftOut;
  counts.edges = slots_.size() - 1 - free_.size() - changes_.removed.size();
  return counts;
}

void EdgeSet::seed(SegmentId id) {
  if (id) seeds_.push_back(id);
}

void EdgeSet::seedLinks(const Record& record) {
  seed({record.predecessor});
  seed({record.successor});
}

void EdgeSet::setFate(Record& record, Fate fate) {
  if (record.fate != Fate::dead) --fates_[static_cast<std::size_t>(record.fate)];
  record.fate = fate;
  if (fate != Fate::dead) ++fates_[static_cast<std::size_t>(fate)];
}

void EdgeSet::retire(std::uint32_t edge) {
  if (edge == 0 || slots_[edge].retired == update_) return;
  slots_[edge].retired = update_;
  retired_.push_back(edge);
}

std::uint32_t EdgeSet::chunkNumber(Cell cell) {
  const Chunk chunk = Frame{1, {}, options_.chunkCells}.chunkOf(cell);
  const auto key = std::uint64_t{static_cast<std::uint32_t>(chunk.x)} << 32 | static_cast<std::uint32_t>(chunk.y);
  const auto [entry, isNew] = chunkNumbers_.try_emplace(key, static_cast<std::uint32_t>(chunks_.size()));
  if (isNew) chunks_.push_back(chunk);
  return entry->second;
}

// An edge with the same ends and the same first segment is the same edge.
void EdgeSet::place(std::size_t first, std::size_t last, Fate fate) {
  const Segment& head = group_[first];
  const Segment& tail = group_[last];
  std::uint32_t edge = records_[head.id.value].edge;
  if (edge != 0 && slots_[edge].edge.first == head.id && slots_[edge].edge.end == tail.end) {
    slots_[edge].edge.last = tail.id;
    slots_[edge].kept = update_;
  } else {
    if (free_.empty()) {
      edge = static_cast<std::uint32_t>(slots_.size());
      slots_.emplace_back();
    } else {
      edge = free_.back();
      free_.pop_back();
    }
    slots_[edge] = {{head.id, tail.id, chunkNumber(head.cell), head.block, head.start, tail.end, {}, {}}, true};
    slots_[edge].made = update_;
    changes_.added.push_back({edge});
  }
  placed_.push_back(edge);
  for (std::size_t k = first; k <= last; ++k) {
    Record& record = records_[group_[k].id.value];
    record.edge = edge;
    setFate(record, fate);
  }
}

void EdgeSet::relink(std::uint32_t edge) {
  Slot& slot = slots_[edge];
  if (slot.linked == update_) return;
  slot.linked = update_;
  const std::optional<Point> ghost1 = ghost1Of(edge);
  const std::optional<Point> ghost2 = ghost2Of(edge);
  if (slot.edge.ghost1 == ghost1 && slot.edge.ghost2 == ghost2) return;
  slot.edge.ghost1 = ghost1;
  slot.edge.ghost2 = ghost2;
  if (slot.made != update_) changes_.relinked.push_back({edge});
}

// The nearest edges before and after a group look at its ends.
void EdgeSet::relinkAround(SegmentId first, SegmentId last) {
  for (auto s = before(read(first)); s && s->id != first; s = before(*s)) {
    if (const std::uint32_t edge = records_[s->id.value].edge; edge != 0) {
      relink(edge);
      break;
    }
  }
  for (auto s = after(read(last)); s && s->id != last; s = after(*s)) {
    if (const std::uint32_t edge = records_[s->id.value].edge; edge != 0) {
      relink(edge);
      break;
    }
  }
}

// These end: a ring leads back to the edge itself, which is then alone in it.
std::optional<Point> EdgeSet::ghost1Of(std::uint32_t edge) const {
  for (Segment s = read(slots_[edge].edge.first);;) {
    if (!s.predecessor) return {};
    const std::optional<Segment> previous = before(s);
    if (!previous) return s.ghost1;
    const std::uint32_t other = records_[previous->id.value].edge;
    if (other == edge) return {};
    if (other != 0) return slots_[other].edge.start;
    s = *previous;
  }
}

std::optional<Point> EdgeSet::ghost2Of(std::uint32_t edge) const {
  for (Segment s = read(slots_[edge].edge.last);;) {
    if (!s.successor) return {};
    const std::optional<Segment> next = after(s);
    if (!next) return s.ghost2;
    const std::uint32_t other = records_[next->id.value].edge;
    if (other == edge) return {};
    if (other != 0) return slots_[other].edge.end;
    s = *next;
  }
}

}  // namespace lgs::box2d
