// Law 7, refusal is total: after any bad edit the world, its ids, its handles and all it does later are as if the
// edit had not been tried.
#include "bad_edits.h"
#include "oracle/generate/random.h"
#include "scale.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace lgs::engine_test {
namespace {

using oracle::Random;

/// One random good edit, the same in every world that is equal; what it gave.
std::uint64_t goodEdit(Stage& s, std::uint64_t seed) {
  Random random(seed);
  const std::vector<Cell> cells = cellsOf({{-1, -1}, {3, 1}});
  const Cell cell = random.pick(cells);
  const std::vector<PlacedPolygon> there = s.world.polygons(cell);
  if (there.empty()) {
    const oracle::NamedShape& shape = random.pick(oracle::degenerateShapes());
    const ShapeId id = shapeOf(s.world, shape.polygons);
    return s.world.add(cell, id, random.below(3U)).value().packed();
  }
  const PolygonHandle gone = random.pick(there).handle;
  EXPECT_TRUE(s.world.remove(gone));
  return gone.packed();
}

struct Attempt {
  std::string what;
  bool isRefused;
};

/// One of the list. Other polygons may stand now where the stage had them, so that some would be good: not those.
Attempt tryListed(Stage& s, Random& random) {
  for (;;) {
    const BadEdit& bad = random.pick(badEdits());
    const bool ofStage = (bad.expected.code == ErrorCode::overlap && bad.expected.hasCell()) ||
                         (bad.expected.other.cellRef == s.full.cellRef && bad.expected.other.serial != 0);
    if (!ofStage) return {bad.name, bad.attempt(s).code == bad.expected.code};
  }
}

/// A polygon, good by itself and perhaps new to the world, on top of one that is there.
Attempt overlapSomething(Stage& s, Random& random) {
  const std::vector<Cell> cells = cellsOf({{-1, -1}, {3, 1}});
  const Cell cell = random.pick(cells);
  const oracle::NamedShape& shape = random.pick(oracle::degenerateShapes());
  const int symmetry = random.below(8);
  const LocalPolygon polygon = oracle::turned(random.pick(shape.polygons), symmetry);
  for (const PlacedPolygon& there : s.world.polygons(cell)) {
    if (!oracle::overlap(polygon, {there.vertices.begin(), there.vertices.end()})) continue;
    const auto refused = s.world.add(cell, std::span<const LocalPoint>(polygon), 9);
    return {std::string("overlap by ") + shape.name, !refused && refused.error().code == ErrorCode::overlap};
  }
  return {"nothing", true};
}

TEST(Refusal, LeavesTheWorldAsItWas) {
  for (const BadEdit& edit : badEdits()) {
    SCOPED_TRACE(edit.name);
    Stage stage = makeStage();
    const Snapshot before = snapshotOf(stage.world, Stage::cells());
    for (int again = 0; again < 2; ++again) {
      EXPECT_NE(edit.attempt(stage).code, ErrorCode{});
      EXPECT_EQ(snapshotOf(stage.world, Stage::cells()), before);
    }
    const Changes& changes = stage.world.commit();
    EXPECT_TRUE(changes.removed.empty() && changes.added.empty() && changes.relinked.empty());
    EXPECT_EQ(snapshotOf(stage.world, Stage::cells()), before);
  }
}

TEST(Refusal, LeavesPendingEditsAsTheyWere) {
  for (const BadEdit& edit : badEdits()) {
    SCOPED_TRACE(edit.name);
    Stage tried = makeStage(), untried = makeStage();
    for (Stage* s : {&tried, &untried}) {
      place(s->world, {1, 0}, eighths({{0, 1}, {7, 8}, {0, 8}}), 4);
      EXPECT_TRUE(s->world.remove(s->lower));
      if (s == &tried) {
        EXPECT_NE(edit.attempt(*s).code, ErrorCode{});
      }
      place(s->world, {5, -3}, ramp(), 8);
    }
    EXPECT_EQ(copyOf(tried.world.commit()), copyOf(untried.world.commit()));
    EXPECT_EQ(snapshotOf(tried.world, Stage::cells()), snapshotOf(untried.world, Stage::cells()));
  }
}

// Two worlds get the same good edits, one of them all kinds of bad ones in between. Most of these (reals, shapes, fills,
// stale handles) can not be written in a trace: a failure names them instead.
RC_GTEST_PROP(Refusal, IsNotSeenInAnythingLater, ()) {
  const auto seed = *rc::gen::noShrink(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>()));
  const auto edits = static_cast<int>(scaled(*rc::gen::inRange(1, 30)));
  Random random(seed);
  Stage tried = makeStage(), untried = makeStage();
  std::string tale;
  const auto fail = [&](const std::string& what) { RC_FAIL(what + "; tried: " + tale); };
  for (int k = 0; k < edits; ++k) {
    while (random.chance(60)) {
      const auto [what, isRefused] = random.chance(50) ? overlapSomething(tried, random) : tryListed(tried, random);
      tale += what + "; ";
      if (!isRefused) fail("the last one was not refused as it must be");
    }
    const std::uint64_t editSeed = random.next();
    if (goodEdit(tried, editSeed) != goodEdit(untried, editSeed)) fail("a good edit gives another handle");
    if (!random.chance(50)) continue;
    if (copyOf(tried.world.commit()) != copyOf(untried.world.commit())) fail("a commit reports other changes");
    if (snapshotOf(tried.world, Stage::cells()) != snapshotOf(untried.world, Stage::cells())) fail("other worlds");
  }
}

// Of several overlapped polygons the oldest is named. A polygon that was refused must not be remembered in a way that
// shows: here as the one that a later error names.
TEST(Refusal, DoesNotChangeWhichOverlapIsReported) {
  const LocalPolygon a = eighths({{1, 0}, {4, 0}, {4, 4}}), b = eighths({{4, 0}, {8, 0}, {8, 4}});
  const auto reported = [&](bool tryFirst) {
    World world;
    if (tryFirst) {
      place(world, {9, 9}, unitSquare());
      EXPECT_FALSE(world.add({9, 9}, std::span<const LocalPoint>(b), 1));
    }
    const PolygonHandle oldest = place(world, {}, a);
    place(world, {}, b);
    const LocalPolygon square = unitSquare();
    return world.add({}, std::span<const LocalPoint>(square), 1).error().other == oldest;
  };
  EXPECT_TRUE(reported(true));
  EXPECT_TRUE(reported(false));
}

}  // namespace
}  // namespace lgs::engine_test
