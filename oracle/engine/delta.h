// What an engine tells of a commit that does not put out its whole outline: lines `- ID`, `+ ID segment …` and
// `~ ID segment …`. The ids are its own words.
#pragma once

#include "oracle/reference/outline.h"

#include <string>
#include <unordered_map>
#include <vector>

namespace lgs::oracle {

struct SegmentChange {
  char sign = '-';  ///< '-': it is gone; '+': it is new; '~': the segment of this id is another one now
  std::string id;
  OutlineSegment segment = {};  ///< as it is now; of a '-' it means nothing
};
using SegmentChanges = std::vector<SegmentChange>;

/// A copy of an engine's outline that its lists of changes alone keep up to date.
class Delta {
 public:
  /// Makes the changes of a commit, and forgets what the list before was found to be.
  void take(SegmentChanges changes);

  /// A new world: there is no segment, and every id is free.
  void clear() { *this = {}; }

  Outline outline() const;                                    ///< sorted
  const SegmentChanges& changes() const { return changes_; }  ///< the last list

  /// What is wrong with the ids of the last list; empty if nothing is. An id stands once a list at most, '+' has one
  /// that is free, '-' and '~' have one that is not. After that the copy is of no further use.
  const std::string& wrongId() const { return wrongId_; }

  /// Segments of the last list that are as they were before: of a '~' that changes nothing, and of a '-' and a '+'.
  const Outline& unchanged() const { return unchanged_; }
  const Outline& remade() const { return remade_; }

 private:
  SegmentChanges changes_;
  std::unordered_map<std::string, OutlineSegment> segments_;  // by id
  std::string wrongId_;
  Outline unchanged_, remade_;
};

}  // namespace lgs::oracle
