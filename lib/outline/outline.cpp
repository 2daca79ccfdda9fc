// What the outline keeps, and how it goes back and forward. commit.cpp has the algorithm.
#include "outline/outline.h"

#include "geometry/sort.h"
#include "storage/held_bytes.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace lgs::detail {
namespace {

/// What a segment is as far as law 6 goes, and where its ghosts are.
struct Seen {
  Seen(Point from, Point to, Block b, std::uint32_t ref, std::uint32_t n)
      : start(from), end(to), block(b), cellRef(ref), serial(n) {}
  Point start, end;
  Block block;
  std::uint32_t cellRef, serial;
  std::optional<Point> ghost1, ghost2;

  bool isSameEdge(const Seen& s) const {
    return start == s.start && end == s.end && block == s.block && cellRef == s.cellRef && serial == s.serial;
  }
};

/// Segments by their place in a list of ids, where they are alive.
using SeenById = std::vector<std::optional<Seen>>;

SeenById look(const Grid& grid, const Outline& outline, const std::vector<std::uint32_t>& ids) {
  SeenById seen(ids.size());
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const std::uint32_t id = ids[k];
    if (!outline.isShown({id})) continue;
    const SegmentRecord& s = outline.segments[id];
    Seen& now = seen[k].emplace(outline.startOf(grid, id), outline.endOf(grid, id), s.block, s.cellRef, s.serial);
    if (s.predecessor != kNoSegment) now.ghost1 = outline.startOf(grid, s.predecessor);
    if (s.successor != kNoSegment) now.ghost2 = outline.endOf(grid, s.successor);
  }
  return seen;
}

}  // namespace

std::span<const SegmentId> Outline::createIds(std::size_t count) {
  changes_.added.reserve(count);
  for (; count != 0; --count) changes_.added.push_back({segments.take()});
  return changes_.added;
}

void Outline::load(std::uint32_t count, std::vector<std::uint32_t> free, std::span<const std::uint32_t> removed) {
  segments.reset(count, std::move(free));
  for (const std::uint32_t id : removed) changes_.removed.push_back({id});
}

std::uint64_t Outline::liveCount(const Grid& grid) const {
  std::uint64_t count = segments.maxId() - segments.free().size() - changes_.removed.size();
  if (hidden_.any()) {
    for (Chunk* chunk : grid.chunks())
      for (CellAt at{chunk, 0}; hidden_.are(chunk->index) && at.local < kChunkCells; ++at.local)
        count -= lists.of(at).count();
  }
  return count;
}

void Outline::forget(std::uint32_t chunk) {
  lists.forget(chunk);
  hidden_.forget(chunk);
}

// --- Going back

/// In its own file, so that splice() is small and inlined.
void Outline::noteList(CellAt at) { note_->lists.add(at.ref(), lists.of(at).words()); }

void Outline::goBack(const Grid& grid, std::uint64_t moment, std::uint64_t version, Undone undone, Changes& changes) {
  notes.close();
  std::vector<std::uint32_t> ids;
  for (std::uint64_t k = moment; k < notes.now(); ++k) notes[k].addTo(ids);
  go(grid, std::move(ids), version, changes, [&] {
    while (notes.now() > moment) {
      SegmentNote note = notes.takeBack();
      if (undone == Undone::keep) undone_.push_back(afterIt(grid, note));
      undo(grid, note);
      if (undone == Undone::keep) undone_.back().note = std::move(note);
    }
  });
}

void Outline::goForward(const Grid& grid, std::uint64_t moment, std::uint64_t version, Changes& changes) {
  notes.close();
  std::vector<std::uint32_t> ids;
  for (std::size_t k = 0; k < moment - notes.now(); ++k) undone_[undone_.size() - 1 - k].note.addTo(ids);
  go(grid, std::move(ids), version, changes, [&] {
    for (; notes.now() < moment; undone_.pop_back()) redo(grid, undone_.back());
  });
}

