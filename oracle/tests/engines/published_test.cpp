// The published algorithm under the harness: each trace of docs/departures is a mismatch of its kind, and on the worlds of
// the article's benchmarks there is none.
#include "bench/published/published_engine.h"
#include "bench/published/published_lattice.h"
#include "oracle/calls/random.h"
#include "oracle/check/finding.h"
#include "oracle/engine/play.h"
#include "oracle/engine/table_engine.h"
#include "oracle/tests/engines/workbench.h"
#include "oracle/trace/file.h"

#include <map>
#include <set>

namespace lgs::oracle {
namespace {

class Published : public testing::Test {
 protected:
  /// What kind of mismatch the trace shows; empty if it is none, and where an edit would be bad.
  std::string kindOf(const Trace& trace) const {
    CheckStats stats;
    const auto found = checkTrace(trace, {.engine = engine_.get()}, stats);
    return found && *found ? kindOfFinding(**found, *engine_) : "";
  }

  static Trace kept(const std::string& name) {
    return readTrace(LGS_SOURCE_DIR "/docs/departures/" + name + ".trace").value();
  }

  std::unique_ptr<TableEngine> engine_ = std::move(*TableEngine::make(bench::publishedEngine()));
};

TEST_F(Published, DepartsAsEachKeptTraceSays) {
  const std::map<std::string, std::string> kinds{{"uncut-single", "missing cut"},
                                                 {"uncut-swept", "missing cut"},
                                                 {"uncut-in-cell", "missing cut"},
                                                 {"kept-in-cell", "uncancelled edge"},
                                                 {"preserved-pair", "lost preserve"},
                                                 {"preserved-side", "uncancelled edge"},
                                                 {"other-block", "order of edits matters"},
                                                 {"near-vertices", "wrong link"},
                                                 {"small-angle", "wrong link"},
                                                 {"removed-other", "uncancelled edge"},
                                                 {"stale-ghosts", "uncancelled edge"},
                                                 {"coarse-floats", "other segments"}};
  for (const auto& [name, kind] : kinds) EXPECT_EQ(kindOf(kept(name)), kind) << name;
}

TEST_F(Published, DependsOnThePast) {
  Trace stale = kept("stale-ghosts"), removed = kept("removed-other");
  const Outline ofStale = play(stale, *engine_).value(), ofRemoved = play(removed, *engine_).value();
  std::erase_if(stale.calls, [](const Call& call) { return call.kind == Call::Kind::commit; });
  EXPECT_NE(ofStale, play(stale, *engine_).value());
  removed.calls.resize(1);
  EXPECT_NE(ofRemoved, play(removed, *engine_).value());
}

// Section 5: worlds of full blocks, and of right triangles, each turned at random.
TEST_F(Published, AgreesOnTheWorldsOfItsBenchmarks) {
  constexpr std::int32_t kSide = 6, kEnd = kUnitsPerCell;
  using Shapes = std::vector<LocalPolygon>;
  const Shapes full{{{0, 0}, {kEnd, 0}, {kEnd, kEnd}, {0, kEnd}}};
  const Shapes ramps{{{0, 0}, {kEnd, 0}, {kEnd, kEnd}},
                     {{0, 0}, {kEnd, 0}, {0, kEnd}},
                     {{0, 0}, {kEnd, kEnd}, {0, kEnd}},
                     {{kEnd, 0}, {kEnd, kEnd}, {0, kEnd}}};
  for (const Shapes& shapes : {full, ramps}) {
    Random random(1);
    std::set<std::string> placed;
    Trace digging;
    for (int edit = 0; edit < 1'000; ++edit) {
      const Cell cell{random.below(kSide), random.below(kSide)};
      const std::string name = std::to_string(cell.i * kSide + cell.j);
      const bool isThere = placed.erase(name) > 0;
      if (!isThere) placed.insert(name);
      digging.calls.push_back(isThere ? Call::remove(name) : Call::add(name, {cell, 1, random.pick(shapes)}));
      digging.calls.push_back(Call::commit());
    }
    EXPECT_EQ(kindOf(digging), "");
  }
}

TEST_F(Published, ZeroHasTwoNames) {
  using Vertices = std::vector<bench::Vec2>;
  const Vertices plain{{0, 0}, {1, 0}, {1, 1}}, signedZero{{-0.F, -0.F}, {1, 0}, {1, 1}};
  const auto linksOf = [](const Vertices& first) {
    bench::Published published;
    published.add({0, 0}, first, 1);
    published.add({-1, -1}, Vertices{{-1, -1}, {0, -1}, {0, 0}}, 1);
    published.compute();
    return outlineOf(published);
  };
  EXPECT_NE(linksOf(plain), linksOf(signedZero));
}

}  // namespace
}  // namespace lgs::oracle
