// Notes in the order in which they were made. The first ones can be forgotten, and the last ones taken back. A note has
// its number for good: how many were made before it and not taken back.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace lgs::detail {

template <class Note>
class Journal {
 public:
  /// The number of the next one.
  std::uint64_t next() const { return gone_ + notes_.size(); }
  /// Any that is not forgotten.
  Note& operator[](std::uint64_t number) { return notes_[index(number)]; }
  const Note& operator[](std::uint64_t number) const { return notes_[index(number)]; }
  Note& back() { return notes_.back(); }
  /// From this one on.
  std::span<Note> from(std::uint64_t number) { return std::span(notes_).subspan(index(number)); }

  Note& add(Note note = {}) { return notes_.emplace_back(std::move(note)); }
  Note takeBack() {
    Note last = std::move(notes_.back());
    notes_.pop_back();
    return last;
  }
  /// Those from this one on are taken back.
  void cut(std::uint64_t number) {
    notes_.erase(notes_.begin() + static_cast<std::ptrdiff_t>(index(number)), notes_.end());
  }
  /// Those before this one. Calls drop(note) for each first.
  template <class Drop>
  void forgetBefore(std::uint64_t number, Drop&& drop) {
    for (; gone_ + forgotten_ < number; ++forgotten_) drop(notes_[forgotten_]);
    if (forgotten_ < notes_.size() / 2) return;  // the rest moves to the front seldom
    notes_.erase(notes_.begin(), notes_.begin() + static_cast<std::ptrdiff_t>(forgotten_));
    gone_ += std::exchange(forgotten_, 0);
  }
  /// Gives the memory back, once all notes are forgotten.
  void giveBack() {
    assert(notes_.empty());
    notes_ = std::vector<Note>();
  }

  std::size_t capacity() const { return notes_.capacity(); }
  /// Without what the notes hold themselves.
  std::uint64_t bytes() const { return capacity() * sizeof(Note); }
  /// Those that have memory: with the forgotten ones that are still there.
  std::span<const Note> held() const { return notes_; }

 private:
  std::size_t index(std::uint64_t number) const { return static_cast<std::size_t>(number - gone_); }

  std::vector<Note> notes_;
  std::size_t forgotten_ = 0;  ///< at the front
  std::uint64_t gone_ = 0;     ///< from the front
};

}  // namespace lgs::detail
