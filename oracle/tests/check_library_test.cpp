// What the checker counts of this library's engine, and what it sees of calls that are made in a world.
#include "checking.h"
#include "oracle/check/call_check.h"
#include "oracle/generate/generator.h"
#include "read_traces.h"

namespace lgs::oracle::library {
namespace {

TEST(CheckStatistics, CountWhatWasDone) {
  CheckStats stats;
  Trace trace;
  for (int k = 0; k < 7; ++k) {
    trace.edits.push_back(square("p" + std::to_string(k), {2 * k, 0}));
    trace.edits.push_back(Edit::commit());
  }
  EXPECT_FALSE(checked(trace, {}, stats));
  EXPECT_EQ(stats.edits, 7U);
  EXPECT_EQ(stats.commits, 7U);
  EXPECT_EQ(stats.whole, 7U);
  EXPECT_EQ(stats.naive, 7U);
  EXPECT_EQ(stats.cgal, 7U);
  EXPECT_EQ(stats.full, 0U);
  EXPECT_EQ(stats.read, 1U) << "at the end; of the wholes every eighth";
  trace.edits.push_back(Edit::commit());
  EXPECT_FALSE(checked(trace, {}, stats));
  EXPECT_EQ(stats.read, 1U + 2U);
}

TEST(CheckStatistics, CountDetoursAndRefusedBrushes) {
  CheckStats stats;
  for (std::uint64_t seed = 0; seed < 5; ++seed)
    EXPECT_FALSE(checked(randomCase({3, 3, 60}, seed), {.skipRefused = true}, stats));
  for (std::size_t k = 1; k < kDetours; ++k) EXPECT_GT(stats.detours[k], 0U) << kDetourNames[k];
  stats = {};
  EXPECT_FALSE(checked(crowdedCase(Crowd::polygons, kCrowdedEdits, 1), {.skipRefused = true}, stats));
  EXPECT_GT(stats.full, 0U);
  EXPECT_LE(stats.full, stats.refused);
  stats = {};
  const Trace beyond = mustParse("lgs-trace 2\ncarve 0 0 1e9 0 1e9 1e9\n");
  EXPECT_FALSE(checked(beyond, {.skipRefused = true}, stats));
  EXPECT_EQ(stats.refused, 1U);
  EXPECT_FALSE(checkTrace(beyond, {}, stats));
}

// Views can not follow into a world that was loaded, so there no world is saved.
TEST(CheckViews, AreFollowedWhereTheyAreAskedFor) {
  CheckStats stats;
  for (std::uint64_t seed = 0; seed < 5; ++seed)
    EXPECT_FALSE(checked(randomCase({3, 3, 60}, seed), {.skipRefused = true, .views = true}, stats));
  for (std::size_t k = 1; k < kDetours; ++k)
    EXPECT_EQ(stats.detours[k] > 0, static_cast<Detour>(k) != Detour::saved) << kDetourNames[k];
}

// --- Calls ------------------------------------------------------------------------------------------------------------

Call call(Call::Kind kind) {
  Call call;
  call.kind = kind;
  return call;
}

Call adding(Cell cell) {
  Call add = call(Call::Kind::add);
  add.comes = {{cell, {test::unitSquare()}, 1}};
  return add;
}

TEST(CheckCalls, AGroupIsKeptOrNot) {
  for (const auto keeps : {Call::Keeps::always, Call::Keeps::never, Call::Keeps::ifAll}) {
    CallCheck check({}, {});
    Call group = call(Call::Kind::group);
    group.group = {adding({0, 0}), adding({1, 0})};
    group.keeps = keeps;
    EXPECT_EQ(check.make(group), std::nullopt);
    EXPECT_EQ(check.make(call(Call::Kind::commit)), std::nullopt);
    EXPECT_EQ(check.world().stats().polygons, keeps == Call::Keeps::never ? 0U : 2U);
  }
}

TEST(CheckCalls, WhatIsDoneBesideIsSeenAtTheNextCommitOrLoad) {
  for (const auto kind : {Call::Kind::commit, Call::Kind::load}) {
    CallCheck check({}, {});
    EXPECT_EQ(check.make(adding({0, 0})), std::nullopt);
    ASSERT_TRUE(check.world().add({5, 5}, kUnitSquare, 1));
    EXPECT_EQ(check.make(call(kind)), inWords(call(kind)) + ": another number of polygons stands there");
  }
}

TEST(CheckCalls, WhatIsNotTriedMakesItsShapesAllTheSame) {
  CallCheck check({}, {});
  check.triesRefused = false;
  EXPECT_EQ(check.make(adding({0, 0})), std::nullopt);
  Call refused = call(Call::Kind::addShape);
  refused.comes = {{{0, 0}, {test::ramp()}, 1}};
  EXPECT_EQ(check.make(refused), std::nullopt);
  EXPECT_EQ(check.world().stats().polygons, 1U);
  EXPECT_TRUE(check.world().polygonsOf(ShapeId{1}));
}

// The same polygons, in a world that preserves what the model does not.
TEST(CheckCalls, AnotherOutlineIsSeen) {
  CallCheck check({}, {});
  World other([](Block, Block) { return true; });
  for (const Cell cell : {Cell{0, 0}, Cell{1, 0}}) {
    EXPECT_EQ(check.make(adding(cell)), std::nullopt);
    test::place(other, cell, test::unitSquare());
  }
  check.world() = std::move(other);
  const auto wrong = check.make(call(Call::Kind::commit));
  ASSERT_TRUE(wrong);
  EXPECT_TRUE(wrong->starts_with(inWords(call(Call::Kind::commit)) + ": the outline is not that of the laws\nextra "))
      << *wrong;
}

}  // namespace
}  // namespace lgs::oracle::library
