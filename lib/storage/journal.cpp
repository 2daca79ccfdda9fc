#include "storage/journal.h"

#include "storage/vectors.h"

#include <cassert>
#include <set>

namespace lgs::detail {

Journal::Moment Journal::begin() {
  places_.push_back({++last_, notes_.size()});
  return latest_ = last_;
}

std::size_t Journal::indexOf(Moment moment) const {
  const auto found = std::ranges::lower_bound(places_, moment, {}, &Place::moment);
  assert(found != places_.end() && found->moment == moment);
  return static_cast<std::size_t>(found - places_.begin());
}

bool Journal::isAhead(Moment moment) const { return std::ranges::find(ahead_, moment, &Place::moment) != ahead_.end(); }

std::span<const Note> Journal::upTo(Moment moment) const {
  const auto found = std::ranges::find(ahead_, moment, &Place::moment);
  assert(found != ahead_.end());
  return std::span(undone_).subspan(found->begin);
}

Note& Journal::add(Thing thing, std::uint32_t key) {
  assert(isOn());
  const std::uint64_t before = newest_.set(hashOf(thing, key), latest_);
  return notes_.emplace_back(Note{.before = before, .key = key, .thing = thing});
}

/// A note is undone: its thing is noted last where it was before this.
void Journal::takeBack(const Note& note) {
  const std::uint64_t hash = hashOf(note.thing, note.key);
  if (note.before < places_.front().moment)
    newest_.erase(hash);
  else
    newest_.set(hash, note.before);
}

void Journal::addUndone(const Note& note) {
  undone_.push_back(note);
  if (note.thing != Thing::cell) return;
  const std::uint64_t hash = hashOf(note.thing, note.key);
  timesUndone_.set(hash, timesUndone_.find(hash) + 1);
}

Note Journal::takeUndone() {
  const Note note = undone_.back();
  undone_.pop_back();
  if (note.thing != Thing::cell) return note;
  const std::uint64_t hash = hashOf(note.thing, note.key), times = timesUndone_.find(hash);
  if (times == 1)
    timesUndone_.erase(hash);
  else
    timesUndone_.set(hash, times - 1);
  return note;
}

std::uint32_t Journal::keep(std::span<const std::uint32_t> words) {
  const RecordArena::Ref reference = words_.allocate(static_cast<std::uint32_t>(1 + words.size()));
  std::uint32_t* to = words_.at(reference);
  *to = static_cast<std::uint32_t>(words.size());
  std::ranges::copy(words, to + 1);
  return reference;
}

/// No note is needed any more. The memory for a few notes stays, for groups of edits.
void Journal::stop() {
  assert(undone_.empty() && newest_.count() == 0);
  constexpr std::size_t kFew = 4'096;
  twice_ = dropped_ = 0;
  if (notes_.capacity() > kFew || newest_.bytes() > kFew * sizeof(Note)) {
    notes_ = std::vector<Note>();
    newest_ = HashIndex();
    words_ = RecordArena();
  }
  notes_.clear();
}

bool Journal::isValid() const {
  std::set<std::uint64_t> hashes;
  for (const Note& note : notes()) hashes.insert(hashOf(note.thing, note.key));
  for (const std::uint64_t hash : hashes)
    if (newest_.find(hash) < places_.front().moment) return false;
  const auto isInOrder = [](const Place& a, const Place& b) { return a.moment < b.moment && a.begin <= b.begin; };
  for (const Note& note : undone_)
    if (note.thing == Thing::cell && timesUndone_.find(hashOf(note.thing, note.key)) == 0) return false;
  for (std::size_t k = 1; k < places_.size(); ++k)
    if (!isInOrder(places_[k - 1], places_[k])) return false;
  return newest_.count() == hashes.size() && latest_ == (places_.empty() ? 0 : places_.back().moment) &&
         (places_.empty() || places_.front().begin == dropped_);
}

std::uint64_t Journal::bytes() const {
  return heldBytes(notes_, places_, undone_, ahead_) + newest_.bytes() + timesUndone_.bytes() + words_.bytes();
}

}  // namespace lgs::detail
