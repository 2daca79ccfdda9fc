// Law 7, total refusal: a bad edit returns an error that says what is wrong and where, and changes nothing. After any
// bad edit the world, its ids, its handles and all it does later are as if the edit had not been tried.
#include "bad_edits.h"

#include <gtest/gtest.h>

namespace lgs::test {
namespace {

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
}  // namespace lgs::test
