// Law 5, locality: a commit changes only segments that lie in, or end on the rim of, an edited cell, and links at that
// rim's vertices.
#include "proptests/support/law.h"
#include "proptests/support/played.h"
#include "proptests/support/traces.h"
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace lgs::test {
namespace {

using oracle::Call;
using Segments = std::map<SegmentId, SegmentFields>;

class EditedCells {
 public:
  void add(Cell cell) { cells_.insert(cell); }
  bool holdBothEndsOf(const SegmentFields& s) const {
    return std::ranges::any_of(cells_, [&](Cell c) { return isIn(c, s.start) && isIn(c, s.end); });
  }
  bool holdAnEndOf(const SegmentFields& s) const {
    return std::ranges::any_of(cells_, [&](Cell c) { return isIn(c, s.start) || isIn(c, s.end); });
  }

 private:
  /// The closed cell.
  static bool isIn(Cell cell, Point p) {
    const Point low = toWorld(cell, {}), high = toWorld(cell, {U, U});
    return low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y;
  }
  std::set<Cell> cells_;
};

Segments segmentsOf(const World& world) {
  Segments segments;
  for (const SegmentId id : world.segments()) segments.emplace(id, fieldsOf(*world.segment(id)));
  return segments;
}

void expectLocal(const Segments& before, const Segments& after, const Changes& changes, const EditedCells& edited) {
  for (const SegmentId id : changes.removed)
    failUnless(edited.holdBothEndsOf(before.at(id)), "a segment far from the edits is removed");
  for (const SegmentId id : changes.added)
    failUnless(edited.holdBothEndsOf(after.at(id)), "a segment far from the edits is added");
  for (const SegmentId id : changes.relinked)
    failUnless(edited.holdAnEndOf(after.at(id)), "a segment far from the edits is relinked");
  // A link can change where the ghost does not, which no list says.
  for (const auto& [id, segment] : before) {
    if (edited.holdAnEndOf(segment)) continue;
    failUnless(after.contains(id) && after.at(id) == segment, "a segment far from the edits is another one");
  }
}

LGS_LAW(Locality, ChangesLieAtTheEdits, 2'000, (const GoodTrace& trace)) {
  oracle::Player player(trace.preserve);
  Segments before;
  EditedCells edited;
  for (const Call& edit : trace.calls) {
    if (edit.kind == Call::Kind::commit) {
      const Changes& changes = player.commit();
      const Segments after = segmentsOf(player.world());
      expectLocal(before, after, changes, std::exchange(edited, {}));
      before = after;
    } else {
      const bool isAdd = edit.kind == Call::Kind::add;
      edited.add(isAdd ? edit.polygon().cell : player.world().cellOf(player.handleOf(edit.name())).value());
      failUnless(player.apply(edit).has_value(), "a good edit is refused");
    }
  }
}

TEST(Locality, AnEditInABigWorldChangesAFewSegments) {
  World world;
  ASSERT_TRUE(world.fill({{0, 0}, {199, 199}}, shapeOf(world, {unitSquare()}), 1));
  world.commit();
  const Snapshot before = snapshotOf(world, {});
  removeAll(world, {100, 100});
  EXPECT_EQ(copyOf(world.commit()).added.size(), 4U);
  place(world, {100, 100}, unitSquare());
  const Changes& changes = world.commit();
  EXPECT_EQ(changes.removed.size(), 4U);
  EXPECT_TRUE(changes.added.empty() && changes.relinked.empty());
  EXPECT_EQ(snapshotOf(world, {}).segments, before.segments);
}

}  // namespace
}  // namespace lgs::test
