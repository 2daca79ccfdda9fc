// All worlds of 2×2 cells over some degenerate shapes, each against the naive reference: segments, ghosts,
// blocks and owners; without a preserve relation, with one that makes two materials, and with one that is not
// transitive.
#include "oracle/check/failure.h"
#include "oracle/check/isolated.h"
#include "oracle/reference/naive.h"
#include "oracle/trace/mirror.h"
#include "proptests/first_failure.h"
#include "scale.h"
#include "support.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>

namespace lgs::engine_test {
namespace {

using oracle::Edit;
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

/// The shapes of world `code`, cell by cell.
std::array<std::size_t, 4> shapesOf(std::int64_t code) {
  std::array<std::size_t, 4> shapes{};
  for (std::size_t& shape : shapes) {
    shape = static_cast<std::size_t>(code) % smallPalette().size();
    code /= static_cast<std::int64_t>(smallPalette().size());
  }
  return shapes;
}

Block blockOf(std::size_t cell, std::size_t polygon) { return static_cast<Block>(1 + (cell + polygon) % 3); }

/// World `before`, which becomes world `code`.
Trace fromOneToTheNext(const oracle::PreservePairs& preserve, std::int64_t before, std::int64_t code) {
  Trace trace{preserve, {}};
  const auto nameOf = [](std::int64_t world, std::size_t c, std::size_t k) {
    return fmt::format("w{}.{}.{}", world, c, k);
  };
  std::array<std::size_t, 4> shapes{};
  for (const std::int64_t world : {before, code}) {
    for (std::size_t c = 0; c < 4; ++c) {
      const std::size_t shape = shapesOf(world)[c];
      if (shape == shapes[c]) continue;
      if (world != before)
        for (std::size_t k = 0; k < smallPalette()[shapes[c]].size(); ++k)
          trace.edits.push_back(Edit::remove(nameOf(before, c, k)));
      for (std::size_t k = 0; k < smallPalette()[shape].size(); ++k)
        trace.edits.push_back(Edit::add(nameOf(world, c, k), {kCells[c], blockOf(c, k), smallPalette()[shape][k]}));
      shapes[c] = shape;
    }
    trace.edits.push_back(Edit::commit());
  }
  return trace;
}

/// Worlds 0 … n⁴-1, one after the other, in one World.
class SmallWorlds {
 public:
  explicit SmallWorlds(const oracle::PreservePairs& preserve)
      : world_(preserve.empty() ? PreserveRelation()
                                : PreserveRelation([preserve](Block a, Block b) { return preserve(a, b); })) {
    scene_.preserve = preserve;
  }

  void become(std::int64_t code) {
    const auto before = std::exchange(shapes_, shapesOf(code));
    for (std::size_t c = 0; c < 4; ++c) {
      const std::size_t shape = shapes_[c];
      if (shape == before[c]) continue;
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

  std::optional<std::string> complaint() {
    if (!isRight()) return "segments, ghosts, blocks or owners are not those of the naive reference";
    return mirror_.update(world_, *changes_);
  }

 private:
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

  World world_;
  oracle::Scene scene_;
  oracle::NaiveReference naive_;
  oracle::Mirror mirror_;
  const Changes* changes_ = nullptr;
  std::array<std::size_t, 4> shapes_{};
};

/// One world becomes all of them. What fails is told as a trace of the last two, where those alone show it; otherwise it
/// takes those before them, too.
void exhaust(const std::string& name, const oracle::PreservePairs& preserve) {
  ASSERT_EQ(smallPalette().size(), 16U);
  SmallWorlds worlds(preserve);
  const oracle::Shared<std::uint64_t> tried;
  const auto codeOf = [](std::uint64_t k) { return static_cast<std::int64_t>(k) * exhaustStride(); };
  const auto failure = test::firstFailure(
      {.name = name,
       .count = static_cast<std::uint64_t>(exhausted(65'536)),
       .trace = [&](std::uint64_t k) { return fromOneToTheNext(preserve, codeOf(k == 0 ? 0 : k - 1), codeOf(k)); },
       .complaint = [&](const Trace& trace, std::uint64_t k) -> std::optional<std::string> {
         if (k == *tried) {  // its turn
           ++*tried;
           worlds.become(codeOf(k));
           if (const auto problem = worlds.complaint()) return fmt::format("world {}: {}", codeOf(k), *problem);
           return std::nullopt;
         }
         const auto mismatch = oracle::findMismatch(trace, {.cgal = false, .unionAtEnd = true});
         return mismatch ? std::optional(oracle::describe(*mismatch, trace)) : std::nullopt;
       }});
  if (failure) {
    FAIL() << failure->text << "\nagain      " << test::again("lgs_engine_tests") << "\nat         world "
           << codeOf(*tried - 1) << ", after all those before it";
  }
  EXPECT_EQ(*tried, static_cast<std::uint64_t>(exhausted(65'536)));
}

TEST(SmallWorlds, AreRight) { exhaust("small-worlds", {}); }

TEST(SmallWorlds, AreRightWithTwoMaterials) {
  oracle::PreservePairs preserve;
  preserve.add(1, 2);
  preserve.add(3, 2);
  exhaust("small-worlds-two-materials", preserve);
}

TEST(SmallWorlds, AreRightWithARelationThatIsNotTransitive) {
  oracle::PreservePairs preserve;
  preserve.add(1, 2);
  preserve.add(3, 3);
  exhaust("small-worlds-not-transitive", preserve);
}

}  // namespace
}  // namespace lgs::engine_test
