// Law 12, marks, groups and copies: to go back to a mark, or to copy a world, is never having left.
#include "oracle/trace/dump.h"
#include "proptests/support/law.h"
#include "proptests/support/scale.h"
#include "proptests/support/traces.h"
#include "twins.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace lgs::test {
namespace {

/// Edits a world, makes marks on the way, goes back to them and lets go of them.
void wander(World& world, const Seeds& seeds) {
  std::vector<Mark> marks;
  for (const std::uint32_t seed : seeds) {
    Chance chance(seed);
    makeEdit(world, randomEdit(world, chance));
    if (chance.chance(20)) marks.push_back(world.checkpoint());
    if (marks.empty()) continue;
    const std::size_t k = chance.below(marks.size());
    if (chance.chance(15)) {
      EXPECT_TRUE(world.rollBack(marks[k]));
      marks.resize(k + 1);
    }
    if (chance.chance(15)) {
      EXPECT_TRUE(world.forget(marks[k]));
      marks.erase(marks.begin() + static_cast<std::ptrdiff_t>(k));
    }
  }
}

LGS_LAW(GoingBack, IsNeverHavingLeft, 1'000,
        (const Seeds& before, const Seeds& away, const Seeds& after, bool preserves, bool forgets)) {
  World stayed = grown(preserves, before), left = grown(preserves, before);
  for (int visits = 0; visits < 2; ++visits) {
    const Mark mark = left.checkpoint();
    wander(left, away);
    const Mark inner = left.checkpoint();
    ASSERT_TRUE(left.rollBack(mark));
    EXPECT_FALSE(left.rollBack(inner)) << "a mark that was made after the moment that the world went back to";
    if (forgets) {
      EXPECT_TRUE(left.forget(mark));
    }
    ASSERT_NO_FATAL_FAILURE(expectNoDifference(stayed, left, after));
  }
}

LGS_LAW(GoingBack, ReportsExactlyWhatItDoesToTheSegments, 200,
        (const Seeds& before, const std::vector<Seeds>& away, bool preserves)) {
  World world = grown(preserves, before);
  world.commit();
  Follower follower(world);
  const Mark mark = world.checkpoint();
  for (const Seeds& seeds : away) {
    for (const std::uint32_t seed : seeds) {
      Chance chance(seed);
      const AnyEdit edit = randomEdit(world, chance);
      if (edit.kind == AnyEdit::Kind::commit)
        follower.follow(world, world.commit());
      else
        makeEdit(world, edit);
    }
    ASSERT_TRUE(world.rollBack(mark));
    const Changes& changes = world.changesOfRollBack();
    follower.follow(world, changes);
    EXPECT_TRUE(follower.agrees(world));
    for (const auto* ids : {&changes.removed, &changes.added, &changes.relinked})
      EXPECT_TRUE(std::is_sorted(ids->begin(), ids->end()));
  }
}

/// A game with prediction: the world of the server makes each frame once. The client guesses each frame, goes back, and
/// makes it as the server did; then the two are the same to the last byte.
LGS_LAW(GoingBack, APredictionThatWasWrongLeavesNoTrace, 60,
        (const std::vector<Seeds>& frames, const std::vector<Seeds>& guesses, bool preserves)) {
  World server = grown(preserves, {}), client = grown(preserves, {});
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const Mark confirmed = client.checkpoint();
    for (std::size_t ahead = k; ahead < std::min(k + 3, guesses.size()); ++ahead) {
      makeAll(client, guesses[ahead]);
      client.commit();
    }
    ASSERT_TRUE(client.rollBack(confirmed));
    EXPECT_TRUE(client.forget(confirmed));
    ASSERT_NO_FATAL_FAILURE(expectNoDifference(server, client, frames[k]));
    EXPECT_EQ(oracle::outlineOf(client), outlineByLaws(client, preserves));
  }
}

LGS_LAW(GoingBack, ACopyIsNeverHavingLeft, 1'000, (const Seeds& before, const Seeds& after, bool preserves)) {
  World stayed = grown(preserves, before);
  const Mark mark = stayed.checkpoint();
  makeAll(stayed, before);
  World copy = stayed;  // with edits that are not committed
  {
    World other = grown(preserves, after);
    other = copy;
    makeAll(other, before);
    EXPECT_TRUE(other.rollBack(mark));
  }  // nothing of the copies is shared
  ASSERT_NO_FATAL_FAILURE(expectNoDifference(stayed, copy, after));
  EXPECT_TRUE(stayed.rollBack(mark));
  EXPECT_TRUE(copy.rollBack(mark));
  expectNoDifference(stayed, copy, after);
}

