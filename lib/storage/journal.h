// The one journal of a world: what things held before they changed, so that the world can roll back to a *moment*, and
// forward again.
//
// A thing is a cell, a list of segments, and so on: a kind and a key. The world never rolls back to between two moments
// that follow each other, so each thing is noted once between them, before its first change. Whether that is so already is a
// comparison of numbers: moments are numbered, and of each thing it is known after which one it was noted last. A note
// keeps the number that it displaced.
//
// To undo a note is to exchange what it says with what the thing holds. The note then says what the thing held later,
// so the same exchange, in the other direction, does it again.
//
// When a moment is let go of, the notes after it join those before it, and those of things that are there twice
// are dropped: of a few behind many at once, otherwise when they are many. So that costs O(log n) a note in all, and
// an old mark with many notes behind it costs no later edit anything.
#pragma once

#include "storage/hash_index.h"
#include "storage/record_arena.h"
#include "storage/vectors.h"

#include <lgs/world.h>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace lgs::detail {

/// What a note is of. The key is a reference of a cell, the number of a chunk, the id of a segment, or a place in the
/// list of free ids.
enum class Thing : std::uint8_t {
  cell,      ///< the word of a cell, and its block
  chunk,     ///< that there is this chunk; the note has its place
  streamed,  ///< that a commit renewed a chunk's outline, because it or one beside it came or went
  segment,   ///< the record of a segment; none if it was not alive
  list,      ///< the list of segments that a cell shows; none if it showed nothing
  freeId,    ///< an entry in the list of free ids
  hidden,    ///< whether the segments of a chunk are hidden
  commit,    ///< that a commit found something
};

struct Note {
  std::uint64_t before = 0;  ///< the moment after which the thing was noted before this; 0 if there is no such note
  std::uint32_t key = 0;
  Thing thing = Thing::cell;
  bool wasClean = false;    ///< of a cell: it had not changed since the commit before
  bool isMoot = false;      ///< of a chunk: undone while unloaded, so the chunk stays, and this does nothing
  bool isGivenUp = false;   ///< of a chunk: it came back empty, at all times, so outlines of before are not its own
  std::uint32_t value = 0;  ///< what the thing held, or a reference to words that the journal keeps
  std::uint32_t block = 0;  ///< of a cell
};

class Journal {
 public:
  /// The number of a moment. Later ones have greater numbers, and so have those of a copy.
  using Moment = std::uint64_t;

  /// Whether there is a moment to roll back to, so that what changes is to be noted.
  bool isOn() const { return latest_ != 0; }

  // --- Moments

  /// Now, as a moment to roll back to until letGo().
  Moment begin();
  /// One user more for a moment that is there.
  void hold(Moment moment) { ++places_[indexOf(moment)].users; }
  /// One less. Calls drop(note) for each note that is not needed from here on.
  template <class Drop>
  void letGo(Moment moment, Drop&& drop);
  bool has(Moment moment) const { return std::ranges::binary_search(places_, moment, {}, &Place::moment); }
  /// Whether the one was before the other, and something was noted in between.
  bool isEarlier(Moment a, Moment b) const { return places_[indexOf(a)].begin < places_[indexOf(b)].begin; }

  // --- Notes

  /// Whether a thing was noted since a moment that is there.
  bool isNotedSince(Moment moment, Thing thing, std::uint32_t key) const {
    return newest_.find(hashOf(thing, key)) >= moment;
  }
  /// Whether it was since the latest one. Then no note is needed.
  bool isNoted(Thing thing, std::uint32_t key) const {
    assert(isOn());
    return isNotedSince(latest_, thing, key);
  }
  /// Whether there is a note of a cell, undone or not.
  bool isCellNoted(std::uint32_t ref) const {
    const std::uint64_t hash = hashOf(Thing::cell, ref);
    return newest_.find(hash) != 0 || timesUndone_.find(hash) != 0;
  }
  /// Before a thing changes that is not noted: the caller says what it holds.
  Note& add(Thing thing, std::uint32_t key);
  /// The same, unless it is noted: then null.
  Note* addOnce(Thing thing, std::uint32_t key) { return isNoted(thing, key) ? nullptr : &add(thing, key); }
  /// Those since a moment, in the order in which they were made. The first of a thing, which says what it held at that
  /// moment, displaced a note of before it.
  std::span<const Note> since(Moment moment) const { return std::span(notes_).subspan(places_[indexOf(moment)].begin); }

