// The published algorithm under the harness: each trace of docs/departures is a mismatch of its kind, of which no call is
// needless; and on the worlds of the article's benchmarks there is none.
#include "bench/published/published_engine.h"
#include "bench/published/published_lattice.h"
#include "oracle/calls/random.h"
#include "oracle/check/finding.h"
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

  std::unique_ptr<TableEngine> engine_ = std::move(*TableEngine::make(bench::publishedEngine()));
};

TEST_F(Published, DepartsAsEachKeptTraceSays) {
  const std::map<std::string, std::string> kinds{{"uncut-single", "missing cut"},
                                                 {"uncut-swept", "missing cut"},
                                                 {"uncut-in-cell", "missing cut"},
                                                 {"kept-in-cell", "uncancelled edge"},
                                                 {"preserved-pair", "lost preserve"},
                                                 {"preserved-side", "lost preserve"},
                                                 {"other-block", "wrong block"},
                                                 {"near-vertices", "wrong link"},
                                                 {"small-angle", "wrong link"},
                                                 {"removed-other", "order of edits matters"},
                                                 {"stale-ghosts", "stale ghost"},
                                                 {"coarse-floats", "other segments"}};
  for (const auto& [name, kind] : kinds) {
    const Trace trace = readTrace(LGS_SOURCE_DIR "/docs/departures/" + name + ".trace").value();
    EXPECT_EQ(kindOf(trace), kind) << name;
    for (std::size_t k = 0; k < trace.calls.size(); ++k) {
      Trace less = trace;
      less.calls.erase(less.calls.begin() + static_cast<std::ptrdiff_t>(k));
      EXPECT_NE(kindOf(less), kind) << name << " without call " << k + 1;
    }
  }
}

// Section 5: worlds of full blocks, and of right triangles, each turned at random.
TEST_F(Published, AgreesOnTheWorldsOfItsBenchmarks) {
  constexpr std::int32_t kSide = 6, U = kUnitsPerCell;
  using Shapes = std::vector<LocalPolygon>;
  const Shapes full{{{0, 0}, {U, 0}, {U, U}, {0, U}}};
  const Shapes ramps{
      {{0, 0}, {U, 0}, {U, U}}, {{0, 0}, {U, 0}, {0, U}}, {{0, 0}, {U, U}, {0, U}}, {{U, 0}, {U, U}, {0, U}}};
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