LGS_LAW(GoingBack, ATransactionIsUndoneUnlessItIsKept, 500,
        (const Seeds& before, const Seeds& edits, const Seeds& after)) {
  World stayed = grown(false, before), left = grown(false, before);
  const auto withoutCommits = [](World& world, const Seeds& seeds) {
    for (const std::uint32_t seed : seeds) {
      Chance chance(seed);
      const AnyEdit edit = randomEdit(world, chance);
      if (edit.kind != AnyEdit::Kind::commit) makeEdit(world, edit);
    }
  };
  {
    const Transaction group = left.edit();
    withoutCommits(left, edits);
  }
  {
    Transaction group = left.edit();
    withoutCommits(left, after);
    group.keep();
  }
  withoutCommits(stayed, after);
  expectNoDifference(stayed, left, edits);
}

/// One long game, in which cells are edited more than 255 times. A long run of it is a soak: docs/reports/long-runs.md.
TEST(GoingBack, ALongGameOfPredictionsStaysInStep) {
  World server = grown(true, {}), client = grown(true, {});
  const std::int64_t frames = scaled(1'500);
  for (std::int64_t frame = 0; frame < frames; ++frame) {
    Chance chance(testSeed() + static_cast<std::uint64_t>(frame));
    const auto edits = [&chance] {
      Seeds seeds(chance.below(6U));
      for (std::uint32_t& seed : seeds) seed = static_cast<std::uint32_t>(chance.next());
      return seeds;
    };
    const Mark confirmed = client.checkpoint();
    for (int ahead = chance.below(4); ahead > 0; --ahead) {
      makeAll(client, edits());
      client.commit();
    }
    ASSERT_TRUE(client.rollBack(confirmed));
    ASSERT_TRUE(client.forget(confirmed));
    ASSERT_NO_FATAL_FAILURE(expectNoDifference(server, client, edits())) << "in frame " << frame;
    if (frame % 16 != 0) continue;
    ASSERT_EQ(oracle::outlineOf(client), outlineByLaws(client, true)) << "in frame " << frame;
    if (client.stats().shapes > 200) server = client = grown(true, {});  // shapes are never forgotten
  }
}

TEST(GoingBackByHand, MarksThatAreNoneAreRefused) {
  World world;
  EXPECT_EQ(world.rollBack({}).error().code, ErrorCode::unknownMark);
  EXPECT_EQ(world.forget(Mark{7}).error().code, ErrorCode::unknownMark);
  const Mark mark = world.checkpoint();
  EXPECT_TRUE(world.forget(mark));
  const auto refused = world.rollBack(mark);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::unknownMark);
  EXPECT_EQ(message(refused.error()),
            "this world has no such mark; it was forgotten, or the world went back to a moment before it");
  EXPECT_NE(world.checkpoint(), mark);
}

TEST(GoingBackByHand, MarksAreForOneWorldAndItsCopies) {
  World world;
  const Mark before = world.checkpoint();
  place(world, {}, unitSquare());
  world.commit();
  World copy = world;
  World loaded = *World::load(saved(world), {});
  const Mark ofWorld = world.checkpoint(), ofCopy = copy.checkpoint(), ofLoaded = loaded.checkpoint();
  for (const Mark mark : {before, ofWorld, ofCopy}) EXPECT_FALSE(loaded.rollBack(mark));
  for (const Mark mark : {ofCopy, ofLoaded}) EXPECT_FALSE(world.rollBack(mark));
  for (const Mark mark : {ofWorld, ofLoaded}) EXPECT_FALSE(copy.rollBack(mark));
  EXPECT_TRUE(copy.rollBack(before));
  EXPECT_TRUE(copy.isEmpty({}));
  EXPECT_FALSE(world.isEmpty({}));
}

