// Law 12 needs twins: two worlds that get the same edits, one of which leaves now and then: goes back to a mark, or is saved
// and loaded. Nobody must be able to tell them apart.
#pragma once

#include "oracle/generate/random.h"
#include "support.h"

#include <lgs/world.h>

#include <cstddef>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace lgs::engine_test {

/// One edit, or a commit, with all that it needs: so that it can be made in two worlds.
struct AnyEdit {
  enum class Kind { shape, add, addPolygon, remove, replace, setBlock, fill, clear, commit } kind{};
  std::vector<LocalPolygon> polygons;
  Cell cell;
  CellRect cells;
  ShapeId shape;
  PolygonHandle polygon;
  Block block = 0;
};

/// A random edit of a small world: as a rule a good one. Handles and shapes are some that `world` knows, or knew.
AnyEdit randomEdit(const World& world, oracle::Random& random);

/// What an edit returned or reported.
using Outcome = std::variant<ErrorCode, std::uint64_t, PolygonHandle, ShapeId, ChangeLists>;

Outcome make(World& world, const AnyEdit& edit);

/// A copy of the segments that follows the change lists alone.
class Follower {
 public:
  explicit Follower(const World& world) {
    for (const SegmentId id : world.segments()) segments_[id] = fieldsOf(*world.segment(id));
  }
  void follow(const World& world, const Changes& changes);
  bool agrees(const World& world) const;

 private:
  std::map<SegmentId, SegmentFields> segments_;
};

std::vector<std::byte> saved(const World& world);

}  // namespace lgs::engine_test
