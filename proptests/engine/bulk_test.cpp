// The bulk of the random work, in blocks: the engine against the references after every commit of random cases, until a
// block has made its number of comparisons. A block draws its cases from LGS_TEST_SEED (default 1) and its own number, so
// that it is the same wherever it runs, and blocks are what CTest and GoogleTest's sharding share out:
//
//   GTEST_TOTAL_SHARDS=50 GTEST_SHARD_INDEX=7 LGS_TEST_SCALE=25 lgs_engine_tests --gtest_filter='Bulk*'
//
// LGS_TEST_SCALE is how many times as many blocks there are; no two blocks of a run have a case in common.
#include "oracle/check/checker.h"
#include "oracle/check/isolated.h"
#include "oracle/generate/features.h"
#include "oracle/generate/generator.h"
#include "random_traces.h"
#include "scale.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

namespace lgs::engine_test {
namespace {

using oracle::Feature;
using oracle::Trace;

struct Tally {
  oracle::CheckStats stats;
  oracle::Distribution cases;
};

class Bulk : public testing::TestWithParam<std::int64_t> {
 protected:
  /// Checks cases until `counter` has come to `goal`.
  void check(const std::string& name, bool cgal, std::uint64_t oracle::CheckStats::*counter, std::uint64_t goal) {
    const oracle::Shared<Tally> tally;
    const std::uint64_t seed =
        oracle::Random(testSeed() ^ (cgal ? 0 : 0x5eed)).next() + static_cast<std::uint64_t>(GetParam());
    constexpr std::uint64_t kAtOnce = 64;
    for (std::uint64_t first = 0; (*tally).stats.*counter < goal; first += kAtOnce) {
      const auto caseSeed = [&](std::uint64_t k) {
        return oracle::Random(oracle::Random(seed).next() + first + k).next();
      };
      const auto failure = firstFailure(
          {.name = fmt::format("{}-{}-{}", name, testSeed(), GetParam()),
           .count = kAtOnce,
           .trace =
               [&](std::uint64_t k) {
                 constexpr oracle::GeneratorOptions kSizes[] = {{2, 2, 40}, {3, 3, 60}, {4, 3, 80}, {1, 5, 40}};
                 oracle::GeneratorOptions options = kSizes[(first + k) % 4];
                 options.edits = oracle::editsOf(first + k, options.edits);
                 return oracle::caseOf(first + k, options, caseSeed(k));
               },
           .complaint = [&](const Trace& trace, std::uint64_t) { return complaint(trace, cgal, *tally); }});
      if (failure) {
        FAIL() << failure->text << "\nagain      LGS_TEST_SEED=" << testSeed() << ' '
               << test::again("lgs_engine_tests");
      }
    }
    fmt::print(
        "{} commits, {} compared with CGAL, {} with the naive reference; {} edits, {} refused; {}\n"
        "{} calls refused for a limit; all read {} times; {} cells worn; {} cases, of these\n{}",
        tally->stats.commits, tally->stats.cgal, tally->stats.naive, tally->stats.edits, tally->stats.refused,
        doorsInWords(tally->stats), tally->stats.full, tally->stats.read, tally->stats.worn, tally->cases.cases,
        table(tally->cases));
    for (std::size_t f = 0; f < tally->cases.with.size(); ++f) {
      EXPECT_GE(tally->cases.percent(Feature{f}), 1) << describe(Feature{f});
    }
    EXPECT_GT(tally->stats.full, 0U);
    EXPECT_GT(tally->stats.worn, 0U);
    for (std::size_t door = 0; door < oracle::kDoors; ++door) {
      EXPECT_GE(100 * tally->stats.doors[door], tally->stats.edits) << describe(static_cast<oracle::Door>(door));
    }
  }

 private:
  static std::optional<std::string> complaint(const Trace& trace, bool cgal, Tally& tally) {
    oracle::CheckOptions options;
    options.skipRefused = true;
    options.cgal = cgal;
    oracle::Features features{};
    std::size_t commits = 0;
    options.afterCommit = [&](const oracle::Scene& scene) {
      constexpr std::size_t kSample = 8;  // looking at each commit would cost as much as the check
      if (commits++ % kSample == 0) note(scene, features);
      oracle::stillAlive();
      return true;
    };
    const std::uint64_t refused = tally.stats.refused;
    const auto result = oracle::checkTrace(trace, options, tally.stats);
    if (!result) return "an edit can not be judged: " + result.error().text;
    if (*result) return oracle::describe((*result)->kind) + "\n" + (*result)->text;
    features[static_cast<std::size_t>(Feature::refusal)] = tally.stats.refused != refused;
    tally.cases.add(features);
    return std::nullopt;
  }
};

constexpr std::int64_t kBlocks = 16;
constexpr std::uint64_t kCgalBlock = 12'500;   // 200,000 in a run at scale 1
constexpr std::uint64_t kNaiveBlock = 50'000;  // 800,000
static_assert(static_cast<std::uint64_t>(kBlocks) * kCgalBlock >= 200'000);

TEST_P(Bulk, AgreesWithBothReferences) {
  check("AgreesWithBothReferences", true, &oracle::CheckStats::cgal, kCgalBlock);
}
TEST_P(Bulk, AgreesWithTheNaiveReference) {
  check("AgreesWithTheNaiveReference", false, &oracle::CheckStats::naive, kNaiveBlock);
}

INSTANTIATE_TEST_SUITE_P(Bulk, Bulk, testing::Range<std::int64_t>(0, scaled(kBlocks)));

}  // namespace
}  // namespace lgs::engine_test
