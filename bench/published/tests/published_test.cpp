// The published algorithm under the harness: it departs from the laws in the ways that docs/internals/departures.md
// shows, and in no way on scenes within its reach.
#include "bench/published/published_lattice.h"
#include "bench/published/tests/departures.h"
#include "oracle/calls/random.h"
#include "oracle/cgal/cgal_union.h"
#include "oracle/check/isolated.h"
#include "oracle/check/shrink.h"
#include "oracle/generate/features.h"
#include "oracle/generate/generator.h"
#include "oracle/reference/compare.h"
#include "oracle/reference/naive.h"
#include "oracle/trace/file.h"
#include "oracle/trace/model.h"
#include "proptests/support/law.h"
#include "proptests/support/scale.h"
#include "proptests/support/traces.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

namespace lgs::bench {

using namespace oracle;

namespace {

Trace keptTrace(Departure departure) {
  const auto trace = readTrace(fmt::format("{}/docs/departures/{}.trace", LGS_SOURCE_DIR, nameOf(departure)));
  EXPECT_TRUE(trace) << nameOf(departure);
  return trace.value_or(Trace{});
}

bool departs(const Trace& trace, Departure departure) {
  const auto run = runPublished(trace);
  return run && shows(*run, departure);
}

Trace randomTrace(std::uint64_t seed) { return withoutRefused(randomCase({3, 3, 24}, seed)); }

rc::Gen<Trace> randomTraces() {
  return test::traces([](int, Random random) { return randomTrace(random.next()); });
}

TEST(Published, DepartsAsEachKeptTraceSays) {
  for (const Departure departure : kDepartures)
    EXPECT_TRUE(departs(keptTrace(departure), departure)) << nameOf(departure);
}

TEST(Published, KeptTracesAreMinimal) {
  for (const Departure departure : kDepartures) {
    const Trace trace = keptTrace(departure);
    for (std::size_t k = 0; k < trace.calls.size(); ++k) {
      Trace less = trace;
      less.calls.erase(less.calls.begin() + static_cast<std::ptrdiff_t>(k));
      EXPECT_FALSE(departs(less, departure)) << nameOf(departure) << " without edit " << k + 1;
    }
  }
}

TEST(Published, DeparturesAreFoundByTheHarness) {
  for (const Departure departure : kDepartures) {
    if (departure == Departure::smallAngle) continue;  // few wedges of the random worlds are that narrow
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
  const Shared<std::int64_t> departed;
  const auto law = [&](const Trace& trace) {
    const auto run = runPublished(trace);
    if (!run) test::failIf(run.error().text);
    if (run->published == run->expected) return;
    ++*departed;
    if (std::ranges::any_of(kDepartures, [&](Departure d) { return shows(*run, d); })) return;
    test::failIf("it departs in a way that has no name:\n" + describe(compare(run->expected, run->published)));
  };
  test::forAll(4'000, law, randomTraces());
  if (HasFailure() || test::testScale() < 1) return;
  EXPECT_GT(*departed, 2'000);
}

/// The published algorithm and both references, edit by edit.
class Agreement {
 public:
  /// All edits of a trace. What differs after one of them, if anything does.
  std::optional<std::string> play(const Trace& trace) {
    for (std::size_t k = 0; k < trace.calls.size(); ++k) {
      if (trace.calls[k].kind == Call::Kind::commit) continue;
      if (const auto problem = edit(trace.calls[k])) return fmt::format("after edit {}:\n{}", k + 1, *problem);
    }
    return std::nullopt;
  }

  std::size_t compared = 0;
  Features features{};

 private:
  /// Adds or removes a polygon, unless that would lead out of reach. What differs then, if anything does.
  std::optional<std::string> edit(const Call& edit) {
    std::map<std::string, ScenePolygon> next = placed_;
    if (edit.kind == Call::Kind::add) {
      next[edit.name()] = edit.polygon();
      next[edit.name()].block = 1;
    } else if (next.erase(edit.name()) == 0) {
      return std::nullopt;  // it was not let in
    }
    Scene scene;
    for (const auto& [name, polygon] : next) scene.polygons.push_back(polygon);
    if (!isWithinItsReach(scene)) return std::nullopt;

    const ScenePolygon& polygon = (edit.kind == Call::Kind::add ? next : placed_).at(edit.name());
    const auto apply = edit.kind == Call::Kind::add ? &Published::add : &Published::remove;
    (published_.*apply)(polygon.cell, floatVertices(polygon), polygon.block);
    published_.compute();
    placed_ = std::move(next);
    ++compared;
    note(scene, features);

    const Outline outline = outlineOf(published_);
    for (const Outline& expected : {naiveOutline(scene), Outline(cgalUnion(scene)->outline)}) {
      if (outline != expected) return describe(compare(expected, outline));
    }
    return std::nullopt;
  }

  Published published_;
  std::map<std::string, ScenePolygon> placed_;
};

TEST(Published, AgreesWithinItsReach) {
  struct Seen {
    std::size_t compared = 0;
    std::array<std::size_t, std::tuple_size_v<Features>> casesWith{};
  };
  const Shared<Seen> seen;
  const auto law = [&](const Trace& trace) {
    Agreement agreement;
    const auto problem = agreement.play(trace);
    seen->compared += agreement.compared;
    for (std::size_t k = 0; k < seen->casesWith.size(); ++k) seen->casesWith[k] += agreement.features[k] ? 1 : 0;
    test::failIf(problem);
  };
  for (std::uint64_t seed = test::testSeed(); seen->compared < 10'000; ++seed) {
    test::forAll({.cases = 50, .seed = seed}, law, randomTraces());
    if (HasFailure()) return;
  }
  // Its reach is not only what is easy: contacts that the sweep has to cut at are in it.
  for (const Feature feature : {Feature::midEdge, Feature::partialOverlap, Feature::fourSolids, Feature::manyInCell})
    EXPECT_GT(seen->casesWith[static_cast<std::size_t>(feature)], 50U) << describe(feature);
  EXPECT_EQ(seen->casesWith[static_cast<std::size_t>(Feature::sharedSlope)], 0U);
}

// Section 5: worlds of full blocks, and worlds of right triangles, each turned at random. Every contact there is of
// whole edges, or of vertices.
TEST(Published, AgreesOnTheWorldsOfItsBenchmarks) {
  constexpr std::int32_t kSide = 6, U = kUnitsPerCell;
  const std::vector<std::vector<LocalPoint>> full{{{0, 0}, {U, 0}, {U, U}, {0, U}}};
  const std::vector<std::vector<LocalPoint>> ramps{
      {{0, 0}, {U, 0}, {U, U}}, {{0, 0}, {U, 0}, {0, U}}, {{0, 0}, {U, U}, {0, U}}, {{U, 0}, {U, U}, {0, U}}};
  const auto digging = [](const std::vector<std::vector<LocalPoint>>& shapes) {
    Random random(1);
    std::set<std::string> placed;
    Trace result;
    for (int edit = 0; edit < 1'000; ++edit) {
      const Cell cell{random.below(kSide), random.below(kSide)};
      const std::string name = std::to_string(cell.i * kSide + cell.j);
      const bool there = placed.erase(name) > 0;
      if (!there) placed.insert(name);
      result.calls.push_back(there ? Call::remove(name) : Call::add(name, {cell, 1, random.pick(shapes)}));
    }
    return result;
  };
  const Shared<std::size_t> compared;
  const auto law = [&](const Trace& trace) {
    Agreement agreement;
    const auto problem = agreement.play(trace);
    *compared += agreement.compared;
    test::failIf(problem);
  };
  for (const auto& shapes : {full, ramps})
    test::forAll({.cases = 1}, law, test::traces([&](int, Random) { return digging(shapes); }));
  if (HasFailure()) return;
  EXPECT_EQ(*compared, 2'000U);
}

TEST(Published, ForgetsWhatIsRemoved) {
  const ScenePolygon block{{0, 0}, 1, {{0, 0}, {kUnitsPerCell, 0}, {kUnitsPerCell, kUnitsPerCell}, {0, kUnitsPerCell}}};
  ScenePolygon next = block;
  next.cell = {1, 0};
  const Trace both{{}, {Call::add("a", block), Call::add("b", next), Call::commit(), Call::remove("b")}};
  const Trace one{{}, {Call::add("a", block)}};
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
}  // namespace lgs::bench
