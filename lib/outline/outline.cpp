#include "outline/outline.h"

#include "geometry/sort.h"

#include <algorithm>
#include <map>
#include <optional>

namespace lgs::detail {
namespace {

/// What a segment is as far as law 6 goes, and where its ghosts are.
struct Seen {
  Point start, end;
  Block block;
  std::uint32_t cellRef, serial;
  std::optional<Point> ghost1, ghost2;

  bool isSameEdge(const Seen& s) const {
    return start == s.start && end == s.end && block == s.block && cellRef == s.cellRef && serial == s.serial;
  }
};

/// Segments by id, where they are alive.
using SeenById = std::map<std::uint32_t, std::optional<Seen>>;

void look(const Grid& grid, const Outline& outline, SeenById& seen) {
  for (auto& [id, now] : seen) {
    now.reset();
    if (!outline.segments.isLive(id)) continue;
    const SegmentRecord& s = outline.segments[id];
    now = Seen{outline.startOf(grid, id), outline.endOf(grid, id), s.block, s.cellRef, s.serial, {}, {}};
    if (s.predecessor != kNoSegment) now->ghost1 = outline.startOf(grid, s.predecessor);
    if (s.successor != kNoSegment) now->ghost2 = outline.endOf(grid, s.successor);
  }
}

}  // namespace

Outline::Outline(const Outline& other)
    : segments(other.segments),
      lists(other.lists),
      changes_(other.changes_),
      versions_(other.versions_),
      version_(other.version_),
      notes_(other.notes_),
      forgotten_(other.forgotten_),
      isNoting_(other.isNoting_) {}

std::span<const SegmentId> Outline::createIds(std::size_t count) {
  changes_.added.reserve(count);
  for (; count != 0; --count) changes_.added.push_back({segments.take()});
  return changes_.added;
}

void Outline::load(std::uint32_t count, std::vector<std::uint32_t> free, std::span<const std::uint32_t> removed) {
  segments.reset(count, std::move(free));
  for (const std::uint32_t id : removed) changes_.removed.push_back({id});
}

void Outline::noteList(CellAt at) {
  const CellSegments shown = lists.of(at);
  std::vector<std::uint32_t>& out = note_->lists;
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

void Outline::goBack(const Grid& grid, std::uint64_t moment, std::uint64_t version, Changes& changes) {
  SeenById before;
  for (auto note = notes_.begin() + static_cast<std::ptrdiff_t>(moment - forgotten_); note != notes_.end(); ++note)
    for (const auto* ids : {&note->changes.removed, &note->changes.added, &note->changes.relinked})
      for (const SegmentId id : *ids) before.try_emplace(id.value);
  SeenById after = before;
  look(grid, *this, before);
  for (; now() > moment; notes_.pop_back()) undo(grid, notes_.back());
  look(grid, *this, after);
  changes = {};
  for (auto then = before.begin(), now = after.begin(); then != before.end(); ++then, ++now) {
    const SegmentId id{then->first};
    const bool same = then->second && now->second && then->second->isSameEdge(*now->second);
    if (then->second && !same) changes.removed.push_back(id);
    if (now->second && !same) changes.added.push_back(id);
    if (same && (then->second->ghost1 != now->second->ghost1 || then->second->ghost2 != now->second->ghost2))
      changes.relinked.push_back(id);
  }
  changes.before = version_;
  if (!changes.removed.empty() || !changes.added.empty() || !changes.relinked.empty()) version_ = version;
  changes.after = version_;
}

void Outline::undo(const Grid& grid, const Note& note) {
  for (const SegmentId id : note.changes.added) segments[id.value].cellRef = 0;
  for (std::size_t end = note.lists.size(); end != 0;) {
    const CellAt at = grid.find(note.lists[end - 1]);
    const std::uint32_t size = note.lists[end - 2];
    end -= 2 + std::size_t{size};
    const std::uint32_t now = lists.of(at).count(), then = size - Layout::kWords;
    if (now == 0 && then == 0) continue;
    if (std::uint32_t* words = lists.splice(at, 0, now, then))
      std::copy_n(note.lists.begin() + static_cast<std::ptrdiff_t>(end), size, words);
  }
  for (auto old = note.segments.rbegin(); old != note.segments.rend(); ++old) segments[old->first] = old->second;
  segments.giveBack(note.changes.added, note.topBefore, note.removedBefore.size());
  changes_.removed = note.removedBefore;
}

std::uint64_t Outline::bytes() const {
  const auto of = [](const auto&... v) { return (... + (v.capacity() * sizeof(v[0]))); };
  std::uint64_t sum = segments.bytes() + lists.bytes() + bytesOf(changes_) + of(ids_, fan_);
  for (const Note& n : notes_) sum += sizeof n + bytesOf(n.changes) + of(n.removedBefore, n.segments, n.lists);
  return sum;
}

}  // namespace lgs::detail