TEST(GoingBackByHand, ACopyHasNoGroup) {
  World world;
  const Mark mark = world.checkpoint();
  std::optional<World> during;
  {
    Transaction group = world.edit();
    place(world, {}, unitSquare());
    Transaction inner = world.edit();
    place(world, {1, 0}, unitSquare());
    during = world;
    inner.keep();
    group.keep();
  }
  World after = world;
  EXPECT_TRUE(samePolygons(*during, after)) << "it has the edits that were made";
  for (World* copy : {&*during, &after}) {
    ASSERT_TRUE(copy->forget(mark));
    for (const Cell cell : cellsOf({{0, 2}, {31, 31}})) place(*copy, cell, ramp());
    copy->commit();
  }
  // It had room for two marks. To undo 960 edits would take more.
  EXPECT_LT(during->stats().bytes, after.stats().bytes + 1'000) << "it keeps what is needed to undo the group";
}

TEST(GoingBackByHand, AFailedGroupLeavesWhatARollBackReported) {
  World world;
  const Mark mark = world.checkpoint();
  place(world, {0, 0}, unitSquare(), 1);
  world.commit();
  ASSERT_TRUE(world.rollBack(mark));
  const Changes reported = world.changesOfRollBack();
  EXPECT_EQ(reported.removed.size(), 4U);
  {
    const Transaction group = world.edit();
    place(world, {0, 0}, unitSquare(), 1);
  }
  EXPECT_EQ(copyOf(world.changesOfRollBack()), copyOf(reported));
}

TEST(GoingBackByHand, ATransactionThatWasCommittedInStays) {
  World world;
  {
    const Transaction group = world.edit();
    place(world, {}, unitSquare());
    world.commit();
    place(world, {1, 0}, unitSquare());
  }
  EXPECT_FALSE(world.isEmpty({}));
  EXPECT_FALSE(world.isEmpty({1, 0}));
}

TEST(GoingBackByHand, ATransactionThatWasGoneBackBeyondEnds) {
  World world;
  const Mark mark = world.checkpoint();
  {
    const Transaction group = world.edit();
    place(world, {}, unitSquare());
    ASSERT_TRUE(world.rollBack(mark));
    place(world, {1, 0}, unitSquare());
  }
  EXPECT_TRUE(world.isEmpty({}));
  EXPECT_FALSE(world.isEmpty({1, 0}));
}

TEST(GoingBackByHand, NothingIsKeptWithoutMarks) {
  World world;
  const ShapeId square = shapeOf(world, {unitSquare()});
  const auto work = [&] {
    for (int k = 0; k < 100; ++k) {
      ASSERT_TRUE(world.fill({{0, 0}, {20, 20}}, square, 1));
      world.commit();
      ASSERT_TRUE(world.clear(CellRect{{0, 0}, {20, 20}}));
      world.commit();
    }
  };
  work();
  const std::uint64_t bytes = world.stats().bytes;
  const Mark mark = world.checkpoint();
  work();
  EXPECT_GT(world.stats().bytes, bytes + 1'000'000);
  EXPECT_TRUE(world.forget(mark));
  work();
  EXPECT_LT(world.stats().bytes, bytes + 10'000);
}

TEST(GoingBackByHand, WhatCellsHeldIsForgottenWithTheMark) {
  World world;
  const auto work = [&] {
    for (std::int32_t k = 1; k <= 3'000; ++k) {
      place(world, {}, {{0, 0}, {k, 0}, {0, k}});
      world.commit();
      removeAll(world, {});
      world.commit();
    }
  };
  const Mark mark = world.checkpoint();
  work();
  EXPECT_GE(world.stats().contents, 3'000U);
  ASSERT_TRUE(world.rollBack(mark));
  work();
  ASSERT_TRUE(world.forget(mark));
  world.commit();
  EXPECT_EQ(world.stats().contents, 0U);
}

TEST(GoingBackByHand, NothingIsKeptOfCommitsThatFindNothing) {
  World world;
  const Mark mark = world.checkpoint();
  place(world, {}, unitSquare());
  world.commit();
  world.commit();
  const std::uint64_t bytes = world.stats().bytes;
  for (int k = 0; k < 1'000; ++k) world.commit();
  EXPECT_EQ(world.stats().bytes, bytes);
  ASSERT_TRUE(world.rollBack(mark));
  EXPECT_EQ(world.changesOfRollBack().removed.size(), 4U);
}

}  // namespace
}  // namespace lgs::test
