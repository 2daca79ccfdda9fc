// What the checker counts of this library's engine, and what it sees of calls.
#include "checking.h"
#include "oracle/check/observed.h"
#include "oracle/generate/generator.h"
#include "read_traces.h"

namespace lgs::oracle::library {
namespace {

TEST(CheckStatistics, CountWhatWasDone) {
  CheckStats stats;
  Trace trace;
  for (int k = 0; k < 7; ++k) {
    trace.calls.push_back(square("p" + std::to_string(k), {2 * k, 0}));
    trace.calls.push_back(Call::commit());
  }
  EXPECT_FALSE(checked(trace, {}, stats));
  EXPECT_EQ(stats.edits, 7U);
  EXPECT_EQ(stats.commits, 7U);
  EXPECT_EQ(stats.whole, 7U);
  EXPECT_EQ(stats.naive, 7U);
  EXPECT_EQ(stats.cgal, 7U);
  EXPECT_EQ(stats.full, 0U);
  EXPECT_EQ(stats.read, 1U) << "at the end; of the wholes every eighth";
  trace.calls.push_back(Call::commit());
  EXPECT_FALSE(checked(trace, {}, stats));
  EXPECT_EQ(stats.read, 1U + 2U);
}

constexpr GeneratorOptions kOfCalls{.width = 3, .height = 3, .edits = 60, .isOfCalls = true};

TEST(CheckStatistics, CountCallsAndRefusals) {
  CheckStats stats;
  for (std::uint64_t seed = 0; seed < 80; ++seed) EXPECT_FALSE(checked(randomCase(kOfCalls, seed), {}, stats));
  for (std::size_t k = 0; k < Call::kKinds; ++k) {
    const auto kind = static_cast<Call::Kind>(k);
    const bool isElsewhere = kind == Call::Kind::commit || kind == Call::Kind::brush;
    EXPECT_EQ(stats.made[k] > 0, !isElsewhere) << callsInWords(stats);
  }
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

// --- Calls ------------------------------------------------------------------------------------------------------------

TEST(CheckCalls, AGroupIsKeptOrNot) {
  for (const auto keeps : {Call::Keeps::always, Call::Keeps::never, Call::Keeps::ifAll}) {
    Player player({});
    Call group = Call::of(Call::Kind::group);
    group.group = {square("a", {0, 0}), square("b", {1, 0})};
    group.keeps = keeps;
    EXPECT_TRUE(player.apply(group));
    player.commit();
    EXPECT_EQ(player.world().stats().polygons, keeps == Call::Keeps::never ? 0U : 2U);
    EXPECT_EQ(player.standing().polygons(), player.world().stats().polygons);
  }
}

// What was undone or refused is left out of the past, and must not show.
TEST(CheckCalls, TheWorldIsThatOfItsPast) {
  Player player({});
  for (const Call& call : {Call::of(Call::Kind::mark), square("a", {0, 0}), Call::commit(),
                           Call::of(Call::Kind::rollBack), square("b", {1, 0}), Call::commit(), square("c", {1, 0})})
    static_cast<void>(player.apply(call));
  EXPECT_EQ(player.past().size(), 3U);
  EXPECT_EQ(wrongPast(player), "");
  ASSERT_TRUE(player.world().add({5, 5}, kUnitSquare, 1));
  EXPECT_EQ(wrongPast(player),
            "a world in which nothing was undone or refused has other polygons, or by other handles");
}

}  // namespace
}  // namespace lgs::oracle::library