  /// All that are there.
  std::span<const Note> notes() const { return std::span(notes_).subspan(dropped_); }
  std::span<Note> notes() { return std::span(notes_).subspan(dropped_); }
  /// What was undone and can come back, the first to come back last.
  std::span<const Note> undone() const { return undone_; }
  std::span<Note> undone() { return undone_; }
  /// Whether moments and notes are in order.
  bool isValid() const;

  /// Words that a note refers to. 0 refers to none.
  std::uint32_t keep(std::span<const std::uint32_t> words);
  std::span<std::uint32_t> kept(std::uint32_t reference) const {
    assert(reference != 0);
    return {words_.at(reference) + 1, *words_.at(reference)};
  }
  void release(std::uint32_t reference) {
    if (reference != 0) words_.release(reference, 1 + *words_.at(reference));
  }

  // --- Roll-back and redo

  /// Calls exchange(note) for each note since a moment, the last one first. They are kept, with the moments in between,
  /// or dropped: then nothing holds these moments.
  template <class Exchange, class Drop>
  void undoTo(Moment moment, Undone undone, Exchange&& exchange, Drop&& drop);
  /// To a moment that is ahead: undone, and kept.
  template <class Exchange, class Drop>
  void redoTo(Moment moment, Exchange&& exchange, Drop&& drop);
  bool isAhead(Moment moment) const;
  /// The notes up to a moment that is ahead, the next one last.
  std::span<const Note> upTo(Moment moment) const;
  template <class Drop>
  void forgetUndone(Drop&& drop);

  std::uint64_t bytes() const;

 private:
  /// A moment, and which of the notes was the next one then.
  struct Place {
    Moment moment = 0;
    std::size_t begin = 0;  ///< in notes_; of one ahead: how many undone notes lie beyond it
    std::uint32_t users = 1;
  };

  /// No two things have the same one.
  std::uint64_t hashOf(Thing thing, std::uint32_t key) const {
    return mix(seed_, std::uint64_t{static_cast<std::uint8_t>(thing)} << 32 | key);
  }
  std::size_t indexOf(Moment moment) const;
  std::size_t endOf(std::size_t place) const {
    return place + 1 < places_.size() ? places_[place + 1].begin : notes_.size();
  }
  void takeBack(const Note& note);
  void addUndone(const Note& note);
  Note takeUndone();
  void stop();
  template <class Drop>
  void dropOldest(std::size_t end, Drop&& drop);
  template <class Drop>
  void dropTwice(std::size_t from, Drop&& drop);

  std::vector<Note> notes_;
  std::size_t dropped_ = 0;    ///< of the first ones
  std::vector<Place> places_;  ///< by moment
  Moment latest_ = 0;          ///< 0 if there is none
  Moment last_ = 0;            ///< that was given out
  std::uint64_t seed_ = anySeed(this);
  HashIndex newest_;       ///< of each thing that is noted, the moment after which it was noted last
  std::size_t twice_ = 0;  ///< at most so many notes are of things that are noted before, with no moment in between
  RecordArena words_;
  // What was undone and can come back, the first to come back last.
  std::vector<Note> undone_;
  std::vector<Place> ahead_;
  HashIndex timesUndone_;  ///< of each cell that they are of: how many they are
};

