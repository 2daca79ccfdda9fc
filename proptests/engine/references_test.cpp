// The engine against the references, after every commit of random cases: all that the checker of `lgs check` compares
// (naive reference, CGAL's union, change lists on a mirror, refusals, history), and owners besides.
#include "oracle/check/checker.h"
#include "oracle/check/isolated.h"
#include "oracle/reference/naive.h"
#include "oracle/trace/player.h"
#include "random_traces.h"
#include "support.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace lgs::engine_test {
namespace {

using oracle::Random;
using oracle::Trace;

RC_GTEST_PROP(References, AgreeWithTheEngineAfterEveryCommit, ()) {
  static const oracle::Shared<oracle::CheckStats> stats;  // of all cases together
  forRandomTraces("references", 80, {.withRefused = true},
                  [](const Trace& trace, Random) -> std::optional<std::string> {
                    oracle::CheckOptions options;
                    options.skipRefused = true;
                    const auto result = oracle::checkTrace(trace, options, *stats);
                    if (!result) return "an edit can not be judged: " + result.error().text;
                    if (!*result) return std::nullopt;
                    return oracle::describe((*result)->kind) + "\n" + (*result)->text;
                  });
  testing::Test::RecordProperty("commits", std::to_string(stats->commits));
  testing::Test::RecordProperty("comparisons_with_cgal", std::to_string(stats->cgal));
  testing::Test::RecordProperty("refused", std::to_string(stats->refused));
}

/// A segment with its owner as a value.
using Owned = std::tuple<oracle::OutlineSegment, Cell, LocalPolygon>;

std::vector<Owned> ownedByEngine(const World& world) {
  std::vector<Owned> out;
  for (const SegmentId id : world.segments()) {
    const auto f = fieldsOf(*world.segment(id));
    const auto polygon = world.polygon(std::get<PolygonHandle>(f));
    if (!polygon) continue;
    out.emplace_back(
        oracle::OutlineSegment{std::get<1>(f), std::get<2>(f), polygon->block, std::get<5>(f), std::get<6>(f)},
        std::get<Cell>(f), LocalPolygon(polygon->vertices.begin(), polygon->vertices.end()));
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::vector<Owned> ownedByNaive(const oracle::Scene& scene) {
  oracle::NaiveReference naive;
  const oracle::OwnedOutline& owned = naive(scene);
  std::vector<Owned> out;
  for (std::size_t k = 0; k < owned.outline.size(); ++k) {
    const oracle::ScenePolygon& p = scene.polygons[owned.owner[k]];
    out.emplace_back(owned.outline[k], p.cell, p.vertices);
  }
  std::sort(out.begin(), out.end());
  return out;
}

RC_GTEST_PROP(References, AgreeOnOwners, ()) {
  forRandomTraces("owners", 20, {}, [](const Trace& trace, Random) -> std::optional<std::string> {
    oracle::Player player(trace.preserve);
    std::optional<std::string> problem;
    const auto played = oracle::play(trace, player, [&](oracle::Player& p, const Changes&) {
      if (ownedByEngine(p.world()) != ownedByNaive(p.scene())) problem = "segments or their owners differ";
      return !problem;
    });
    return played ? problem : message(played.error(), "trace");
  });
}

}  // namespace
}  // namespace lgs::engine_test
