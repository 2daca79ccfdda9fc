// All worlds of 2×2 cells over a palette of degenerate shapes, each against the naive reference: segments, ghosts,
// blocks and owners; without a preserve relation, with one that makes two materials, and with one that is not
// transitive.
#include "oracle/reference/naive.h"
#include "oracle/trace/mirror.h"
#include "scale.h"
#include "support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>

namespace lgs::engine_test {
namespace {

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
      for (const LocalPolygon& p : paletteShape(name)) out.back().push_back(oracle::turned(p, symmetry));
    }
    return out;
  }();
  return shapes;
}

constexpr std::array<Cell, 4> kCells{{{-1, -1}, {0, -1}, {-1, 0}, {0, 0}}};  // four chunks meet there

/// Worlds 0 … n⁴-1, one after the other, in one World.
class SmallWorlds {
 public:
  explicit SmallWorlds(const oracle::PreservePairs& preserve)
      : world_(preserve.empty() ? PreserveRelation()
                                : PreserveRelation([preserve](Block a, Block b) { return preserve(a, b); })) {
    scene_.preserve = preserve;
  }

  void become(std::int64_t code) {
    const auto n = static_cast<std::int64_t>(smallPalette().size());
    for (std::size_t c = 0; c < 4; ++c, code /= n) {
      const auto shape = static_cast<std::size_t>(code % n);
      if (shape == shapes_[c]) continue;
      shapes_[c] = shape;
      removeAll(world_, kCells[c]);
      for (std::size_t k = 0; k < smallPalette()[shape].size(); ++k)
        place(world_, kCells[c], smallPalette()[shape][k], blockOf(c, k));
    }
    scene_.polygons.clear();
    for (std::size_t c = 0; c < 4; ++c)
      for (std::size_t k = 0; k < smallPalette()[shapes_[c]].size(); ++k)
        scene_.polygons.push_back({kCells[c], blockOf(c, k), smallPalette()[shapes_[c]][k]});
    changes_ = &world_.commit();
  }

  /// Whether the outline and its owners are those of the naive reference.
  bool isRight() {
    const oracle::OwnedOutline& expected = naive_(scene_);
    const std::vector<SegmentId> ids = world_.segments();
    if (ids.size() != expected.outline.size()) return false;
    for (const SegmentId id : ids) {
      const Segment s = *world_.segment(id);
      oracle::OutlineSegment want{s.start, s.end, s.block, {}, {}};
      if (s.predecessor) want.ghost1 = s.ghost1;
      if (s.successor) want.ghost2 = s.ghost2;
      const auto found = std::lower_bound(expected.outline.begin(), expected.outline.end(), want);
      if (found == expected.outline.end() || *found != want) return false;
      const auto k = static_cast<std::size_t>(found - expected.outline.begin());
      const oracle::ScenePolygon& owner = scene_.polygons[expected.owner[k]];
      const auto polygon = world_.polygon(s.polygon);
      if (!polygon || s.cell != owner.cell || !std::ranges::equal(polygon->vertices, owner.vertices)) return false;
    }
    return true;
  }

  std::optional<std::string> wrongChange() { return mirror_.update(world_, *changes_); }

 private:
  static Block blockOf(std::size_t cell, std::size_t polygon) { return static_cast<Block>(1 + (cell + polygon) % 3); }

  World world_;
  oracle::Scene scene_;
  oracle::NaiveReference naive_;
  oracle::Mirror mirror_;
  const Changes* changes_ = nullptr;
  std::array<std::size_t, 4> shapes_{};
};

void exhaust(const oracle::PreservePairs& preserve) {
  const auto n = static_cast<std::int64_t>(smallPalette().size());
  ASSERT_EQ(n, 16);
  SmallWorlds worlds(preserve);
  std::int64_t tried = 0;
  for (std::int64_t code = 0; code < n * n * n * n; code += exhaustStride(), ++tried) {
    worlds.become(code);
    ASSERT_TRUE(worlds.isRight()) << "world " << code;
    if (const auto problem = worlds.wrongChange()) FAIL() << "world " << code << ": " << *problem;
  }
  EXPECT_EQ(tried, exhausted(65'536));
}

TEST(SmallWorlds, AreRight) { exhaust({}); }

TEST(SmallWorlds, AreRightWithTwoMaterials) {
  oracle::PreservePairs preserve;
  preserve.add(1, 2);
  preserve.add(3, 2);
  exhaust(preserve);
}

TEST(SmallWorlds, AreRightWithARelationThatIsNotTransitive) {
  oracle::PreservePairs preserve;
  preserve.add(1, 2);
  preserve.add(3, 3);
  exhaust(preserve);
}

}  // namespace
}  // namespace lgs::engine_test
