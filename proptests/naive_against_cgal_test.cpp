// The naive reference and CGAL's union against each other, on random degenerate scenes.
#include "oracle/cgal/cgal_union.h"
#include "oracle/check/isolated.h"
#include "oracle/generate/random.h"
#include "oracle/reference/compare.h"
#include "oracle/reference/naive.h"
#include "oracle/reference/scene.h"
#include "oracle/trace/model.h"
#include "proptests/first_failure.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace lgs::oracle {
namespace {

using Content = std::vector<std::vector<LocalPoint>>;  // the polygons of one cell

constexpr std::int32_t kFull = kUnitsPerCell;
constexpr std::int32_t kHalf = kFull / 2;
constexpr std::int32_t kThird = kFull / 3;

// Contents of a cell that touch each other and the rim in every degenerate way there is; used in all eight symmetries.
const std::vector<Content> kPalette = {
    {{{0, 0}, {kFull, 0}, {kFull, kFull}, {0, kFull}}},                                             // full
    {{{0, 0}, {kFull, 0}, {kFull, kFull}}},                                                         // ramp
    {{{0, 0}, {kFull, 0}, {kFull, kFull}}, {{0, 0}, {kFull, kFull}, {0, kFull}}},                   // diagonal shared
    {{{0, 0}, {kFull, 0}, {kFull, kFull}}, {{0, 0}, {kHalf, kHalf}, {0, kFull}}},                   // shared in part
    {{{0, 0}, {kFull, 0}, {kFull, kFull}}, {{kThird, kThird}, {kThird, kFull}, {0, kFull}}},        // tip on a slope
    {{{0, 0}, {kFull, 0}, {kFull, kHalf}, {0, kHalf}}},                                             // half tile
    {{{0, 0}, {kFull, 0}, {kFull, kHalf}, {0, kHalf}}, {{0, kHalf}, {kThird, kHalf}, {0, kFull}}},  // T-contact
    {{{kHalf, 0}, {kFull, kHalf}, {kHalf, kFull}, {0, kHalf}}},                                     // diamond
    {{{kHalf, 0}, {kFull, kHalf}, {kHalf, kFull}, {0, kHalf}}, {{0, 0}, {kHalf, 0}, {0, kHalf}}},   // and a corner
    {{{0, 0}, {kFull, 0}, {kFull, kThird}, {kThird, kThird}, {kThird, kFull}, {0, kFull}}},         // L
    {{{0, 0},
      {kFull, 0},
      {kFull, kFull},
      {kThird, kFull},
      {kThird, kHalf},
      {kHalf, kHalf},
      {kHalf, kThird},
      {0, kThird}},
     {{0, kThird}, {kThird, kHalf}, {kThird, kFull}, {0, kFull}}},                                // pocket, closed
    {{{kThird, kThird}, {kHalf, kThird}, {kHalf, kHalf}, {kThird, kHalf}}},                       // island
    {{{0, 0}, {kHalf, kHalf}, {0, kFull}}, {{kFull, 0}, {kFull, kFull}, {kHalf, kHalf}}},         // hourglass
    {{{0, 1}, {1, 0}, {kFull, kFull - 1}, {kFull - 1, kFull}}},                                   // sliver, by 1 unit
    {{{0, kThird}, {kFull, 0}, {kFull, kHalf}}, {{0, kThird}, {kFull, kHalf}, {kThird, kFull}}},  // slanted, shared
    {{{0, 0}, {kThird, 0}, {kHalf, 0}, {kFull, 0}, {kHalf, kThird}}},                             // collinear vertices
};

class RandomScenes {
 public:
  explicit RandomScenes(std::uint64_t seed) : random_(seed) {}

  Scene scene(std::int32_t side, Cell origin, Block blocks) {
    Scene result;
    for (std::int32_t i = 0; i < side; ++i) {
      for (std::int32_t j = 0; j < side; ++j) {
        if (below(8) == 0) continue;
        const auto symmetry = below(8);
        for (const auto& shape : kPalette[below(kPalette.size())]) {
          if (below(6) == 0) continue;
          result.polygons.push_back({{origin.i + i, origin.j + j}, static_cast<Block>(below(blocks)), {}});
          result.polygons.back().vertices = transformed(shape, symmetry);
        }
      }
    }
    return result;
  }

  PreservePairs anyRelation(Block blocks) {
    PreservePairs result;
    for (Block a = 0; a < blocks; ++a) {
      for (Block b = a; b < blocks; ++b) {
        if (below(3) == 0) result.add(a, b);
      }
    }
    return result;
  }

  std::uint64_t below(std::uint64_t limit) { return random_.below(limit); }

 private:
  static std::vector<LocalPoint> transformed(std::vector<LocalPoint> shape, std::uint64_t symmetry) {
    for (LocalPoint& p : shape) {
      if (symmetry & 1) p.x = kFull - p.x;
      if (symmetry & 2) p.y = kFull - p.y;
      if (symmetry & 4) std::swap(p.x, p.y);
    }
    const bool mirrored = ((symmetry ^ symmetry >> 1 ^ symmetry >> 2) & 1) != 0;
    if (mirrored) std::reverse(shape.begin(), shape.end());
    return shape;
  }

