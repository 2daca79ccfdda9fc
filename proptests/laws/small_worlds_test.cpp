// All worlds of 2×2 cells over some degenerate shapes, each against the naive reference: segments, ghosts,
// blocks and owners; without a preserve relation, with one that makes two materials, and with one that is not
// transitive.
#include "oracle/check/isolated.h"
#include "oracle/reference/naive.h"
#include "oracle/trace/mirror.h"
#include "proptests/support/exhaust.h"
#include "proptests/support/law.h"
#include "proptests/support/played.h"
#include "proptests/support/traces.h"
#include "proptests/support/worlds.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace lgs::test {
namespace {

using oracle::Call;
using oracle::Trace;
using Polygons = std::vector<LocalPolygon>;

/// Nothing, and shapes that differ in how they meet each side, corner and each other; turned so that none is symmetric
/// to the next.
const std::vector<Polygons>& smallPalette() {
  static const std::vector<Polygons> shapes = [] {
    const std::vector<std::pair<const char*, int>> names{{"full", 0},
                                                         {"ramp", 1},
                                                         {"two ramps", 0},
                                                         {"gentle and its complement", 2},
                                                         {"half", 4},
                                                         {"diamond", 0},
                                                         {"two corner touches", 0},
                                                         {"side spike", 0},
                                                         {"part of a slope", 0},
                                                         {"cup", 2},
                                                         {"hourglass", 4},
                                                         {"square of eight", 0},
                                                         {"comb", 0},
                                                         {"a corner on a slope", 2},
                                                         {"wedge sliver", 4}};
    std::vector<Polygons> out{{}};
    for (const auto& [name, symmetry] : names) {
      out.emplace_back();
      for (const LocalPolygon& p : shapeNamed(name)) out.back().push_back(oracle::turned(p, symmetry));
    }
    return out;
  }();
  return shapes;
}

constexpr std::array<Cell, 4> kCells{{{-1, -1}, {0, -1}, {-1, 0}, {0, 0}}};  // four chunks meet there

/// What stands in each of the cells, by its number in the palette.
using Shapes = std::array<std::size_t, 4>;

std::vector<oracle::ScenePolygon> polygonsOf(const Shapes& shapes, std::size_t cell) {
  std::vector<oracle::ScenePolygon> polygons;
  for (const LocalPolygon& p : smallPalette()[shapes[cell]])
    polygons.push_back({kCells[cell], static_cast<Block>(1 + (cell + polygons.size()) % 3), p});
  return polygons;
}

/// The first of two worlds is built, and becomes the second.
Trace fromOneToTheNext(const Shapes& first, const Shapes& second, const oracle::PreservePairs& preserve) {
  Trace trace{preserve, {}};
  const auto edit = [&](Call::Kind kind, const char* world, const Shapes& shapes, std::size_t cell) {
    int count = 0;
    for (const oracle::ScenePolygon& p : polygonsOf(shapes, cell)) {
      const std::string name = fmt::format("{}{}.{}", world, cell, ++count);
      trace.calls.push_back(kind == Call::Kind::add ? Call::add(name, p) : Call::remove(name));
    }
  };
  for (std::size_t c = 0; c < 4; ++c) edit(Call::Kind::add, "a", first, c);
  trace.calls.push_back(Call::commit());
  for (std::size_t c = 0; c < 4; ++c) {
    if (first[c] == second[c]) continue;
    edit(Call::Kind::remove, "a", first, c);
    edit(Call::Kind::add, "b", second, c);
  }
  trace.calls.push_back(Call::commit());
  return trace;
}

/// One World that becomes one small world after the other.
class Becoming {
 public:
  explicit Becoming(const oracle::PreservePairs& preserve)
      : world_(preserve.empty() ? PreserveRelation()
                                : PreserveRelation([preserve](Block a, Block b) { return preserve(a, b); })) {
    scene_.preserve = preserve;
  }

