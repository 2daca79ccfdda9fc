// Commits, the marks of a world, and roll-backs to them. Ground and outline note in one journal what they held, and a
// mark is a moment of that, with what is small enough to be kept as it is. What was undone can be kept. Then the marks
// that the world rolled back beyond are kept, too, and redo leads to them until something is edited.
//
// Which chunks are in memory is no part of that. After a roll-back or redo, the outline is that of then,
// with the chunks that were loaded then. Those streamed since are renewed, as in a commit: at once, unless edits are
// pending there, which the next commit shows with them. Commits since the world rolled back are undone before it goes
// forward.
//
// A commit that finds nothing to do is none: it ends no group.
#pragma once

#include "ground/cell_changes.h"
#include "ground/ground.h"
#include "outline/outline.h"
#include "storage/versions.h"

#include <lgs/world.h>

#include <cassert>
#include <cstdint>
#include <vector>

namespace lgs::detail {

class History {
 public:
  using Moment = Journal::Moment;

  History(Ground& ground, Outline& outline) : ground_(ground), outline_(outline) {}
  /// That of a copy, with its own ground and outline. Marks of groups are dropped: no group could end them there.
  History(const History& other, Ground& ground, Outline& outline);
  History(const History&) = delete;
  History& operator=(const History&) = delete;
  ~History() = default;

  // --- Marks

  /// The mark of a group of edits is known to the group alone, which does not roll back to it after a commit.
  enum class Of : std::uint8_t { game, group };
  Mark mark(Of of = Of::game);
  bool knows(Mark mark, Of of = Of::game) const { return find(mark) != marks_.end() && find(mark)->of == of; }
  /// Whether redo() leads there.
  bool isAhead(Mark mark) const;
  bool hasMarks() const { return !marks_.empty(); }

  /// The mark must be known. It stays, and later ones are void. `changes` receives what this does to the segments.
  void rollBack(Mark mark, Undone undone, Changes& changes);
  /// The mark must be ahead. Marks that were made since the world rolled back are void.
  void redo(Mark mark, Changes& changes);
  /// Rolls back to the mark of a group, in silence. It must be known, and no commit may have found something since: the
  /// segments are as they were.
  void takeBack(Mark mark);
  /// The mark must be known.
  void forget(Mark mark);
  /// Whether a commit found something since the mark, which must be known.
  bool committedSince(Mark mark) const {
    assert(knows(mark, Of::group) || knows(mark));
    return ground_.journal.isNotedSince(find(mark)->moment, Thing::commit, 0);
  }

  // --- Commits

  /// Brings the outline up to date with what changed: changes() of it says how.
  void commit(const Executor& executor) {
    renewOutline(executor);
    if (ground_.journal.isOn()) [[unlikely]]
      noteCommit();
    ground_.endCommit();
    if (ground_.isSleepy()) [[unlikely]]
      freeSleeping();
  }

  // --- Followers of the ground

  /// There is no mark, and nothing has changed since the last commit.
  void follow(bool follow);
  bool isFollowed() const { return committed_ != 0; }
  /// A chunk is about to leave.
  void leaves(std::uint32_t chunk) {
    if (committed_ != 0) cellChanges_.leaves(ground_, committed_, chunk);
  }
  /// An unloaded chunk has come back.
  void comesBack(std::uint32_t chunk) {
    if (committed_ != 0) cellChanges_.comesBack(chunk);
  }
  /// What the last commit, rollBack() or redo() changed, while the ground is followed.
  const CellChanges& cellChanges() const { return cellChanges_; }
  /// That of the ground before. A commit that finds nothing changes nothing since the version that is there.
  std::uint64_t versionBeforeCellChanges() const { return versionBefore_; }

  std::uint64_t bytes() const;

 private:
  struct Marked {
    Mark mark;
    Of of = Of::game;
    Moment moment = 0;
    Moment committed = 0;  ///< the last commit before it that followers saw, held by it; 0 without followers
    std::uint64_t shapes = 0;
    Outline::State outline;
    std::vector<Ground::ChangedCells> changed;  ///< of a game's mark
  };

  std::vector<Marked>::const_iterator find(Mark mark) const;
  void renewOutline(const Executor& executor) {
    ground_.streamChunks();
    outline_.update(ground_, hasMarks() ? &ground_.journal : nullptr, executor);
  }
  bool noteFound();
  void noteCommit();
  void freeSleeping();
  void letGo(const Marked& mark);
  void dropLaterMarks(Mark mark, Undone undone);
  bool isUnedited() const;
  void setRedo(const Marked& to);
  bool keepsAhead(const Marked& to, Undone undone) const;
  template <class Go>
  void travel(const Marked& to, bool isFromRedo, const std::vector<std::uint32_t>& ids, Changes& changes, Go&& go);
  template <class Go>
  void tell(const Marked& to, Go&& go);
  void returnToRedo();
  bool showStreamed();
  void undo(Moment moment, Undone undone);
  void exchange(Note& note);
  void forgetUndone();

  Ground& ground_;
  Outline& outline_;
  Versions numbers_;
  std::vector<Marked> marks_;  ///< in the order in which they were made
  std::vector<Marked> ahead_;  ///< that the world rolled back beyond, the next one last
  // The mark that the last kept roll-back, or redo, led to, if any are ahead.
  Moment redoFrom_ = 0;
  Mark redoMark_;
  std::uint64_t redoShapes_ = 0;
  std::vector<InternedShape> undoneShapes_;  ///< the first to come back last
  Moment committed_ = 0;                     ///< the last commit while the ground is followed; otherwise 0
  CellChanges cellChanges_;
  std::uint64_t versionBefore_ = 0;  ///< these changes
};

}  // namespace lgs::detail
