// Law 12 needs twins: two worlds that get the same edits. One of them leaves now and then: it goes back to a mark, is
// saved and loaded, or is copied. Nobody must be able to tell them apart.
#pragma once

#include "oracle/generate/random.h"
#include "oracle/reference/outline.h"
#include "proptests/support/worlds.h"

#include <lgs/world.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace lgs::test {

/// One edit, or a commit, with all that it needs: so it can be made in two worlds.
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
Outcome makeEdit(World& world, const AnyEdit& edit);

/// An edit for each seed. RapidCheck makes the list small by taking some away.
using Seeds = std::vector<std::uint32_t>;

/// Makes the edits of some seeds, as they come up in this world.
void makeAll(World& world, const Seeds& seeds);

/// Makes the same edits in both worlds, which must answer the same, report the same and be saved as the same bytes.
void expectNoDifference(World& stayed, World& left, const Seeds& seeds);

/// A relation that keeps the overlap of different blocks, or none.
PreserveRelation relation(bool preserves);

/// A world in the middle of its life, under such a relation.
World grown(bool preserves, const Seeds& seeds);

/// What the laws make of a world's polygons, by the naive reference.
oracle::Outline outlineByLaws(const World& world, bool preserves);

/// Segments that follow the change lists alone.
class Follower {
 public:
  explicit Follower(const World& world);
  void follow(const World& world, const Changes& changes);
  bool agrees(const World& world) const;

 private:
  std::map<SegmentId, SegmentFields> segments_;
};

std::vector<std::byte> saved(const World& world);

}  // namespace lgs::test
