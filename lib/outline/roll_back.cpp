// The outline's part of roll-back and redo: what an update notes, and what a note is exchanged with.
#include "outline/outline.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>
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

}  // namespace

// --- Taking notes

void Outline::noteSegment(std::uint32_t id) {
  if (Note* note = journal_->addOnce(Thing::segment, id)) note->value = journal_->keep(wordsOf(segments[id]));
}

void Outline::noteAdded() {
  for (const SegmentId id : changes_.added) journal_->addOnce(Thing::segment, id.value);
}

void Outline::noteList(CellAt at) {
  Note* note = journal_->addOnce(Thing::list, at.ref());
  if (note == nullptr) return;
  if (const CellSegments list = lists.of(at)) note->value = journal_->keep(list.words());
}

/// And the place in the list of free ids that this one gets.
void Outline::noteRemoved(std::uint32_t id) {
  noteSegment(id);
  const auto place = static_cast<std::uint32_t>(segments.free().size());
  if (place >= segments.places().size()) return;
  if (Note* note = journal_->addOnce(Thing::freeId, place)) note->value = segments.places()[place];
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
    const bool then = note.value != 0;
    note.value = hides(note.key) ? 1 : 0;
    setHidden(note.key, then);
  }
}

std::vector<std::optional<Outline::Seen>> Outline::seen(const Grid& grid, const std::vector<std::uint32_t>& ids) const {
  std::vector<std::optional<Seen>> seen(ids.size());
  for (std::size_t k = 0; k < ids.size(); ++k) {
    if (!isShown({ids[k]})) continue;
    const SegmentRecord& s = segments[ids[k]];
    const Cell cell = grid.cellOf(s.cellRef);
    const auto cellOf = [&](const SegmentRecord& ghost) {  // mostly the same one
      return ghost.cellRef == s.cellRef ? cell : grid.cellOf(ghost.cellRef);
    };
    Seen& now = seen[k].emplace(Seen{toWorld(cell, s.start()), toWorld(cell, s.end()), s.block, s.cellRef, s.serial});
    const SegmentRecord &before = segments[s.predecessor], &after = segments[s.successor];
    if (s.predecessor != kNoSegment) now.ghost1 = toWorld(cellOf(before), before.start());
    if (s.successor != kNoSegment) now.ghost2 = toWorld(cellOf(after), after.end());
  }
  return seen;
}

void Outline::compare(const Grid& grid, const std::vector<std::uint32_t>& ids,
                      const std::vector<std::optional<Seen>>& before, Changes& changes) const {
  const std::vector<std::optional<Seen>> after = seen(grid, ids);
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const SegmentId id{ids[k]};
    const auto &then = before[k], &now = after[k];
    const bool same = then && now && then->isSameEdge(*now);
    if (then && !same) changes.removed.push_back(id);
    if (now && !same) changes.added.push_back(id);
    if (same && (then->ghost1 != now->ghost1 || then->ghost2 != now->ghost2)) changes.relinked.push_back(id);
  }
}

}  // namespace lgs::detail
