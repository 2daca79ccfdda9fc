// The marks of a world, and going back to them: ground and outline each note what they need to undo, and a mark says how
// far that goes.
#pragma once

#include "ground/ground.h"
#include "outline/outline.h"
#include "storage/versions.h"

#include <lgs/world.h>

#include <cstdint>
#include <vector>

namespace lgs::detail {

class History {
 public:
  History(Ground& ground, Outline& outline) : ground_(ground), outline_(outline) {}
  /// That of a copy, with its own ground and outline. Marks of groups are dropped: nobody could end them there.
  History(const History& other, Ground& ground, Outline& outline);
  History(const History&) = delete;
  History& operator=(const History&) = delete;
  ~History() = default;

  Mark mark(bool ofGroup = false);
  bool knows(Mark mark) const { return find(mark) != marks_.end(); }
  bool hasMarks() const { return !marks_.empty(); }

  // The mark must be known.
  /// It stays, and later ones are void. `changes` receives what this does to the segments.
  void rollBack(Mark mark, Changes& changes);
  /// The same in silence, where no commit changed something since: the segments are as they were at the mark.
  void takeBack(Mark mark);
  void forget(Mark mark);
  /// Whether a commit changed something since.
  bool committedSince(Mark mark) const { return find(mark)->outline != outline_.now(); }

  std::uint64_t bytes() const { return marks_.capacity() * sizeof marks_[0]; }

 private:
  struct Marked {
    Mark mark;
    Ground::Moment ground;
    std::uint64_t outline = 0;
    std::uint64_t version = 0;  ///< of the segments
    bool ofGroup = false;
  };

  std::vector<Marked>::const_iterator find(Mark mark) const;
  void forgetNotes();

  Ground& ground_;
  Outline& outline_;
  Versions numbers_;
  std::vector<Marked> marks_;  ///< in the order in which they were made
};

}  // namespace lgs::detail
