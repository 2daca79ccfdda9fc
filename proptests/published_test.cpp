// The published algorithm under the harness: it departs from the laws in the ways that docs/departures.md shows, and in
// no way on scenes within its reach.
#include "oracle/cgal/cgal_union.h"
#include "oracle/check/features.h"
#include "oracle/check/generator.h"
#include "oracle/check/model.h"
#include "oracle/check/random.h"
#include "oracle/check/shrink.h"
#include "oracle/published/departures.h"
#include "oracle/published/published_player.h"
#include "oracle/reference/compare.h"
#include "oracle/reference/naive.h"
#include "oracle/trace/file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

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

Trace randomTrace(std::uint64_t seed) { return withoutRefused(randomCase({3, 3, 24}, seed)); }

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

// Not a law, but what makes the page complete: no way of departing is left that it does not name.
TEST(Published, DepartsInNoOtherWay) {
  std::size_t departed = 0;
  for (std::uint64_t seed = 0; seed < 4'000; ++seed) {
    const Trace trace = randomTrace(seed);
    const auto run = runPublished(trace);
    ASSERT_TRUE(run);
    if (run->published == run->expected) continue;
    ++departed;
    EXPECT_TRUE(std::ranges::any_of(kDepartures, [&](Departure d) { return shows(*run, d); }))
        << "seed " << seed << '\n'
        << describe(compare(run->expected, run->published)) << printTrace(trace);
  }
  EXPECT_GT(departed, 2'000U);
}

/// The published algorithm and both references, edit by edit.
class Agreement {
 public:
  /// Adds or removes a polygon, unless that would lead out of reach. False if the outlines differ then.
  ::testing::AssertionResult edit(const Edit& edit) {
    std::map<std::string, ScenePolygon> next = placed_;
    if (edit.kind == Edit::Kind::add) {
      next[edit.name] = edit.polygon;
      next[edit.name].block = 1;
    } else if (next.erase(edit.name) == 0) {
      return ::testing::AssertionSuccess();  // it was not let in
    }
    Scene scene;
    for (const auto& [name, polygon] : next) scene.polygons.push_back(polygon);
    if (!isWithinItsReach(scene)) return ::testing::AssertionSuccess();

    const ScenePolygon& polygon = (edit.kind == Edit::Kind::add ? next : placed_).at(edit.name);
    const auto apply = edit.kind == Edit::Kind::add ? &Published::add : &Published::remove;
    (published_.*apply)(polygon.cell, floatVertices(polygon), polygon.block);
    published_.compute();
    placed_ = std::move(next);
    ++compared;
    note(scene, features);

    const Outline outline = outlineOf(published_);
    for (const Outline& expected : {naiveOutline(scene), Outline(cgalUnion(scene)->outline)}) {
      if (outline != expected) return ::testing::AssertionFailure() << describe(compare(expected, outline));
    }
    return ::testing::AssertionSuccess();
  }

  std::size_t compared = 0;
  Features features{};

 private:
  Published published_;
  std::map<std::string, ScenePolygon> placed_;
};

TEST(Published, AgreesWithinItsReach) {
  std::size_t compared = 0;
  std::array<std::size_t, std::tuple_size_v<Features>> casesWith{};
  for (std::uint64_t seed = 0; compared < 10'000; ++seed) {
    const Trace trace = randomTrace(seed);
    Agreement agreement;
    for (const Edit& edit : trace.edits) {
      if (edit.kind == Edit::Kind::commit) continue;
      ASSERT_TRUE(agreement.edit(edit)) << "seed " << seed << '\n' << printTrace(trace);
    }
    compared += agreement.compared;
    for (std::size_t k = 0; k < casesWith.size(); ++k) casesWith[k] += agreement.features[k] ? 1 : 0;
  }
  // Its reach is not only what is easy: contacts that the sweep has to cut at are in it.
  for (const Feature feature : {Feature::midEdge, Feature::partialOverlap, Feature::fourSolids, Feature::manyInCell})
    EXPECT_GT(casesWith[static_cast<std::size_t>(feature)], 50U) << describe(feature);
  EXPECT_EQ(casesWith[static_cast<std::size_t>(Feature::sharedSlope)], 0U);
}

// Section 5: worlds of full blocks, and worlds of right triangles, each turned at random. Every contact there is of whole
// edges, or of vertices.
TEST(Published, AgreesOnTheWorldsOfItsBenchmarks) {
  constexpr std::int32_t kSide = 6, U = kUnitsPerCell;
  const std::vector<std::vector<LocalPoint>> full{{{0, 0}, {U, 0}, {U, U}, {0, U}}};
  const std::vector<std::vector<LocalPoint>> ramps{
      {{0, 0}, {U, 0}, {U, U}}, {{0, 0}, {U, 0}, {0, U}}, {{0, 0}, {U, U}, {0, U}}, {{U, 0}, {U, U}, {0, U}}};
  for (const auto& shapes : {full, ramps}) {
    Random random(1);
    Agreement agreement;
    std::set<std::string> placed;
    for (int k = 0; k < 1'000; ++k) {
      const Cell cell{random.below(kSide), random.below(kSide)};
      const std::string name = std::to_string(cell.i * kSide + cell.j);
      const bool there = placed.erase(name) > 0;
      if (!there) placed.insert(name);
      const Edit edit = there ? Edit::remove(name) : Edit::add(name, {cell, 1, random.pick(shapes)});
      ASSERT_TRUE(agreement.edit(edit)) << "edit " << k;
    }
    EXPECT_EQ(agreement.compared, 1'000U);
  }
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
