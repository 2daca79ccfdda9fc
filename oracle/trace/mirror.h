// A mirror of a world's output that is kept up to date by change lists alone (law 6). If the mirror and the world ever
// differ, a change list was wrong.
#pragma once

#include <lgs/world.h>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace lgs::oracle {

class Mirror {
 public:
  /// Applies what a commit reported and compares with the world it is about. Says what is wrong, if anything:
  ///  - removed ids were alive, added ones were not, relinked ones are the same segments with other ghosts;
  ///    no id in two lists or twice in one; nothing removed comes back under another id;
  ///  - everything else is exactly as before, and the live ids are those the world says;
  ///  - each segment lies on an edge of the polygon that owns it, which is placed, with that polygon's cell and block;
  ///  - predecessor and successor are live segments that meet this one, and the ghosts are their far ends.
  /// After a complaint the mirror is of no further use.
  std::optional<std::string> update(const World& world, const Changes& changes);

 private:
  Segment* find(SegmentId id);  // null if it is not alive

  std::vector<Segment> segments_;  // by id; null ids where there is none
  std::size_t alive_ = 0;
};

}  // namespace lgs::oracle