  /// Whether the World is then as it must be.
  bool become(const Shapes& shapes) {
    const Shapes before = std::exchange(shapes_, shapes);
    scene_.polygons.clear();
    for (std::size_t c = 0; c < 4; ++c) {
      const auto polygons = polygonsOf(shapes, c);
      scene_.polygons.insert(scene_.polygons.end(), polygons.begin(), polygons.end());
      if (before[c] == shapes[c]) continue;
      removeAll(world_, kCells[c]);
      for (const oracle::ScenePolygon& p : polygons) place(world_, p.cell, p.vertices, p.block);
    }
    const Changes& changes = world_.commit();
    return hasTheOutlineOfTheReference() && !mirror_.update(world_, changes);
  }

 private:
  /// Owners, too.
  bool hasTheOutlineOfTheReference() {
    const oracle::OwnedOutline& expected = naive_(scene_);
    const std::vector<SegmentId> ids = world_.segments();
    if (ids.size() != expected.outline.size()) return false;
    for (const SegmentId id : ids) {
      const SegmentFields s = fieldsOf(*world_.segment(id));
      const oracle::OutlineSegment same{s.start, s.end, s.block, s.ghost1, s.ghost2};
      const auto found = std::lower_bound(expected.outline.begin(), expected.outline.end(), same);
      if (found == expected.outline.end() || *found != same) return false;
      const auto k = static_cast<std::size_t>(found - expected.outline.begin());
      const oracle::ScenePolygon& owner = scene_.polygons[expected.owner[k]];
      const auto polygon = world_.polygon(s.polygon);
      if (!polygon || s.cell != owner.cell || !std::ranges::equal(polygon->vertices, owner.vertices)) return false;
    }
    return true;
  }

  World world_;
  oracle::Scene scene_;
  oracle::NaiveReference naive_;
  oracle::Mirror mirror_;
  Shapes shapes_{};
};

/// Where one goes wrong, the trace of the last two is the case to tell.
void expectAllRight(const oracle::PreservePairs& preserve) {
  ASSERT_EQ(smallPalette().size(), 16U);
  struct Progress {
    Shapes before{}, shapes{};
    std::int64_t tried = 0;
    bool isRight = true;
  };
  const oracle::Shared<Progress> last;
  const auto crash = oracle::crashOf([&] {
    Becoming world(preserve);
    Exhaust all;
    while (last->isRight && all.next()) {
      Shapes shapes;
      for (std::size_t& shape : shapes) shape = all.below(smallPalette().size());
      if (all.isLeftOut()) continue;
      oracle::stillAlive();
      *last = {last->shapes, shapes, last->tried + 1, false};
      last->isRight = world.become(shapes);
    }
  });
  if (last->isRight && !crash) {
    EXPECT_EQ(last->tried, exhausted(65'536));
    return;
  }
  Trace trace = fromOneToTheNext(last->before, last->shapes, preserve);
  const auto agrees = [](const Trace& t) { expectNoMismatch(t, {.cgal = false, .unionAtEnd = true}); };
  forAll({.cases = 1}, agrees, traces([&](int, oracle::Random) { return trace; }));
  testing::Test::RecordProperty("cases", std::to_string(last->tried));
  ADD_FAILURE() << "world " << last->tried
                << (testing::Test::HasFailure() ? "" : ", but only after all those before it") << ":\n"
                << printTrace(trace);
}

TEST(SmallWorlds, AreRight) { expectAllRight({}); }

TEST(SmallWorlds, AreRightWithTwoMaterials) {
  oracle::PreservePairs preserve;
  preserve.add(1, 2);
  preserve.add(3, 2);
  expectAllRight(preserve);
}

TEST(SmallWorlds, AreRightWithARelationThatIsNotTransitive) {
  oracle::PreservePairs preserve;
  preserve.add(1, 2);
  preserve.add(3, 3);
  expectAllRight(preserve);
}

}  // namespace
}  // namespace lgs::test
