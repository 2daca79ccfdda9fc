// Laws 5 and 6: what a commit reports lies at the edited cells; everything else keeps its id and all that it says.
#include "oracle/trace/player.h"
#include "random_traces.h"
#include "support.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>
#include <unordered_map>

namespace lgs::engine_test {
namespace {

using oracle::Edit;
using oracle::Player;
using oracle::Random;
using oracle::Trace;

bool isInClosedCell(Point p, Cell cell) {
  const Point origin = toWorld(cell, {});
  return p.x >= origin.x && p.x <= origin.x + U && p.y >= origin.y && p.y <= origin.y + U;
}

class Watch {
 public:
  explicit Watch(const World& world) : world_(world) {}

  std::optional<std::string> afterCommit(const std::set<Cell>& edited, const Changes& changes) {
    for (const SegmentId id : changes.removed) {
      const auto old = last_.find(id.value);
      if (old == last_.end() || !liesIn(edited, old->second)) return "removed far from the edits";
    }
    std::unordered_map<std::uint32_t, SegmentFields> now;
    for (const SegmentId id : world_.segments()) now.emplace(id.value, fieldsOf(*world_.segment(id)));
    for (const SegmentId id : changes.added)
      if (!liesIn(edited, now.at(id.value))) return "added far from the edits";
    for (const SegmentId id : changes.relinked)
      if (!endsIn(edited, now.at(id.value))) return "relinked far from the edits";
    // Links are ids; one can change where the ghost does not, then the segment counts as unchanged.
    for (const auto& [id, fields] : now) {
      const auto old = last_.find(id);
      if (old == last_.end() || endsIn(edited, fields)) continue;
      if (old->second != fields) return "a segment far from the edits has changed";
    }
    last_ = std::move(now);
    return std::nullopt;
  }

 private:
  static bool liesIn(const std::set<Cell>& cells, const SegmentFields& s) {
    for (const Cell& c : cells)
      if (isInClosedCell(std::get<1>(s), c) && isInClosedCell(std::get<2>(s), c)) return true;
    return false;
  }
  static bool endsIn(const std::set<Cell>& cells, const SegmentFields& s) {
    for (const Cell& c : cells)
      if (isInClosedCell(std::get<1>(s), c) || isInClosedCell(std::get<2>(s), c)) return true;
    return false;
  }

  const World& world_;
  std::unordered_map<std::uint32_t, SegmentFields> last_;
};

RC_GTEST_PROP(Locality, ChangesLieAtTheEdits, ()) {
  forRandomTraces("locality", 20, {}, [](const Trace& trace, Random) -> std::optional<std::string> {
    Player player(trace.preserve);
    Watch watch(player.world());
    std::set<Cell> edited;
    for (const Edit& edit : trace.edits) {
      if (edit.kind == Edit::Kind::commit) {
        if (auto problem = watch.afterCommit(edited, player.commit())) return problem;
        edited.clear();
        continue;
      }
      Cell cell = edit.polygon.cell;
      if (edit.kind == Edit::Kind::remove) cell = player.world().cellOf(player.handleOf(edit.name)).value();
      edited.insert(cell);
      if (!player.apply(edit)) return "refused";
    }
    return std::nullopt;
  });
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
}  // namespace lgs::engine_test
