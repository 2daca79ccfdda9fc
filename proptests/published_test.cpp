// The published algorithm under the harness: it departs from the laws in the ways that docs/departures.md shows, and in
// no way on scenes within its reach.
#include "oracle/check/generator.h"
#include "oracle/check/model.h"
#include "oracle/check/shrink.h"
#include "oracle/published/departures.h"
#include "oracle/published/published_player.h"
#include "oracle/reference/compare.h"
#include "oracle/trace/file.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lgs::oracle {
namespace {

Trace keptTrace(Departure departure) {
  const auto trace = readTrace(LGS_SOURCE_DIR "/docs/departures/" + nameOf(departure) + ".trace");
  EXPECT_TRUE(trace) << nameOf(departure);
  return trace.value_or(Trace{});
}

bool departs(const Trace& trace, Departure departure) {
  const auto run = runPublished(trace);
  return run && shows(*run, departure);
}

Trace randomTrace(std::uint64_t seed) {
  Model model;
  Trace good;
  const Trace all = randomCase({3, 3, 24}, seed);
  good.preserve = all.preserve;
  for (const Edit& edit : all.edits) {
    if (!model.judge(edit).accepted) continue;
    model.apply(edit);
    good.edits.push_back(edit);
  }
  return good;
}

TEST(Published, DepartsAsEachKeptTraceSays) {
  for (const Departure departure : kDepartures)
    EXPECT_TRUE(departs(keptTrace(departure), departure)) << nameOf(departure);
}

TEST(Published, KeptTracesAreMinimal) {
  for (const Departure departure : kDepartures) {
    const Trace trace = keptTrace(departure);
    for (std::size_t k = 0; k < trace.edits.size(); ++k) {
      Trace less = trace;
      less.edits.erase(less.edits.begin() + static_cast<std::ptrdiff_t>(k));
      EXPECT_FALSE(departs(less, departure)) << nameOf(departure) << " without edit " << k + 1;
    }
  }
}

TEST(Published, DeparturesAreFoundByTheHarness) {
  for (const Departure departure : kDepartures) {
    if (departure == Departure::smallAngle) continue;  // no wedge of the random worlds is that narrow
    std::uint64_t seed = 0;
    while (seed < 5'000 && !departs(randomTrace(seed), departure)) ++seed;
    ASSERT_LT(seed, 5'000U) << nameOf(departure);
    const auto stillDeparts = [&](const Trace& t) { return departs(t, departure); };
    const Trace small = shrink(randomTrace(seed), stillDeparts, std::chrono::seconds(20));
    EXPECT_LE(editCount(small), 4U) << nameOf(departure);
  }
}

/// Part of a scene: polygons are left out until it is within reach.
Scene reachable(Scene scene) {
  for (ScenePolygon& p : scene.polygons) p.block = 1;
  scene.preserve = {};
  Scene kept;
  for (const ScenePolygon& p : scene.polygons) {
    kept.polygons.push_back(p);
    if (!isWithinItsReach(kept)) kept.polygons.pop_back();
  }
  return kept;
}

TEST(Published, AgreesWithinItsReach) {
  std::size_t compared = 0, segments = 0;
  for (std::uint64_t seed = 0; compared < 2'000; ++seed) {
    const auto run = runPublished(randomTrace(seed));
    ASSERT_TRUE(run);
    const Scene scene = reachable(run->scene);
    if (scene.polygons.size() < 3) continue;
    Trace trace;
    for (const ScenePolygon& p : scene.polygons)
      trace.edits.push_back(Edit::add("p" + std::to_string(trace.edits.size()), p));
    const auto again = runPublished(trace);
    ASSERT_TRUE(again);
    ASSERT_EQ(again->published, again->expected)
        << describe(compare(again->expected, again->published)) << printTrace(trace);
    ++compared;
    segments += again->expected.size();
  }
  EXPECT_GT(segments, 20'000U);
}

TEST(Published, ForgetsWhatIsRemoved) {
  const ScenePolygon block{{0, 0}, 1, {{0, 0}, {kUnitsPerCell, 0}, {kUnitsPerCell, kUnitsPerCell}, {0, kUnitsPerCell}}};
  ScenePolygon next = block;
  next.cell = {1, 0};
  const Trace both{{}, {Edit::add("a", block), Edit::add("b", next), Edit::commit(), Edit::remove("b")}};
  const Trace one{{}, {Edit::add("a", block)}};
  EXPECT_EQ(publishedOutline(both), publishedOutline(one));
}

TEST(Published, ZeroHasTwoNames) {
  const std::vector<Vec2> plain{{0, 0}, {1, 0}, {1, 1}}, signedZero{{-0.f, -0.f}, {1, 0}, {1, 1}};
  const auto ghostsWith = [](const std::vector<Vec2>& first, const std::vector<Vec2>& second) {
    Published published;
    published.add({0, 0}, first, 1);
    published.add({-1, -1}, second, 1);
    published.compute();
    return outlineOf(published);
  };
  const std::vector<Vec2> below{{-1, -1}, {0, -1}, {0, 0}};
  EXPECT_NE(ghostsWith(plain, below), ghostsWith(signedZero, below));
}

}  // namespace
}  // namespace lgs::oracle
