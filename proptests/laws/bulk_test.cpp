// The bulk of the random work, in blocks: the engine against the references after every commit of random cases, until a
// block has made its number of comparisons. A block draws its cases from LGS_TEST_SEED (default 1) and its own number,
// so that it is the same wherever it runs, and blocks are what CTest and GoogleTest's sharding share out:
//
//   GTEST_TOTAL_SHARDS=50 GTEST_SHARD_INDEX=7 LGS_TEST_SCALE=25 lgs_engine_tests --gtest_filter='Bulk*'
//
// LGS_TEST_SCALE is how many times as many blocks there are; no two blocks of a run have a case in common.
#include "oracle/check/isolated.h"
#include "oracle/generate/features.h"
#include "oracle/generate/generator.h"
#include "proptests/support/law.h"
#include "proptests/support/played.h"
#include "proptests/support/scale.h"
#include "proptests/support/traces.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace lgs::test {
namespace {

using oracle::Feature;
using oracle::Random;
using oracle::Trace;

struct Tally {
  oracle::CheckStats stats;
  oracle::Distribution cases;
};

void agreesWithTheReferences(const Trace& trace, bool cgal, Tally& tally) {
  oracle::CheckOptions options;
  options.skipRefused = true;
  options.cgal = cgal;
  oracle::Features features{};
  std::size_t commits = 0;
  options.afterCommit = [&](const oracle::Model& standing) {
    constexpr std::size_t kSample = 32;  // looking at each commit would cost as much as the check
    if (commits++ % kSample == 0) note(standing.scene(trace.preserve), features);
    oracle::stillAlive();
    return true;
  };
  const std::uint64_t refused = tally.stats.refused;
  expectNoMismatch(trace, options, tally.stats);
  features[static_cast<std::size_t>(Feature::refusal)] = tally.stats.refused != refused;
  tally.cases.add(features);
}

Trace anyTrace(int, Random random) {
  constexpr oracle::GeneratorOptions kSizes[] = {{.width = 2, .height = 2, .edits = 40, .isOfCalls = true},
                                                 {.width = 3, .height = 3, .edits = 60, .isOfCalls = true},
                                                 {.width = 4, .height = 3, .edits = 80, .isOfCalls = true},
                                                 {.width = 1, .height = 5, .edits = 40, .isOfCalls = true}};
  return oracle::randomCase(kSizes[random.below(4)], random.next());
}

Trace crowdedTrace(int, Random random) {
  const oracle::Crowd crowd = random.chance(25) ? oracle::Crowd::vertices : oracle::Crowd::polygons;
  return oracle::crowdedCase(crowd, oracle::kCrowdedEdits, random.next());
}

class Bulk : public testing::TestWithParam<std::int64_t> {
 protected:
  /// Tries cases until `counter` has come to `goal`.
  void agrees(bool cgal, std::uint64_t oracle::CheckStats::*counter, std::uint64_t goal) {
    const oracle::Shared<Tally> tally;
    Random seeds(Random(testSeed() ^ (cgal ? 0 : 0x5eed)).next() + static_cast<std::uint64_t>(GetParam()));
    const auto law = [&](const Trace& trace) { agreesWithTheReferences(trace, cgal, *tally); };
    for (int batch = 0; (*tally).stats.*counter < goal && !HasFailure(); ++batch) {
      constexpr std::int64_t kAtOnce = 16;
      forAll({.cases = kAtOnce, .seed = seeds.next()}, law, traces(anyTrace, {}));
      if (batch % 8 == 0) forAll({.cases = 1, .seed = seeds.next()}, law, traces(crowdedTrace, {}));
    }
    if (!HasFailure()) expectVariety(*tally);
  }

 private:
  /// No kind of world, edit or door is missing.
  static void expectVariety(const Tally& tally) {
    const oracle::CheckStats& stats = tally.stats;
    fmt::print(
        "{} commits, {} compared with CGAL, {} with the naive reference; {} edits, {} refused; by call: {}\n"
        "{} calls refused for a limit; all read {} times; {} cases, of these\n{}",
        stats.commits, stats.cgal, stats.naive, stats.edits, stats.refused, callsInWords(stats), stats.full, stats.read,
        tally.cases.cases, table(tally.cases));
    for (std::size_t f = 0; f < tally.cases.with.size(); ++f) {
      EXPECT_GE(tally.cases.percent(Feature{f}), 1) << describe(Feature{f});
    }
    EXPECT_GT(stats.full, 0U);
    for (std::size_t k = 0; k < oracle::Call::kKinds; ++k) {
      const auto kind = static_cast<oracle::Call::Kind>(k);
      const bool isElsewhere = kind == oracle::Call::Kind::commit || kind == oracle::Call::Kind::brush;
      if (!isElsewhere) {
        EXPECT_GE(1'000 * stats.made[k], stats.edits) << callsInWords(stats);
      }
    }
  }
};

constexpr std::int64_t kShards = 16;
constexpr std::uint64_t kCgalBlock = 12'500;   // 200,000 in a run at scale 1
constexpr std::uint64_t kNaiveBlock = 12'500;  // 200,000 more
static_assert(static_cast<std::uint64_t>(kShards) * kCgalBlock >= 200'000);

TEST_P(Bulk, AgreesWithBothReferences) { agrees(true, &oracle::CheckStats::cgal, kCgalBlock); }
TEST_P(Bulk, AgreesWithTheNaiveReference) { agrees(false, &oracle::CheckStats::naive, kNaiveBlock); }

INSTANTIATE_TEST_SUITE_P(Bulk, Bulk, testing::Range<std::int64_t>(0, scaled(kShards)));

}  // namespace
}  // namespace lgs::test
