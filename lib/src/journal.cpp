#include "journal.h"

#include "geometry/sort.h"
#include "wide_row.h"
#include "world_impl.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <map>
#include <optional>
#include <tuple>

namespace lgs::detail {
namespace {

/// The cells whose segments a commit can change: the dirty ones and those around, each once, by reference.
std::vector<std::uint32_t> cellsOfCommit(std::span<Chunk* const> dirtyChunks) {
  std::vector<std::uint32_t> cells;
  for (const Chunk* chunk : dirtyChunks) {
    forEachRowNear(chunk->dirtyRows, [&](std::int32_t y) {
      const WideRow dirty = dirtyRow(*chunk, y - 1) | dirtyRow(*chunk, y) | dirtyRow(*chunk, y + 1);
      forEachColumn(dirty | dirty << 1 | dirty >> 1, [&](std::int32_t x) {
        if (const CellAt at = cellAt(*chunk, x, y)) cells.push_back(at.chunk->ref(at.local));
      });
    });
  }
  detail::sort(cells);
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

bool sameEdge(const Segment& a, const Segment& b) {
  return std::tie(a.start, a.end, a.polygon, a.block) == std::tie(b.start, b.end, b.polygon, b.block);
}

/// A ghost, where there is one.
std::optional<Point> ghost(SegmentId link, Point at) { return link ? std::optional(at) : std::nullopt; }

bool sameGhosts(const Segment& a, const Segment& b) {
  return ghost(a.predecessor, a.ghost1) == ghost(b.predecessor, b.ghost1) &&
         ghost(a.successor, a.ghost2) == ghost(b.successor, b.ghost2);
}

/// The segments of some ids, where they are alive, by id.
using Segments = std::map<std::uint32_t, std::optional<Segment>>;

void read(const World::Impl& world, Segments& segments) {
  for (auto& [id, segment] : segments)
    segment = world.segments.isLive(id) ? std::optional(world.segment(id)) : std::nullopt;
}

/// What became of some segments.
void compare(const Segments& before, const Segments& after, Changes& changes) {
  for (auto then = before.begin(), now = after.begin(); then != before.end(); ++then, ++now) {
    const SegmentId id{then->first};
    const bool same = then->second && now->second && sameEdge(*then->second, *now->second);
    if (then->second && !same) changes.removed.push_back(id);
    if (now->second && !same) changes.added.push_back(id);
    if (same && !sameGhosts(*then->second, *now->second)) changes.relinked.push_back(id);
  }
}

}  // namespace

void Journal::setOpen(World::Impl& world, bool open) {
  isOpen_ = open;
  world.grid.setRemembers(!open);
}

Mark Journal::mark(World::Impl& world, bool ofGroup) {
  setOpen(world, true);
  const Mark mark{world.versions.next()};  // greater than all before, also in a copy
  marks_.push_back({mark, forgotten_ + entries_.size(), world.grid.chunks().size(), world.catalogue.shapeCount(),
                    world.version, ofGroup});
  return mark;
}

std::size_t Journal::positionOf(Mark mark) const {
  const auto found = std::ranges::lower_bound(marks_, mark, {}, &MarkEntry::mark);
  return static_cast<std::size_t>((found != marks_.end() && found->mark == mark ? found : marks_.end()) -
                                  marks_.begin());
}

void Journal::forget(World::Impl& world, Mark mark) {
  marks_.erase(marks_.begin() + static_cast<std::ptrdiff_t>(positionOf(mark)));
  setOpen(world, !marks_.empty());
  const std::uint64_t needed = marks_.empty() ? forgotten_ + entries_.size() : marks_.front().position;
  for (; forgotten_ < needed; ++forgotten_) {
    placed_.erase(placed_.begin(), placed_.begin() + drop(world, entries_.front()));
    entries_.pop_front();
  }
}

void Journal::forgetGroups(World::Impl& world) {
  const std::vector<MarkEntry> marks = marks_;
  for (const MarkEntry& entry : marks)
    if (entry.ofGroup) forget(world, entry.mark);
}

bool Journal::committedSince(Mark mark) const {
  const auto since = static_cast<std::ptrdiff_t>(marks_[positionOf(mark)].position - forgotten_);
  return std::any_of(entries_.begin() + since, entries_.end(),
                     [](const Entry& entry) { return std::holds_alternative<Owned<CommitEntry>>(entry); });
}

bool Journal::endsWithCommit() const {
  return marks_.back().position < forgotten_ + entries_.size() &&
         std::holds_alternative<Owned<CommitEntry>>(entries_.back());
}

std::ptrdiff_t Journal::drop(World::Impl& world, const Entry& entry) {
  const auto* cell = std::get_if<CellEntry>(&entry);
  if (!cell) return 0;
  if (cell->content != kEmptyContent) world.catalogue.release(cell->content);
  return static_cast<std::ptrdiff_t>(cell->polygons);
}

void Journal::noteCell(World::Impl& world, CellAt at) {
  CellEntry entry;
  entry.cellRef = at.chunk->ref(at.local);
  entry.content = world.grid.content(at);
  entry.lastSerial = world.grid.lastSerial(at);
  entry.isListed = world.grid.listsPolygons(at);
  entry.wasDirty = (at.chunk->dirty[at.row()] & at.bit()) != 0;
  if (entry.content != kEmptyContent) {
    world.catalogue.use(entry.content);
    entry.polygons = static_cast<std::uint32_t>(world.catalogue.content(entry.content).polygons.size());
    for (std::uint32_t slot = 0; slot < entry.polygons; ++slot)
      placed_.push_back(world.grid.placed(at)[static_cast<Slot>(slot)]);
  }
  entries_.emplace_back(entry);
}

bool Journal::noteCommit(const World::Impl& world) {
  if (world.dirtyChunks.empty() && world.changes.removed.empty() && endsWithCommit()) return false;
  auto made = std::make_unique<CommitEntry>();
  CommitEntry& entry = *made;
  for (const Chunk* chunk : world.dirtyChunks) entry.dirty.push_back({chunk->index, chunk->dirty});
  for (const std::uint32_t cellRef : cellsOfCommit(world.dirtyChunks)) {
    const CellAt at = world.grid.find(cellRef);
    CellSegments cell{cellRef, {}, 0};
    if (const CellRecord* r = world.grid.record(at)) {
      cell.parts = r->parts;
      cell.touching = r->touching;
    }
    entry.cells.push_back(cell);
    for (const std::uint32_t id : world.grid.segments(at)) {
      entry.ids.push_back(id);
      entry.segments.push_back(world.segments[id]);
    }
  }
  entry.removedBefore = world.changes.removed;
  entry.topBefore = world.segments.maxId() + 1;
  entries_.emplace_back(Owned(std::move(made)));
  return true;
}

void Journal::noteChanges(const Changes& changes) { std::get<Owned<CommitEntry>>(entries_.back())->changes = changes; }

void Journal::rollBack(World::Impl& world, Mark mark, Changes& changes) {
  const std::size_t index = positionOf(mark);
  const MarkEntry to = marks_[index];
  Segments before;
  for (std::size_t k = static_cast<std::size_t>(to.position - forgotten_); k < entries_.size(); ++k) {
    const auto* commit = std::get_if<Owned<CommitEntry>>(&entries_[k]);
    if (!commit) continue;
    const Changes& then = (*commit)->changes;
    for (const auto* ids : {&then.removed, &then.added, &then.relinked})
      for (const SegmentId id : *ids) before.try_emplace(id.value);
  }
  Segments after = before;
  read(world, before);
  while (forgotten_ + entries_.size() > to.position) {
    std::visit([&](const auto& entry) { undo(world, entry); }, entries_.back());
    placed_.erase(placed_.end() - drop(world, entries_.back()), placed_.end());
    entries_.pop_back();
  }
  marks_.resize(index + 1);
  world.grid.forgetChunks(to.chunks);
  world.catalogue.forgetShapes(to.shapes);
  read(world, after);
  changes = {};
  compare(before, after, changes);
  changes.before = world.version;
  if (!changes.removed.empty() || !changes.added.empty() || !changes.relinked.empty()) world.version = to.version;
  changes.after = world.version;
}

void Journal::undo(World::Impl& world, const CellEntry& entry) {
  const CellAt at = world.grid.find(entry.cellRef);
  if (entry.content != kEmptyContent) world.catalogue.use(entry.content);
  if (const ContentId now = world.grid.content(at); now != kEmptyContent) world.catalogue.release(now);
  const std::vector<Placed> polygons(placed_.end() - static_cast<std::ptrdiff_t>(entry.polygons), placed_.end());
  world.grid.setPolygons(at, entry.content, entry.lastSerial, polygons, entry.isListed);
  at.chunk->facts[at.local] = world.catalogue.facts(entry.content);
  if (entry.wasDirty) return;
  at.chunk->dirty[at.row()] &= ~at.bit();
  if (at.chunk->dirty[at.row()] == 0) at.chunk->dirtyRows &= ~(RowMask{1} << at.row());
  if (at.chunk->dirtyRows != 0) return;
  assert(world.dirtyChunks.back() == at.chunk);  // the edit was the first in its chunk
  world.dirtyChunks.pop_back();
}

void Journal::undo(World::Impl& world, const Owned<CommitEntry>& owned) {
  const CommitEntry& entry = *owned;
  assert(world.dirtyChunks.empty());  // later edits are undone
  for (const SegmentId id : entry.changes.added) world.segments[id.value].cellRef = 0;
  std::size_t k = 0;
  for (const CellSegments& cell : entry.cells) {
    const CellAt at = world.grid.find(cell.cellRef);
    const auto now = static_cast<std::uint32_t>(world.grid.segments(at).size());
    const std::uint32_t count = cell.parts.count();
    CellRecord* r = now == 0 && count == 0 ? nullptr : world.grid.spliceSegments(at, 0, now, count);
    if (r) {
      r->parts = cell.parts;
      r->touching = cell.touching;
      std::copy_n(entry.ids.begin() + static_cast<std::ptrdiff_t>(k), count, r->ids());
    }
    k += count;
  }
  for (k = 0; k < entry.ids.size(); ++k) world.segments[entry.ids[k]] = entry.segments[k];
  world.segments.giveBack(entry.changes.added, entry.topBefore, entry.removedBefore.size());
  world.changes.removed = entry.removedBefore;
  for (const DirtyChunk& dirty : entry.dirty) {
    Chunk& chunk = *world.grid.chunks()[dirty.index - 1];
    chunk.dirty = dirty.rows;
    for (std::uint32_t y = 0; y < kChunkSize; ++y)
      if (dirty.rows[y] != 0) chunk.dirtyRows |= RowMask{1} << y;
    world.dirtyChunks.push_back(&chunk);
  }
}

std::uint64_t Journal::bytes() const {
  const auto of = [](const auto&... v) { return (... + (v.capacity() * sizeof(v[0]))); };
  // An empty deque has a block, too: of 512 bytes, in libstdc++.
  const auto ofDeque = [](const auto& d) { return 512 + d.size() * sizeof(d[0]); };
  std::uint64_t sum = ofDeque(entries_) + ofDeque(placed_) + of(marks_);
  for (const Entry& entry : entries_) {
    const auto* commit = std::get_if<Owned<CommitEntry>>(&entry);
    if (!commit) continue;
    const CommitEntry& c = **commit;
    sum += sizeof c + of(c.dirty, c.cells, c.ids, c.segments, c.removedBefore, c.changes.removed, c.changes.added,
                         c.changes.relinked);
  }
  return sum;
}

}  // namespace lgs::detail