  Random random_;
};

constexpr std::array kOrigins = {Cell{0, 0}, Cell{-2, -3}, Cell{kMaxCell - 6, -kMaxCell},
                                 Cell{-kMaxCell, kMaxCell - 6}};

Trace traceOf(const Scene& scene) {
  Trace trace{scene.preserve, {}};
  for (const ScenePolygon& polygon : scene.polygons)
    trace.edits.push_back(Edit::add(fmt::format("p{}", trace.edits.size() + 1), polygon));
  trace.edits.push_back(Edit::commit());
  return trace;
}

/// What the adds of a trace amount to, in their order; there are no removals in these.
Scene sceneOf(const Trace& trace) {
  Scene scene;
  scene.preserve = trace.preserve;
  for (const Edit& edit : trace.edits)
    if (edit.kind == Edit::Kind::add) scene.polygons.push_back(edit.polygon);
  return scene;
}

using Complaint = std::function<std::optional<std::string>(const Scene&, NaiveReference&)>;

/// Fails the current test with the first of `count` random scenes that there is a complaint about, made small. They share
/// one reference, which keeps its buffers from one to the next.
void forScenes(const std::string& name, std::uint64_t count, const std::function<Scene(RandomScenes)>& scene,
               const Complaint& complaint) {
  NaiveReference naive;
  const auto failure = test::firstFailure(
      {.name = name,
       .count = count,
       .trace = [&](std::uint64_t k) { return traceOf(scene(RandomScenes(k))); },
       .complaint = [&](const Trace& trace, std::uint64_t) { return complaint(sceneOf(trace), naive); },
       .mayBe = [](const Trace& trace) { return withoutRefused(trace).edits.size() == trace.edits.size(); }});
  if (failure) FAIL() << failure->text << "\nagain      " << test::again("lgs_tests");
}

/// Of the two references; none where both say that the relation makes no materials.
std::optional<std::string> disagreement(const Scene& scene, const OwnedOutline& naive,
                                        const std::optional<CgalUnion>& united) {
  if (united.has_value() != materials(scene).has_value())
    return "CGAL unites where there are no materials, or the reverse";
  if (!united) return std::nullopt;
  const OwnedOutline expected{withUnknownLinksOf(naive.outline, united->outline, united->known), united->owner};
  const auto differences = compare(expected, naive);
  if (differences.empty()) return std::nullopt;
  return "the naive reference differs from CGAL:\n" + describe(differences);
}

TEST(NaiveAgainstCgal, OneMaterial) {
  const auto scene = [](RandomScenes random) {
    const auto side = static_cast<std::int32_t>(1 + random.below(6));
    const Cell origin = kOrigins[random.below(kOrigins.size())];
    return random.scene(side, origin, 4);
  };
  forScenes("naive-one-material", 1500, scene, [](const Scene& s, NaiveReference& naive) -> std::optional<std::string> {
    const OwnedOutline& outline = naive(s);
    const auto united = cgalUnion(s);
    if (auto problem = disagreement(s, outline, united)) return problem;
    const auto loops = followLinks(outline.outline);
    if (!loops) return "links are not mutual";
    if (canonical(*loops) != canonical(united->loops)) return "other loops than CGAL's";
    return std::nullopt;
  });
}

TEST(NaiveAgainstCgal, TenThousandCells) {
  const auto scene = [](RandomScenes random) { return random.scene(100, {-50, -50}, 2); };
  EXPECT_GT(scene(RandomScenes(0)).polygons.size(), 10'000U);
  forScenes("naive-ten-thousand-cells", 1, scene,
            [](const Scene& s, NaiveReference& naive) { return disagreement(s, naive(s), cgalUnion(s)); });
}

TEST(NaiveAgainstCgal, SeveralMaterials) {
  const auto scene = [](RandomScenes random) {
    const auto side = static_cast<std::int32_t>(1 + random.below(4));
    const Cell origin = kOrigins[random.below(kOrigins.size())];
    Scene result = random.scene(side, origin, 5);
    for (const auto& [a, b] : {std::pair<Block, Block>{0, 1}, {0, 3}, {2, 1}, {2, 3}, {4, 0}, {4, 1}, {4, 2}, {4, 3}}) {
      result.preserve.add(a, b);  // materials {0, 2}, {1, 3} and {4}
    }
    return result;
  };
  struct Seen {
    int united = 0;
    std::int64_t known = 0;
  };
  const Shared<Seen> seen;
  forScenes("naive-several-materials", 1000, scene, [&](const Scene& s, NaiveReference& naive) {
    const auto united = cgalUnion(s);
    if (united) {
      ++seen->united;
      seen->known += std::count(united->known.begin(), united->known.end(), KnownLinks{});
    }
    return disagreement(s, naive(s), united);
  });
  if (HasFailure()) return;
  EXPECT_EQ(seen->united, 1000);
  EXPECT_GT(seen->known, 2000);
}

TEST(NaiveAgainstCgal, AnyRelationThatHappensToPartition) {
  const auto scene = [](RandomScenes random) {
    Scene result = random.scene(2, {0, 0}, 4);
    result.preserve = random.anyRelation(4);
    return result;
  };
  const Shared<int> compared;
  forScenes("naive-any-relation", 1500, scene, [&](const Scene& s, NaiveReference& naive) {
    const auto united = cgalUnion(s);
    *compared += united ? 1 : 0;
    return disagreement(s, naive(s), united);
  });
  if (HasFailure()) return;
  EXPECT_GT(*compared, 100);
}

TEST(NaiveAgainstCgal, TheOrderOfPolygonsDoesNotMatter) {
  const auto scene = [](RandomScenes random) {
    Scene result = random.scene(4, {-1, -1}, 3);
    result.preserve = random.anyRelation(3);
    return result;
  };
  forScenes("naive-order", 50, scene, [](Scene s, NaiveReference& naive) -> std::optional<std::string> {
    const Outline outline = naive(s).outline;
    std::reverse(s.polygons.begin(), s.polygons.end());
    const auto differences = compare(outline, naive(s).outline);
    if (differences.empty()) return std::nullopt;
    return "the outline depends on the order of the polygons:\n" + describe(differences);
  });
}

}  // namespace
}  // namespace lgs::oracle
