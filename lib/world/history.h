// The marks of a world, and going back to them: ground and outline each note what they need to undo, and a mark says
// how far that goes. What was undone can be kept. Then the marks that the world went back beyond are kept, too, and it
// can go forward to them, as long as it is where it went: an edit since, and what was undone is worth nothing any more.
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
  /// Whether rollForward() leads there.
  bool isAhead(Mark mark) const;
  bool hasMarks() const { return !marks_.empty(); }

  /// The mark must be known. It stays, and later ones are void. `changes` receives what this does to the segments.
  void rollBack(Mark mark, Undone undone, Changes& changes);
  /// The mark must be ahead. Marks that were made since the world went back are void.
  void rollForward(Mark mark, Changes& changes);
  /// Goes back in silence. The mark must be known, and no commit may have changed something since: the segments are as
  /// they were at the mark.
  void takeBack(Mark mark);
  /// The mark must be known.
  void forget(Mark mark);
  /// After a commit, while there are marks: forgets what nobody can go back to, the moments between two of them.
  void squeeze();
  /// Whether a commit changed something since the mark, which must be known.
  bool committedSince(Mark mark) const { return find(mark)->outline != outline_.notes.now(); }

  /// The cells, each once, in the order of their first edit.
  std::vector<Cell> editedSince(Mark mark) const { return ground_.notes.editedSince(find(mark)->ground); }

  std::uint64_t bytes() const { return (marks_.capacity() + ahead_.capacity()) * sizeof marks_[0]; }

 private:
  struct Marked {
    Mark mark;
    CellNotes::Moment ground;
    std::uint64_t outline = 0;
    std::uint64_t version = 0;  ///< of the segments
    bool ofGroup = false;
  };

  std::vector<Marked>::const_iterator find(Mark mark) const;
  void forgetNotes();
  bool isWhereItWent() const;
  void returnToWhereItWent();
  void leave(const Marked& to, Undone undone);
  void forgetUndone();

  Ground& ground_;
  Outline& outline_;
  Versions numbers_;
  std::vector<Marked> marks_;  ///< in the order in which they were made
  std::vector<Marked> ahead_;  ///< that the world went back beyond, the next one last
  Marked went_;                ///< where it went then, if any are ahead
};

}  // namespace lgs::detail
