// What the outline notes, so that it can go back, and forward again. Between two marks one note is enough: it has each
// segment and each list once, as it was before the first update that changed it.
#include "geometry/sort.h"
#include "outline/outline.h"
#include "storage/held_bytes.h"

#include <algorithm>
#include <iterator>
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

// --- Notes

/// The update under way has ended: what of the note is known by now.
void Outline::endNote() {
  Note& note = *std::exchange(note_, nullptr);
  for (const SegmentId id : changes_.added) note.added.push_back(id.value);
  // The ids that the update recycled were taken first, and then those that were available before.
  const std::size_t before = note.freeKept, recycled = note.removedBefore.size();
  note.freeKept = std::min(before, segments.free().size());
  for (std::size_t k = 0; k < before - note.freeKept; ++k) note.freeTaken.push_back(changes_.added[recycled + k].value);
}

void Outline::noteList(CellAt at, std::vector<std::uint32_t>& out) const {
  const CellSegments shown = lists.of(at);
  const std::uint32_t size = Layout::kWords + shown.count();
  out.insert(out.end(), shown.ids() - Layout::kWords, shown.ids() + shown.count());
  out.push_back(size);
  out.push_back(at.ref());
}

void Outline::squeeze(std::uint64_t moment) {
  if (now() == moment || opened_ == now()) return;
  if (now() == moment + 1) return openNote();
  Note last = std::move(notes_.back());
  notes_.pop_back();
  if (opened_ != now()) openNote();
  take(notes_.back(), last);
}

/// The last note has each segment and each list once from here on, and can take over later ones.
void Outline::openNote() {
  closeNote();
  opened_ = now();
  Note note = std::exchange(notes_.back(), {});
  notes_.back().removedBefore = std::move(note.removedBefore);
  notes_.back().topBefore = note.topBefore;
  notes_.back().freeKept = note.freeKept + note.freeTaken.size();
  take(notes_.back(), note);
}

void Outline::closeNote() {
  if (opened_ == 0) return;
  Note& note = notes_[static_cast<std::size_t>(std::exchange(opened_, 0) - 1 - forgotten_)];
  for (const std::uint32_t id : note.added) notedSegments_.erase(id);
  for (const auto& [id, record] : note.segments) notedSegments_.erase(id);
  for (std::size_t end = note.lists.size(); end != 0; end -= 2 + std::size_t{note.lists[end - 2]})
    notedLists_.erase(note.lists[end - 1]);
  for (auto* list : {&note.freeTaken, &note.added, &note.turned, &note.lists}) list->shrink_to_fit();
  note.segments.shrink_to_fit();
}

/// The open note takes over the next one.
void Outline::take(Note& open, const Note& next) {
  if (next.freeKept < open.freeKept) {
    const auto count = static_cast<std::ptrdiff_t>(open.freeKept - next.freeKept);
    open.freeTaken.insert(open.freeTaken.end(), next.freeTaken.end() - count, next.freeTaken.end());
    open.freeKept = next.freeKept;
  }
  for (const std::uint32_t id : next.added)
    if (notedSegments_.insert(id)) open.added.push_back(id);
  for (const auto& segment : next.segments)
    if (notedSegments_.insert(segment.first)) open.segments.push_back(segment);
  open.turned.insert(open.turned.end(), next.turned.begin(), next.turned.end());
  ids_.clear();  // where the lists end, the last one first
  for (std::size_t end = next.lists.size(); end != 0; end -= 2 + std::size_t{next.lists[end - 2]})
    ids_.push_back(static_cast<std::uint32_t>(end));
  for (; !ids_.empty(); ids_.pop_back()) {
    const auto end = next.lists.begin() + static_cast<std::ptrdiff_t>(ids_.back());
    if (notedLists_.insert(end[-1]))
      open.lists.insert(open.lists.end(), end - 2 - static_cast<std::ptrdiff_t>(end[-2]), end);
  }
}

/// All segments that it changed.
void Outline::Note::addTo(std::vector<std::uint32_t>& ids) const {
  ids.insert(ids.end(), added.begin(), added.end());
  for (const auto& segment : segments) ids.push_back(segment.first);
}

std::uint64_t Outline::Note::bytes() const {
  return heldBytes(removedBefore, freeTaken, added, turned, segments, lists);
}

void Outline::stopNoting() {
  isNoting_ = false;
  forgetBefore(now());
  notes_ = std::vector<Note>();
  notedSegments_ = {};
  notedLists_ = {};
}

void Outline::forgetBefore(std::uint64_t moment) {
  if (opened_ <= moment) closeNote();
  for (; forgotten_ + dropped_ < moment; ++dropped_) notes_[dropped_] = {};
  if (dropped_ < notes_.size() / 2) return;  // the rest moves to the front seldom
  notes_.erase(notes_.begin(), notes_.begin() + static_cast<std::ptrdiff_t>(dropped_));
  forgotten_ += std::exchange(dropped_, 0);
}

// --- Going back

void Outline::goBack(const Grid& grid, std::uint64_t moment, std::uint64_t version, Undone undone, Changes& changes) {
  closeNote();
  std::vector<std::uint32_t> ids;
  for (std::uint64_t k = moment; k < now(); ++k) notes_[static_cast<std::size_t>(k - forgotten_)].addTo(ids);
  go(grid, std::move(ids), version, changes, [&] {
    for (; now() > moment; notes_.pop_back()) {
      if (undone == Undone::keep) undone_.push_back(kept(grid, notes_.back()));
      undo(grid, notes_.back());
      if (undone == Undone::keep) undone_.back().note = std::move(notes_.back());
    }
  });
}

void Outline::goForward(const Grid& grid, std::uint64_t moment, std::uint64_t version, Changes& changes) {
  closeNote();
  std::vector<std::uint32_t> ids;
  for (std::size_t k = 0; k < moment - now(); ++k) undone_[undone_.size() - 1 - k].note.addTo(ids);
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
  for (const std::uint32_t id : note.added) segments[id].cellRef = 0;
  putLists(grid, note.lists);
  for (const auto& [id, record] : note.segments) segments[id] = record;
  segments.putBack(note.freeKept, note.freeTaken, note.topBefore);
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

/// Before something is undone: what it changed, as it is after it; without the note.
Outline::UndoneNote Outline::kept(const Grid& grid, const Note& note) const {
  UndoneNote undone;
  undone.removed = changes_.removed;
  undone.top = segments.maxId() + 1;
  const std::vector<std::uint32_t>& free = segments.free();
  undone.freeTaken.assign(free.rbegin(), free.rend() - static_cast<std::ptrdiff_t>(note.freeKept));
  for (const std::uint32_t id : note.added) undone.segments.emplace_back(id, segments[id]);
  for (const auto& old : note.segments) undone.segments.emplace_back(old.first, segments[old.first]);
  for (std::size_t end = note.lists.size(); end != 0; end -= 2 + std::size_t{note.lists[end - 2]})
    noteList(grid.find(note.lists[end - 1]), undone.lists);
  return undone;
}

/// The same update again: it takes the same ids, as the same are available.
void Outline::redo(const Grid& grid, UndoneNote& undone) {
  for (const std::uint32_t chunk : undone.note.turned) toggleHidden(chunk);
  segments.putBack(undone.note.freeKept, undone.freeTaken, undone.top);
  putLists(grid, undone.lists);
  for (const auto& [id, record] : undone.segments) segments[id] = record;
  changes_.removed = std::move(undone.removed);
  notes_.push_back(std::move(undone.note));
}

}  // namespace lgs::detail