template <class Drop>
void Journal::letGo(Moment moment, Drop&& drop) {
  const std::size_t k = indexOf(moment);
  if (--places_[k].users != 0) return;
  const std::size_t begin = places_[k].begin, end = endOf(k);
  places_.erase(places_.begin() + static_cast<std::ptrdiff_t>(k));
  giveBackSpare(places_);
  latest_ = places_.empty() ? 0 : places_.back().moment;
  if (k == 0) return dropOldest(end, drop);
  const std::size_t count = end - begin, countBefore = begin - places_[k - 1].begin;
  if (end == notes_.size() && count <= countBefore) return dropTwice(begin, drop);
  twice_ += std::min(count, countBefore);
  if (2 * twice_ < notes_.size() - dropped_) return;
  dropTwice(dropped_, drop);
  twice_ = 0;
}

/// Notes before the first moment that is left.
template <class Drop>
void Journal::dropOldest(std::size_t end, Drop&& drop) {
  for (; dropped_ < end; ++dropped_) {
    const Note& note = notes_[dropped_];
    const std::uint64_t hash = hashOf(note.thing, note.key);
    const Moment noted = newest_.find(hash);
    if (noted != 0 && (places_.empty() || noted < places_.front().moment)) newest_.erase(hash);
    drop(note);
  }
  if (places_.empty()) return stop();
  if (dropped_ < notes_.size() / 2) return;  // the rest moves to the front seldom
  notes_.erase(notes_.begin(), notes_.begin() + static_cast<std::ptrdiff_t>(dropped_));
  for (Place& place : places_) place.begin -= dropped_;
  dropped_ = 0;
}

/// From a note on, drops the notes of things that are noted before, with no moment in between.
template <class Drop>
void Journal::dropTwice(std::size_t from, Drop&& drop) {
  std::size_t kept = from, next = 0;
  while (next < places_.size() && places_[next].begin < from) ++next;
  for (std::size_t k = from; k <= notes_.size(); ++k) {
    for (; next < places_.size() && places_[next].begin == k; ++next) places_[next].begin = kept;
    if (k == notes_.size()) break;
    if (next != 0 && notes_[k].before >= places_[next - 1].moment)
      drop(notes_[k]);
    else
      notes_[kept++] = notes_[k];
  }
  notes_.resize(kept);
}

template <class Exchange, class Drop>
void Journal::undoTo(Moment moment, Undone undone, Exchange&& exchange, Drop&& drop) {
  const std::size_t to = indexOf(moment);
  const auto leaveMoments = [&] {
    for (; undone == Undone::keep && places_.size() > to + 1 && places_.back().begin == notes_.size();
         places_.pop_back())
      ahead_.push_back({places_.back().moment, undone_.size(), places_.back().users});
  };
  for (leaveMoments(); notes_.size() > places_[to].begin; leaveMoments()) {
    Note note = notes_.back();
    notes_.pop_back();
    takeBack(note);
    exchange(note);
    if (undone == Undone::keep)
      addUndone(note);
    else
      drop(note);
  }
  assert(places_.back().begin == notes_.size());
  latest_ = places_.back().moment;
}

template <class Exchange, class Drop>
void Journal::redoTo(Moment moment, Exchange&& exchange, Drop&& drop) {
  assert(isAhead(moment));
  do {
    while (undone_.size() > ahead_.back().begin) {
      Note note = takeUndone();
      exchange(note);
      if (isNoted(note.thing, note.key)) {
        drop(note);
        continue;
      }
      Note& again = add(note.thing, note.key);
      note.before = again.before;
      again = note;
    }
    places_.push_back({ahead_.back().moment, notes_.size(), ahead_.back().users});
    latest_ = places_.back().moment;
    ahead_.pop_back();
  } while (latest_ != moment);
}

template <class Drop>
void Journal::forgetUndone(Drop&& drop) {
  for (const Note& note : undone_) drop(note);
  undone_ = std::vector<Note>();
  timesUndone_ = HashIndex();
  ahead_.clear();
}

}  // namespace lgs::detail