/// Goes, and says what this did to the segments with these ids.
template <class Go>
void Outline::go(const Grid& grid, std::vector<std::uint32_t> ids, std::uint64_t version, Changes& changes, Go&& go) {
  detail::sort(ids);
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());  // clang 14 does not take the one of std::ranges
  const SeenById before = look(grid, *this, ids);
  go();
  const SeenById after = look(grid, *this, ids);
  changes = {};
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const SegmentId id{ids[k]};
    const auto &then = before[k], &now = after[k];
    const bool same = then && now && then->isSameEdge(*now);
    if (then && !same) changes.removed.push_back(id);
    if (now && !same) changes.added.push_back(id);
    if (same && (then->ghost1 != now->ghost1 || then->ghost2 != now->ghost2)) changes.relinked.push_back(id);
  }
  changes.before = version_;
  if (!changes.removed.empty() || !changes.added.empty() || !changes.relinked.empty()) version_ = version;
  changes.after = version_;
}

void Outline::undo(const Grid& grid, const SegmentNote& note) {
  for (const std::uint32_t chunk : note.turned) hidden_.toggle(chunk);
  for (const std::uint32_t id : note.added) segments[id].cellRef = 0;
  put(grid, note.lists, note.segments);
  segments.putBack(note.freeKept, note.freeTaken, note.topBefore);
  changes_.removed = note.removedBefore;
}

/// Lists and segments as they were noted. Of several notes of one list the first counts.
void Outline::put(const Grid& grid, const NotedLists& noted, const RecordsById& records) {
  noted.forEachBackwards([&](std::uint32_t cellRef, std::span<const std::uint32_t> words) {
    const CellAt at = grid.find(cellRef);
    const std::uint32_t now = lists.of(at).count(), then = static_cast<std::uint32_t>(words.size()) - Layout::kWords;
    if (now == 0 && then == 0) return;
    if (std::uint32_t* list = lists.splice(at, 0, now, then)) std::ranges::copy(words, list);
  });
  for (const auto& [id, record] : records) segments[id] = record;
}

/// Before an update is undone: what it changed, as it is after it; without the note.
Outline::UndoneUpdate Outline::afterIt(const Grid& grid, const SegmentNote& note) const {
  UndoneUpdate undone;
  undone.removed = changes_.removed;
  undone.top = segments.maxId() + 1;
  const std::vector<std::uint32_t>& free = segments.free();
  undone.freeTaken.assign(free.rbegin(), free.rend() - static_cast<std::ptrdiff_t>(note.freeKept));
  for (const std::uint32_t id : note.added) undone.segments.emplace_back(id, segments[id]);
  for (const auto& old : note.segments) undone.segments.emplace_back(old.first, segments[old.first]);
  note.lists.forEach(
      [&](std::uint32_t cellRef, auto) { undone.lists.add(cellRef, lists.of(grid.find(cellRef)).words()); });
  return undone;
}

/// The same update again: it takes the same ids, as the same are available.
void Outline::redo(const Grid& grid, UndoneUpdate& undone) {
  for (const std::uint32_t chunk : undone.note.turned) hidden_.toggle(chunk);
  segments.putBack(undone.note.freeKept, undone.freeTaken, undone.top);
  put(grid, undone.lists, undone.segments);
  changes_.removed = std::move(undone.removed);
  notes.add(std::move(undone.note));
}

std::uint64_t Outline::bytes() const {
  std::uint64_t sum = segments.bytes() + lists.bytes() + bytesOf(changes_) + bytesOf(shown_) + hidden_.bytes() +
                      notes.bytes() + heldBytes(undone_, ids_, fan_);
  for (const UndoneUpdate& u : undone_)
    sum += u.note.bytes() + heldBytes(u.removed, u.freeTaken, u.segments) + u.lists.bytes();
  return sum;
}

}  // namespace lgs::detail
