#include "outline/segment_notes.h"

#include "storage/held_bytes.h"

namespace lgs::detail {

void NotedLists::giveBackSpare() {
  lists_.shrink_to_fit();
  words_.shrink_to_fit();
}

std::uint64_t NotedLists::bytes() const { return heldBytes(lists_, words_); }

void SegmentNote::addTo(std::vector<std::uint32_t>& ids) const {
  ids.insert(ids.end(), added.begin(), added.end());
  for (const auto& segment : segments) ids.push_back(segment.first);
}

std::uint64_t SegmentNote::bytes() const {
  return heldBytes(removedBefore, freeTaken, added, turned, segments) + lists.bytes();
}

void SegmentNotes::stop() {
  areTaken_ = false;
  forgetBefore(now());
  notes_.giveBack();
  notedSegments_ = {};
  notedLists_ = {};
}

void SegmentNotes::forgetBefore(std::uint64_t moment) {
  if (opened_ <= moment) close();
  notes_.forgetBefore(moment, [](SegmentNote& note) { note = {}; });
}

void SegmentNotes::squeeze(std::uint64_t moment) {
  if (now() == moment || opened_ == now()) return;
  if (now() == moment + 1) return open();
  const SegmentNote last = notes_.takeBack();
  if (opened_ != now()) open();
  merge(notes_.back(), last);
}

/// The last note has each segment and each list once from here on, and can take over later ones.
void SegmentNotes::open() {
  close();
  opened_ = now();
  SegmentNote note = std::exchange(notes_.back(), {});
  notes_.back().removedBefore = std::move(note.removedBefore);
  notes_.back().topBefore = note.topBefore;
  notes_.back().freeKept = note.freeKept + note.freeTaken.size();
  merge(notes_.back(), note);
}

void SegmentNotes::close() {
  if (opened_ == 0) return;
  SegmentNote& note = notes_[std::exchange(opened_, 0) - 1];
  for (const std::uint32_t id : note.added) notedSegments_.erase(id);
  for (const auto& segment : note.segments) notedSegments_.erase(segment.first);
  note.lists.forEach([&](std::uint32_t cellRef, auto) { notedLists_.erase(cellRef); });
  for (auto* list : {&note.freeTaken, &note.added, &note.turned}) list->shrink_to_fit();
  note.segments.shrink_to_fit();
  note.lists.giveBackSpare();
}

/// The open note takes over the next one.
void SegmentNotes::merge(SegmentNote& into, const SegmentNote& next) {
  if (next.freeKept < into.freeKept) {
    const auto count = static_cast<std::ptrdiff_t>(into.freeKept - next.freeKept);
    into.freeTaken.insert(into.freeTaken.end(), next.freeTaken.end() - count, next.freeTaken.end());
    into.freeKept = next.freeKept;
  }
  for (const std::uint32_t id : next.added)
    if (notedSegments_.insert(id)) into.added.push_back(id);
  for (const auto& segment : next.segments)
    if (notedSegments_.insert(segment.first)) into.segments.push_back(segment);
  into.turned.insert(into.turned.end(), next.turned.begin(), next.turned.end());
  next.lists.forEach([&](std::uint32_t cellRef, std::span<const std::uint32_t> words) {
    if (notedLists_.insert(cellRef)) into.lists.add(cellRef, words);
  });
}

std::uint64_t SegmentNotes::bytes() const {
  std::uint64_t sum = notes_.bytes() + notedSegments_.bytes() + notedLists_.bytes();
  for (const SegmentNote& note : notes_.held()) sum += note.bytes();
  return sum;
}

}  // namespace lgs::detail
