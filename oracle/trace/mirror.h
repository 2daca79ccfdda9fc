// A mirror is a copy of a world's segments that only change lists keep up to date (law 6). If it ever differs from the
// world, a change list was wrong.
#pragma once

#include "oracle/reference/outline.h"

#include <lgs/world.h>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <unordered_set>
#include <vector>

namespace lgs::oracle {

class Mirror {
 public:
  /// Applies what a commit reported, and compares with the world. Says what is wrong, if anything is. This must hold:
  ///  - removed ids were alive, added ones were not, relinked ones are the same segments with other ghosts;
  ///  - no id is listed twice, and no removed segment comes back with another id;
  ///  - all other segments are exactly as before; the world lists the live ids in increasing order;
  ///  - each segment lies on an edge of its polygon, which is placed; it has the polygon's cell and block;
  ///  - predecessor and successor are live segments that meet this one, and the ghosts are their far ends.
  /// After a roll-back or redo an id may be both removed and added, and ids are those of then; while edits are pending
  /// a segment may have lost its polygon. A link may lead to what is not in memory.
  /// After a complaint the mirror is of no further use.
  enum class After : std::uint8_t { commit, goingBack, goingBackToPending };
  std::optional<std::string> update(const World& world, const Changes& changes, After after = After::commit);

  /// The segments that the complaint is about, for a picture.
  const Outline& blamed() const { return blamed_; }

  /// All segments by id, up to the highest id that ever was. Dead ones have a null id.
  std::span<const Segment> segments() const { return segments_; }

 private:
  using Complaint = std::optional<std::string>;
  using Identity = std::tuple<Point, Point, PolygonHandle, Block>;  // start, end, owner

  Complaint remove(const World& world, const std::vector<SegmentId>& ids);
  Complaint relink(const World& world, const std::vector<SegmentId>& ids);
  Complaint add(const World& world, const std::vector<SegmentId>& ids);
  Complaint compare(const World& world, SegmentId id);
  Complaint compareAll(const World& world);
  Complaint about(const Segment& segment, std::string text);
  Complaint about(const World& world, SegmentId id, std::string text);

  static Identity identityOf(const Segment& s) { return {s.start, s.end, s.polygon, s.block}; }
  Segment* find(SegmentId id);  // null if it is not alive

  std::vector<Segment> segments_ = {{}};  // by id
  std::size_t alive_ = 0;
  Outline blamed_;
  // Of the update.
  After after_{};
  std::unordered_set<std::uint32_t> listed_;
  std::map<Identity, Segment> gone_;
};

}  // namespace lgs::oracle
