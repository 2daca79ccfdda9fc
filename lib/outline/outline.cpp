#include "outline/outline.h"

#include "geometry/sort.h"
#include "storage/held_bytes.h"

#include <algorithm>
#include <optional>

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

/// Adds all ids that an update reported.
void addTo(std::vector<std::uint32_t>& all, const Changes& changes) {
  for (const auto* ids : {&changes.removed, &changes.added, &changes.relinked})
    for (const SegmentId id : *ids) all.push_back(id.value);
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
  if (hasHidden()) {
    for (Chunk* chunk : grid.chunks())
      for (CellAt at{chunk, 0}; isHidden(chunk->index) && at.local < kChunkCells; ++at.local)
        count -= lists.of(at).count();
  }
  return count;
}

void Outline::forget(std::uint32_t chunk) {
  lists.forget(chunk);
  if (isHidden(chunk)) toggleHidden(chunk);
  while (!hidden_.empty() && hidden_.back() == 0) hidden_.pop_back();
  giveBackSpare(hidden_);
}

/// A chunk was loaded and is unloaded now, or the other way around.
void Outline::toggleHidden(std::uint32_t chunk) {
  if (hidden_.size() <= chunk) hidden_.resize(std::size_t{chunk} + 1);
  hidden_[chunk] ^= kHidden | kWasHidden;
  isHidden(chunk) ? ++hiddenChunks_ : --hiddenChunks_;
}

void Outline::noteList(CellAt at, std::vector<std::uint32_t>& out) const {
  const CellSegments shown = lists.of(at);
  const std::uint32_t size = Layout::kWords + shown.count();
  out.insert(out.end(), shown.ids() - Layout::kWords, shown.ids() + shown.count());
  out.push_back(size);
  out.push_back(at.ref());
}

void Outline::stopNoting() {
  isNoting_ = false;
  forgetBefore(now());
}

void Outline::forgetBefore(std::uint64_t moment) {
  for (; forgotten_ < moment; ++forgotten_) notes_.pop_front();
}

void Outline::goBack(const Grid& grid, std::uint64_t moment, std::uint64_t version, Undone undone, Changes& changes) {
  std::vector<std::uint32_t> ids;
  for (std::uint64_t k = moment; k < now(); ++k) addTo(ids, notes_[k - forgotten_].changes);
  go(grid, std::move(ids), version, changes, [&] {
    for (; now() > moment; notes_.pop_back()) {
      if (undone == Undone::keep) undone_.push_back(kept(grid, notes_.back()));
      undo(grid, notes_.back());
      if (undone == Undone::keep) undone_.back().note = std::move(notes_.back());
    }
  });
}

void Outline::goForward(const Grid& grid, std::uint64_t moment, std::uint64_t version, Changes& changes) {
  std::vector<std::uint32_t> ids;
  for (std::uint64_t k = 0; k < moment - now(); ++k) addTo(ids, undone_[undone_.size() - 1 - k].note.changes);
  go(grid, std::move(ids), version, changes, [&] {
    for (; now() < moment; undone_.pop_back()) redo(grid, undone_.back());
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

void Outline::undo(const Grid& grid, const Note& note) {
  for (const std::uint32_t chunk : note.turned) toggleHidden(chunk);
  for (const SegmentId id : note.changes.added) segments[id.value].cellRef = 0;
  putLists(grid, note.lists);
  for (auto old = note.segments.rbegin(); old != note.segments.rend(); ++old) segments[old->first] = old->second;
  segments.giveBack(note.changes.added, note.topBefore, note.removedBefore.size());
  changes_.removed = note.removedBefore;
}

/// The lists as they were noted, the first note of each last.
void Outline::putLists(const Grid& grid, const std::vector<std::uint32_t>& noted) {
  for (std::size_t end = noted.size(); end != 0;) {
    const CellAt at = grid.find(noted[end - 1]);
    const std::uint32_t size = noted[end - 2];
    end -= 2 + std::size_t{size};
    const std::uint32_t now = lists.of(at).count(), then = size - Layout::kWords;
    if (now == 0 && then == 0) continue;
    if (std::uint32_t* words = lists.splice(at, 0, now, then))
      std::copy_n(noted.begin() + static_cast<std::ptrdiff_t>(end), size, words);
  }
}

/// Before an update is undone: what it changed, as it is after it; without the note.
Outline::UndoneNote Outline::kept(const Grid& grid, const Note& note) const {
  UndoneNote undone;
  for (const SegmentId id : note.changes.added) undone.segments.emplace_back(id.value, segments[id.value]);
  for (const auto& old : note.segments) undone.segments.emplace_back(old.first, segments[old.first]);
  for (std::size_t end = note.lists.size(); end != 0; end -= 2 + std::size_t{note.lists[end - 2]})
    noteList(grid.find(note.lists[end - 1]), undone.lists);
  return undone;
}

/// The same update again: it takes the same ids, as the same are available.
void Outline::redo(const Grid& grid, UndoneNote& undone) {
  for (const std::uint32_t chunk : undone.note.turned) toggleHidden(chunk);
  for (const SegmentId id : undone.note.removedBefore) segments.recycle(id.value);
  for (std::size_t k = undone.note.changes.added.size(); k != 0; --k) segments.take();
  putLists(grid, undone.lists);
  for (const auto& [id, record] : undone.segments) segments[id] = record;
  changes_.removed = undone.note.changes.removed;
  notes_.push_back(std::move(undone.note));
}

std::uint64_t Outline::bytes() const {
  std::uint64_t sum =
      segments.bytes() + lists.bytes() + bytesOf(changes_) + bytesOf(shown_) + heldBytes(hidden_, turned_, ids_, fan_);
  const auto bytesOfNote = [&](const Note& n) {
    return sizeof n + bytesOf(n.changes) + heldBytes(n.removedBefore, n.segments, n.lists, n.turned);
  };
  for (const Note& n : notes_) sum += bytesOfNote(n);
  for (const UndoneNote& u : undone_)
    sum += sizeof u - sizeof u.note + bytesOfNote(u.note) + heldBytes(u.segments, u.lists);
  return sum;
}

}  // namespace lgs::detail
