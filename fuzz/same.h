// Whether two worlds are the same, and whether one is as the laws say.
#pragma once

#include "oracle/check/observed.h"

#include <lgs/world.h>
#include <map>
#include <string>
#include <vector>

namespace lgs::fuzz {

using oracle::differenceOf;
using oracle::saved;

/// A world with the same polygons and no marks; nothing is committed.
World builtAnew(const World& world);

/// How the outline, as of the last commit, differs from the naive reference's. Nothing is looked at in a world of many
/// polygons, as the reference takes its time.
std::string differenceByLaws(const World& world);

/// A copy of the segments that only lists of changes keep up to date.
class Follower {
 public:
  explicit Follower(const World& world);
  /// Says what is wrong with the lists, if anything is.
  std::string follow(const World& world, const Changes& changes);

 private:
  std::map<SegmentId, Segment> segments_;
};

}  // namespace lgs::fuzz
