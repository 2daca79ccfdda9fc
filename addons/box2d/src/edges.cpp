#include <lgs/box2d/edges.h>

#include <algorithm>
#include <cassert>
#include <iterator>

namespace lgs::box2d {

namespace {

std::uint64_t keyOf(Chunk chunk) {
  return std::uint64_t{static_cast<std::uint32_t>(chunk.x)} << 32 | static_cast<std::uint32_t>(chunk.y);
}

}  // namespace

EdgeSet::EdgeSet(EdgeOptions options) noexcept : options_(std::move(options)), slots_(1) {
  assert(options_.chunkCells >= 1 && options_.chunkCells <= 4'096);
  assert(options_.shortest >= 0 && options_.shortest <= std::int64_t{1} << 28);
}

// What an id named before says nothing about what it names now. So every edge goes, unless the same is placed again.
const EdgeChanges& EdgeSet::load(const World& world) noexcept {
  begin(world);
  for (Record& record : records_) {
    retire(record.edge);
    setFate(record, Fate::dead);
  }
  for (const SegmentId id : world.segments()) {
    forgetReads();
    admit(id);
    seedAround(id);
  }
  for (Record& record : records_) {
    if (record.fate == Fate::dead) record.edge = 0;
  }
  return renewAll();
}

std::optional<SyncError> EdgeSet::misfit(const World& world, const Changes& changes) const noexcept {
  if (changes.after != world.version()) return SyncError::notTheLast;
  if (changes.before != version_) return changes.after == version_ ? SyncError::shownAlready : SyncError::leftOut;
  const auto wasThere = [&](SegmentId id) { return lineOf(id).has_value(); };
  const auto isThere = [&](SegmentId id) { return world.segment(id).has_value(); };
  const bool isSound = std::ranges::all_of(changes.removed, wasThere) && std::ranges::all_of(changes.added, isThere) &&
                       std::ranges::all_of(changes.relinked, [&](SegmentId id) { return wasThere(id) && isThere(id); });
  if (!isSound) return SyncError::notTheLast;
  return {};
}

// An update has three steps. The first one collects the segments where something can have changed. The second one works
// out the strips and edges around each of them; edges that were there before keep their ids. The third one works out
// ghosts.
const EdgeChanges& EdgeSet::update(const World& world, const Changes& changes) noexcept {
  assert(!misfit(world, changes));
  begin(world);
  seedAll(changes);
  return renewAll();
}

const EdgeChanges& EdgeSet::renewAll() {
  for (std::size_t k = 0; k < seeds_.size(); ++k) {  // renewing may add seeds
    forgetReads();
    const SegmentId id = seeds_[k];
    const Record& record = records_[id.value];
    if (record.fate != Fate::dead && record.renewed != update_) renew(id);
  }
  removeRetired();
  for (const std::uint32_t edge : placed_) {
    forgetReads();
    relink(edge);
  }
  for (const auto& [first, last] : ends_) {
    forgetReads();
    relinkNearest(first, Way::before);
    relinkNearest(last, Way::after);
  }
  world_ = nullptr;
  return changes_;
}

void EdgeSet::begin(const World& world) {
  world_ = &world;
  version_ = world.version();
  ++update_;
  for (const EdgeId id : changes_.removed) free_.push_back(id.value);
  for (const std::uint32_t number : emptied_) {
    chunkNumbers_.erase(keyOf(chunks_[number]));
    freeChunks_.push_back(number);
  }
  emptied_.clear();
  changes_.removed.clear();
  changes_.added.clear();
  changes_.relinked.clear();
  changes_.turned.clear();
  readCount_ = 0;
  seeds_.clear();
  retired_.clear();
  placed_.clear();
  ends_.clear();
  records_.resize(std::max(records_.size(), std::size_t{world.maxSegmentId()} + 1));
}

// A commit can change the edges of the segments that it reports, and the edges of segments that are linked to those, or
// were linked to them before.
void EdgeSet::seedAll(const Changes& changes) {
  for (const SegmentId id : changes.removed) {
    Record& record = records_[id.value];
    seedLinks(record);
    retire(record.edge);
    setFate(record, Fate::dead);
    record.edge = 0;
  }
  for (const SegmentId id : changes.relinked) seedLinks(records_[id.value]);
  for (const SegmentId id : changes.added) {
    forgetReads();
    admit(id);
  }
  for (const auto* ids : {&changes.added, &changes.relinked}) {
    for (const SegmentId id : *ids) {
      forgetReads();
      seedAround(id);
    }
  }
}

EdgeId EdgeSet::edgeOf(SegmentId segment) const noexcept {
  return segment.value < records_.size() ? EdgeId{records_[segment.value].edge} : EdgeId{};
}

std::optional<Line> EdgeSet::lineOf(SegmentId segment) const noexcept {
  if (segment.value >= records_.size() || records_[segment.value].fate == Fate::dead) return {};
  return records_[segment.value].line;
}

std::vector<EdgeId> EdgeSet::edges() const noexcept {
  std::vector<EdgeId> ids;
  for (std::uint32_t k = 1; k < slots_.size(); ++k) {
    if (slots_[k].live) ids.push_back({k});
  }
  return ids;
}

EdgeCounts EdgeSet::counts() const noexcept {
  const auto of = [&](Fate fate) { return fates_[static_cast<std::size_t>(fate)]; };
  EdgeCounts counts{0, 0, of(Fate::single), of(Fate::merged), of(Fate::welded), of(Fate::leftOut)};
  counts.segments = counts.single + counts.merged + counts.welded + counts.leftOut;
  counts.edges = slots_.size() - 1 - free_.size() - changes_.removed.size();
  return counts;
}

void EdgeSet::seed(SegmentId id) {
  if (id) seeds_.push_back(id);
}

// Neighbours in a row get ids in a row.
void EdgeSet::seedAround(SegmentId id) {
  const Segment& s = read(id);
  seed(id);
  seed(s.predecessor);
  seed(s.successor);
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

void EdgeSet::admit(SegmentId id) {
  const Segment& s = read(id);
  Record& record = records_[id.value];
  record.line = {s.start, s.end};
  setFate(record, Fate::pending);
}

void EdgeSet::retire(std::uint32_t edge) {
  if (edge == 0 || slots_[edge].retired == update_) return;
  slots_[edge].retired = update_;
  retired_.push_back(edge);
}

void EdgeSet::removeRetired() {
  for (const std::uint32_t edge : retired_) {
    Slot& slot = slots_[edge];
    if (slot.kept == update_) continue;
    slot.live = false;
    if (--edgesIn_[slot.edge.chunk] == 0) emptied_.push_back(slot.edge.chunk);
    changes_.removed.push_back({edge});
  }
}

std::uint32_t EdgeSet::chunkNumber(Cell cell) {
  const Chunk chunk = Frame{1, {}, options_.chunkCells}.chunkOf(cell);
  const auto next = freeChunks_.empty() ? static_cast<std::uint32_t>(chunks_.size()) : freeChunks_.back();
  const auto [entry, isNew] = chunkNumbers_.try_emplace(keyOf(chunk), next);
  if (!isNew) return entry->second;
  if (freeChunks_.empty()) {
    chunks_.emplace_back();
    edgesIn_.push_back(0);
  } else {
    freeChunks_.pop_back();
  }
  chunks_[next] = chunk;
  return next;
}

std::uint32_t EdgeSet::newSlot() {
  if (free_.empty()) {
    slots_.emplace_back();
    return static_cast<std::uint32_t>(slots_.size() - 1);
  }
  const std::uint32_t edge = free_.back();
  free_.pop_back();
  return edge;
}

// Whether an edge begins with a segment and ends at a point. Only a load() finds the id of the segment with another
// start, block or place.
bool EdgeSet::isEdge(std::uint32_t number, const Segment& head, Point end) const {
  const Edge& edge = slots_[number].edge;
  return edge.first == head.id && edge.start == head.start && edge.end == end && edge.block == head.block &&
         chunks_[edge.chunk] == Frame{1, {}, options_.chunkCells}.chunkOf(head.cell);
}

// Makes an edge of segments of the group. If there was an edge with the same first segment and the same end, it stays.
void EdgeSet::place(std::size_t first, std::size_t last, Fate fate) {
  const Segment& head = *group_[first];
  const Segment& tail = *group_[last];
  std::uint32_t edge = records_[head.id.value].edge;
  if (edge != 0 && isEdge(edge, head, tail.end)) {
    slots_[edge].edge.last = tail.id;
    slots_[edge].kept = update_;
  } else {
    edge = newSlot();
    slots_[edge] = {{head.id, tail.id, chunkNumber(head.cell), head.block, head.start, tail.end, {}, {}}, true};
    slots_[edge].made = update_;
    ++edgesIn_[slots_[edge].edge.chunk];
    changes_.added.push_back({edge});
  }
  placed_.push_back(edge);
  for (std::size_t k = first; k <= last; ++k) {
    Record& record = records_[group_[k]->id.value];
    record.edge = edge;
    setFate(record, fate);
  }
}

void EdgeSet::relink(std::uint32_t edge) {
  Slot& slot = slots_[edge];
  if (slot.linked == update_) return;
  slot.linked = update_;
  const std::optional<Point> ghost1 = ghostOf(edge, Way::before);
  const std::optional<Point> ghost2 = ghostOf(edge, Way::after);
  if (slot.edge.ghost1 == ghost1 && slot.edge.ghost2 == ghost2) return;
  const Edge before = slot.edge;
  slot.edge.ghost1 = ghost1;
  slot.edge.ghost2 = ghost2;
  if (slot.made == update_) return;
  changes_.relinked.push_back({edge});
  if (isTurned(before.ghost1, ghost1, before.start) || isTurned(before.ghost2, ghost2, before.end))
    changes_.turned.push_back({edge});
}

// The ghost of the nearest edge beside a group is an end of the group's edges.
void EdgeSet::relinkNearest(SegmentId from, Way way) {
  const Record& record = records_[from.value];
  const std::uint32_t beside = way == Way::before ? record.predecessor : record.successor;
  if (slots_[records_[beside].edge].linked == update_) return;
  for (const Segment* s = neighbour(read(from), way); s && s->id != from; s = neighbour(*s, way)) {
    if (const std::uint32_t edge = records_[s->id.value].edge; edge != 0) return relink(edge);
  }
}

// This ends: a ring leads back to the edge itself, which then has no other edge beside it.
std::optional<Point> EdgeSet::ghostOf(std::uint32_t edge, Way way) {
  const bool isBefore = way == Way::before;
  const Edge& own = slots_[edge].edge;
  for (const Segment* s = &read(isBefore ? own.first : own.last);;) {
    if (!(isBefore ? s->predecessor : s->successor)) return {};
    const Segment* const next = neighbour(*s, way);
    if (!next) return isBefore ? s->ghost1 : s->ghost2;
    const std::uint32_t other = records_[next->id.value].edge;
    if (other == edge) return {};
    if (other != 0) return isBefore ? slots_[other].edge.start : slots_[other].edge.end;
    s = next;
  }
}

}  // namespace lgs::box2d
