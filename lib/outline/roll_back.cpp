// The outline's part of roll-back and redo: what an update notes, and what a note is exchanged with.
#include "geometry/sort.h"
#include "outline/outline.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>
#include <iterator>
#include <optional>
#include <utility>

namespace lgs::detail {
namespace {

using RecordWords = std::array<std::uint32_t, sizeof(SegmentRecord) / sizeof(std::uint32_t)>;

RecordWords wordsOf(const SegmentRecord& record) {
  RecordWords words{};
  std::memcpy(words.data(), &record, sizeof record);
  return words;
}

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

SeenById seenNow(const Grid& grid, const Outline& outline, const std::vector<std::uint32_t>& ids) {
  SeenById seen(ids.size());
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const std::uint32_t id = ids[k];
    if (!outline.isShown({id})) continue;
    const SegmentRecord& s = outline.segments[id];
    const Cell cell = grid.cellOf(s.cellRef);
    const auto cellOf = [&](const SegmentRecord& ghost) {  // mostly the same one
      return ghost.cellRef == s.cellRef ? cell : grid.cellOf(ghost.cellRef);
    };
    Seen& now = seen[k].emplace(toWorld(cell, s.start()), toWorld(cell, s.end()), s.block, s.cellRef, s.serial);
    const SegmentRecord &before = outline.segments[s.predecessor], &after = outline.segments[s.successor];
    if (s.predecessor != kNoSegment) now.ghost1 = toWorld(cellOf(before), before.start());
    if (s.successor != kNoSegment) now.ghost2 = toWorld(cellOf(after), after.end());
  }
  return seen;
}

}  // namespace

// --- Taking notes

void Outline::noteSegment(std::uint32_t id) {
  if (!journal_->isNoted(Thing::segment, id))
    journal_->add(Thing::segment, id).value = journal_->keep(wordsOf(segments[id]));
}

void Outline::noteAdded() {
  for (const SegmentId id : changes_.added)
    if (!journal_->isNoted(Thing::segment, id.value)) journal_->add(Thing::segment, id.value);
}

void Outline::noteList(CellAt at) {
  if (journal_->isNoted(Thing::list, at.ref())) return;
  const CellSegments list = lists.of(at);
  journal_->add(Thing::list, at.ref()).value = list ? journal_->keep(list.words()) : 0;
}

void Outline::noteHidden(std::uint32_t chunk) {
  if (!journal_->isNoted(Thing::hidden, chunk)) journal_->add(Thing::hidden, chunk).value = hidden_.are(chunk) ? 1 : 0;
}

/// And the place in the list of free ids that this one gets.
void Outline::noteRemoved(std::uint32_t id) {
  noteSegment(id);
  const auto place = static_cast<std::uint32_t>(segments.free().size());
  if (place < segments.places().size() && !journal_->isNoted(Thing::freeId, place))
    journal_->add(Thing::freeId, place).value = segments.places()[place];
}

// --- Roll-back and redo

void Outline::exchange(const Grid& grid, Journal& journal, Note& note) {
  if (note.thing == Thing::segment) {
    SegmentRecord& record = segments[note.key];
    const RecordWords now = wordsOf(record);
    if (note.value == 0) {
      note.value = journal.keep(now);
      record.cellRef = 0;
      return;
    }
    const std::span<std::uint32_t> then = journal.kept(note.value);
    std::memcpy(&record, then.data(), sizeof record);
    std::ranges::copy(now, then.begin());
  } else if (note.thing == Thing::list) {
    const CellAt at = grid.find(note.key);
    const CellSegments list = lists.of(at);
    const std::uint32_t now = list.count(), kept = list ? journal.keep(list.words()) : 0;
    const std::span then = note.value != 0 ? journal.kept(note.value) : std::span<std::uint32_t>();
    if (list || note.value != 0) {
      const auto count = static_cast<std::uint32_t>(then.size() - (then.empty() ? 0 : Layout::kWords));
      if (std::uint32_t* words = lists.splice(at, 0, now, count)) std::ranges::copy(then, words);
    }
    journal.release(note.value);
    note.value = kept;
  } else if (note.thing == Thing::freeId) {
    std::swap(segments.places()[note.key], note.value);
  } else {
    assert(note.thing == Thing::hidden);
    const bool then = note.value != 0, now = hidden_.are(note.key);
    note.value = now ? 1 : 0;
    if (then != now) hidden_.toggle(note.key);
  }
}

void Outline::goTo(const Grid& grid, const State& state, std::vector<std::uint32_t> ids, Changes& changes,
                   const std::function<void()>& go, const std::function<bool()>& stream) {
  detail::sort(ids);
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());  // clang 14 does not take the one of std::ranges
  const SeenById before = seenNow(grid, *this, ids);
  const std::uint64_t version = version_;
  go();
  segments.setLength(state.ids);
  version_ = state.version;
  changes = {};
  const bool isStreamed = stream();
  if (isStreamed) {  // what is not noted was until then as it was before
    const auto take = [&](const std::vector<SegmentId>& of, std::vector<SegmentId>& to) {
      std::ranges::copy_if(of, std::back_inserter(to),
                           [&](SegmentId id) { return !std::ranges::binary_search(ids, id.value); });
    };
    take(this->changes().removed, changes.removed);
    take(this->changes().added, changes.added);
    take(this->changes().relinked, changes.relinked);
  }
  const SeenById after = seenNow(grid, *this, ids);
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const SegmentId id{ids[k]};
    const auto &then = before[k], &now = after[k];
    const bool same = then && now && then->isSameEdge(*now);
    if (then && !same) changes.removed.push_back(id);
    if (now && !same) changes.added.push_back(id);
    if (same && (then->ghost1 != now->ghost1 || then->ghost2 != now->ghost2)) changes.relinked.push_back(id);
  }
  if (isStreamed)
    for (auto* list : {&changes.removed, &changes.added, &changes.relinked}) detail::sort(*list);
  changes.before = version;
  changes.after = version_;
}

}  // namespace lgs::detail
