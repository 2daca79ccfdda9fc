// The naive reference and CGAL's union against each other, on random degenerate scenes.
#include "oracle/cgal/cgal_union.h"
#include "oracle/reference/compare.h"
#include "oracle/reference/naive.h"
#include "oracle/reference/scene.h"
#include "outlines_by_hand.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
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

  std::uint64_t below(std::uint64_t limit) { return random_() % limit; }

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

  std::mt19937_64 random_;  // its numbers are the same everywhere; those of the standard's distributions are not
};

constexpr std::array kOrigins = {Cell{0, 0}, Cell{-2, -3}, Cell{kMaxCell - 6, -kMaxCell},
                                 Cell{-kMaxCell, kMaxCell - 6}};

void expectAgreement(const OwnedOutline& naive, const CgalUnion& united) {
  OwnedOutline expected = united;
  expected.outline = withUnknownLinksOf(naive.outline, united.outline, united.known);
  ASSERT_EQ(describe(compare(expected, naive)), "");
}

TEST(NaiveAgainstCgal, OneMaterial) {
  RandomScenes random(1);
  NaiveReference naive;
  for (int round = 0; round < 1500; ++round) {
    SCOPED_TRACE(round);
    const auto side = static_cast<std::int32_t>(1 + random.below(6));
    const Scene scene = random.scene(side, kOrigins[random.below(kOrigins.size())], 4);
    const OwnedOutline& outline = naive(scene);
    const auto united = cgalUnion(scene);
    ASSERT_TRUE(united);
    ASSERT_NO_FATAL_FAILURE(expectAgreement(outline, *united));
    const auto loops = followLinks(outline.outline);
    ASSERT_TRUE(loops) << "links are not mutual";
    ASSERT_EQ(canonical(*loops), canonical(united->loops));
  }
}

TEST(NaiveAgainstCgal, TenThousandCells) {
  const Scene scene = RandomScenes(5).scene(100, {-50, -50}, 2);
  ASSERT_GT(scene.polygons.size(), 10'000U);
  NaiveReference naive;
  const auto united = cgalUnion(scene);
  ASSERT_TRUE(united);
  ASSERT_NO_FATAL_FAILURE(expectAgreement(naive(scene), *united));
}

TEST(NaiveAgainstCgal, SeveralMaterials) {
  RandomScenes random(2);
  NaiveReference naive;
  int known = 0;
  for (int round = 0; round < 1000; ++round) {
    SCOPED_TRACE(round);
    const auto side = static_cast<std::int32_t>(1 + random.below(4));
    Scene scene = random.scene(side, kOrigins[random.below(kOrigins.size())], 5);
    for (const auto& [a, b] : {std::pair<Block, Block>{0, 1}, {0, 3}, {2, 1}, {2, 3}, {4, 0}, {4, 1}, {4, 2}, {4, 3}}) {
      scene.preserve.add(a, b);  // materials {0, 2}, {1, 3} and {4}
    }
    const auto united = cgalUnion(scene);
    ASSERT_TRUE(united);
    known += static_cast<int>(std::count(united->known.begin(), united->known.end(), KnownLinks{}));
    ASSERT_NO_FATAL_FAILURE(expectAgreement(naive(scene), *united));
  }
  EXPECT_GT(known, 2000);
}

TEST(NaiveAgainstCgal, AnyRelationThatHappensToPartition) {
  RandomScenes random(3);
  NaiveReference naive;
  int compared = 0;
  for (int round = 0; round < 1500; ++round) {
    SCOPED_TRACE(round);
    Scene scene = random.scene(2, {0, 0}, 4);
    scene.preserve = random.anyRelation(4);
    const auto united = cgalUnion(scene);
    ASSERT_EQ(united.has_value(), materials(scene).has_value());
    if (!united) continue;
    ++compared;
    ASSERT_NO_FATAL_FAILURE(expectAgreement(naive(scene), *united));
  }
  EXPECT_GT(compared, 100);
}

TEST(NaiveAgainstCgal, TheOrderOfPolygonsDoesNotMatter) {
  RandomScenes random(4);
  for (int round = 0; round < 50; ++round) {
    Scene scene = random.scene(4, {-1, -1}, 3);
    scene.preserve = random.anyRelation(3);
    const Outline outline = naiveOutline(scene);
    std::reverse(scene.polygons.begin(), scene.polygons.end());
    ASSERT_EQ(differences(outline, naiveOutline(scene)), "");
  }
}

}  // namespace
}  // namespace lgs::oracle
