// The references themselves: the naive one and CGAL's union against outlines worked out by hand. Everything else in the
// project is tested against these two.
#include "oracle/cgal/cgal_union.h"
#include "oracle/reference/canonical.h"
#include "oracle/reference/compare.h"
#include "oracle/reference/naive.h"
#include "oracle/reference/scene.h"
#include "outlines_by_hand.h"
#include "proptests/support/must.h"

#include <gtest/gtest.h>

namespace lgs::oracle {
namespace {

// Both references give the chains, with every link known, and CGAL's boundary cycles are those that the links make.
void expectChains(const Scene& scene, const std::vector<Outline>& chains) {
  const Outline expected = together(chains);
  EXPECT_EQ(differences(expected, naiveOutline(scene)), "") << "naive";
  const auto united = test::must(cgalUnion(scene));
  EXPECT_EQ(differences(expected, united.outline), "") << "CGAL";
  EXPECT_TRUE(std::all_of(united.known.begin(), united.known.end(), [](KnownLinks k) { return k == KnownLinks{}; }));
  const auto followed = test::must(followLinks(expected));
  EXPECT_EQ(canonical(followed), canonical(united.loops));
}

const OutlineSegment& segment(const Outline& outline, At start, At end) {
  static const OutlineSegment kNone;
  for (const OutlineSegment& s : outline) {
    if (s.start == point(start) && s.end == point(end)) return s;
  }
  ADD_FAILURE() << "no such segment";
  return kNone;
}

// --- By hand, empty preserve relation --------------------------------------------------------------------------------

TEST(Reference, EmptyScene) { expectChains({}, {}); }

TEST(Reference, SingleSquare) {
  expectChains({{square({0, 0}, 7)}, {}}, {chain({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {7})});
}

TEST(Reference, NegativeCells) {
  expectChains({{square({-2, -3})}, {}}, {chain({{-2, -3}, {-1, -3}, {-1, -2}, {-2, -2}})});
}

TEST(Reference, TwoSquaresLoseTheirCommonSideAndKeepItsEnds) {
  expectChains({{square({0, 0}, 1), square({1, 0}, 2)}, {}},
               {chain({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}}, {1, 2, 2, 2, 1, 1})});
}

TEST(Reference, HalfOfASideIsCancelled) {
  expectChains({{square({0, 0}), polygon({1, 0}, 5, {{0, 0.5}, {1, 0.5}, {1, 1}, {0, 1}})}, {}},
               {chain({{0, 0}, {1, 0}, {1, 0.5}, {2, 0.5}, {2, 1}, {1, 1}, {0, 1}}, {0, 0, 5, 5, 5, 0, 0})});
}

// Article, section 3.2, case A: seg1 (0,0)→(0,1) comes from seg2 (1,0)→(0,0), 90° clockwise, not from seg3, 315°.
TEST(Reference, ArticleWorkedExampleCaseA) {
  const Scene scene{{polygon({-1, 0}, 0, {{1, 0}, {1, 1}, {0, 1}}), square({0, -1})}, {}};
  const Outline outline = naiveOutline(scene);
  EXPECT_EQ(segment(outline, {0, 0}, {0, 1}).ghost1, point({1, 0}));
  EXPECT_EQ(segment(outline, {-1, 1}, {0, 0}).ghost2, point({0, -1}));
  expectChains(scene, {chain({{0, 0}, {0, 1}, {-1, 1}, {0, 0}, {0, -1}, {1, -1}, {1, 0}})});
}

// Case B: seg1 (0,1)→(0,0) goes on to seg3 (0,0)→(-1,1), 45° counter-clockwise, not to seg2 (0,0)→(1,0), 270°.
TEST(Reference, ArticleWorkedExampleCaseB) {
  const Scene scene{{polygon({-1, 0}, 0, {{1, 0}, {0, 1}, {0, 0}}), square({0, 0})}, {}};
  const Outline outline = naiveOutline(scene);
  EXPECT_EQ(segment(outline, {0, 1}, {0, 0}).ghost2, point({-1, 1}));
  expectChains(scene, {chain({{0, 1}, {0, 0}, {-1, 1}, {-1, 0}, {0, 0}, {1, 0}, {1, 1}})});
}

TEST(Reference, TouchingCornersChainThroughTheFreeWedges) {
  expectChains({{square({0, 0}), square({1, 1})}, {}},
               {chain({{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}, {0, 1}})});
}

TEST(Reference, FourSolidsAtACorner) {
  // One triangle in each of four cells, each with its tip at (0, 0) and free wedges between them: four chains would go
  // around the solids; through the free wedges it is one.
  const Scene scene{
      {polygon({0, 0}, 1, {{0, 0}, {1, 0.25}, {0.25, 1}}), polygon({-1, 0}, 2, {{1, 0}, {0.75, 1}, {0, 0.25}}),
       polygon({-1, -1}, 3, {{1, 1}, {0, 0.75}, {0.75, 0}}), polygon({0, -1}, 4, {{0, 1}, {0.25, 0}, {1, 0.75}})},
      {}};
  expectChains(scene, {chain({{0, 0},
                              {1, 0.25},
                              {0.25, 1},  //
                              {0, 0},
                              {-0.25, 1},
                              {-1, 0.25},  //
                              {0, 0},
                              {-1, -0.25},
                              {-0.25, -1},  //
                              {0, 0},
                              {0.25, -1},
                              {1, -0.25}},
                             {1, 1, 1, 2, 2, 2, 3, 3, 3, 4})});
}

TEST(Reference, FourSquaresAtACornerLeaveNothingThere) {
  expectChains({{square({0, 0}), square({-1, 0}), square({-1, -1}), square({0, -1})}, {}},
               {chain({{0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}, {1, 1}})});
}

TEST(Reference, HoleAndIsland) {
  Scene scene;
  for (const auto& [i, j] : {std::pair{0, 0}, {1, 0}, {2, 0}, {0, 1}, {2, 1}, {0, 2}, {1, 2}, {2, 2}}) {
    scene.polygons.push_back(square({i, j}));
  }
  scene.polygons.push_back(polygon({1, 1}, 9, {{0.25, 0.25}, {0.75, 0.25}, {0.75, 0.75}, {0.25, 0.75}}));
  expectChains(
      scene,
      {chain({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 2}, {3, 3}, {2, 3}, {1, 3}, {0, 3}, {0, 2}, {0, 1}}),
       chain({{1, 1}, {1, 2}, {2, 2}, {2, 1}}), chain({{1.25, 1.25}, {1.75, 1.25}, {1.75, 1.75}, {1.25, 1.75}}, {9})});
}

TEST(Reference, TwoTrianglesShareADiagonal) {
  expectChains({{polygon({0, 0}, 1, {{0, 0}, {1, 0}, {1, 1}}), polygon({0, 0}, 2, {{0, 0}, {1, 1}, {0, 1}})}, {}},
               {chain({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {1, 1, 2})});
}

TEST(Reference, SlantedEdgeIsSharedInPart) {
  // The second triangle covers the lower half of the first one's diagonal: a T-contact at its middle.
  expectChains({{polygon({0, 0}, 1, {{0, 0}, {1, 0}, {1, 1}}), polygon({0, 0}, 2, {{0, 0}, {0.5, 0.5}, {0, 1}})}, {}},
               {chain({{0, 0}, {1, 0}, {1, 1}, {0.5, 0.5}, {0, 1}}, {1, 1, 1, 2})});
}

TEST(Reference, CornerTouchesAWallInMidEdge) {
  // The square's right side is cut where the diamond's left tip ends on it, and the chain turns there.
  expectChains({{square({0, 0}, 1), polygon({1, 0}, 2, {{0, 0.5}, {0.5, 0}, {1, 0.5}, {0.5, 1}})}, {}},
               {chain({{0, 0}, {1, 0}, {1, 0.5}, {1.5, 0}, {2, 0.5}, {1.5, 1}, {1, 0.5}, {1, 1}, {0, 1}},
                      {1, 1, 2, 2, 2, 2, 1})});
}

TEST(Reference, VertexOnAnEdgeInsideACellCutsIt) {
  // The small triangle's tip touches the big one's diagonal from the free side.
  expectChains(
      {{polygon({0, 0}, 1, {{0, 0}, {1, 0}, {1, 1}}), polygon({0, 0}, 2, {{0.25, 0.25}, {0.25, 1}, {0, 1}})}, {}},
      {chain({{0, 0}, {1, 0}, {1, 1}, {0.25, 0.25}, {0.25, 1}, {0, 1}, {0.25, 0.25}}, {1, 1, 1, 2, 2, 2, 1})});
}

TEST(Reference, CollinearVerticesOfTheInputStay) {
  expectChains({{polygon({0, 0}, 0, {{0, 0}, {0.5, 0}, {1, 0}, {1, 1}, {0, 1}})}, {}},
               {chain({{0, 0}, {0.5, 0}, {1, 0}, {1, 1}, {0, 1}})});
}

TEST(Reference, VerticesAUnitApart) {
  const double unit = 1. / kUnitsPerCell;
  expectChains({{polygon({0, 0}, 0, {{0, 0}, {unit, 0}, {2 * unit, 0}, {1, 0}, {1, 1}, {0, 1}})}, {}},
               {chain({{0, 0}, {unit, 0}, {2 * unit, 0}, {1, 0}, {1, 1}, {0, 1}})});
}

TEST(Reference, FarCells) {
  const auto expectSquareAt = [](Cell cell) {
    const double i = cell.i;
    const double j = cell.j;
    expectChains({{square(cell)}, {}}, {chain({{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}})});
  };
  for (const std::int32_t i : {-kMaxCell, kMaxCell}) {
    for (const std::int32_t j : {-kMaxCell, kMaxCell}) expectSquareAt({i, j});
  }
  const double far = kMaxCell;  // both ends of the world in one scene
  expectChains({{square({-kMaxCell, -kMaxCell}), square({kMaxCell, kMaxCell})}, {}},
               {chain({{-far, -far}, {1 - far, -far}, {1 - far, 1 - far}, {-far, 1 - far}}),
                chain({{far, far}, {far + 1, far}, {far + 1, far + 1}, {far, far + 1}})});
}

TEST(Reference, CgalSeesThatPolygonsCross) {
  const Scene scene{{polygon({0, 0}, 0, {{0, 0}, {1, 0}, {0, 1}}), polygon({0, 0}, 0, {{0.25, 0}, {1, 0.5}, {0, 0.5}})},
                    {}};
  EXPECT_THROW(cgalUnion(scene), std::invalid_argument);
}

// --- By hand, with a preserve relation -------------------------------------------------------------------------------

PreservePairs preserving(std::initializer_list<std::pair<Block, Block>> pairs) {
  PreservePairs result;
  for (const auto& [a, b] : pairs) result.add(a, b);
  return result;
}

TEST(Preserve, FloorOfTwoMaterialsIsSmoothAndKeepsBothWalls) {
  const Scene scene{{square({0, 0}, 1), square({1, 0}, 2)}, preserving({{1, 2}})};
  const Outline outline = naiveOutline(scene);
  ASSERT_EQ(outline.size(), 8U);
  // Along the top the chain goes straight on, from the one material to the other.
  EXPECT_EQ(segment(outline, {2, 1}, {1, 1}).ghost2, point({0, 1}));
  EXPECT_EQ(segment(outline, {1, 1}, {0, 1}).ghost1, point({2, 1}));
  // The wall's own opposite is coincident and so is skipped.
  EXPECT_EQ(segment(outline, {1, 0}, {1, 1}).ghost1, point({0, 0}));
  EXPECT_EQ(segment(outline, {1, 0}, {1, 1}).ghost2, point({0, 1}));
  EXPECT_EQ(segment(outline, {1, 1}, {1, 0}).ghost1, point({2, 1}));
  EXPECT_EQ(segment(outline, {1, 1}, {1, 0}).ghost2, point({2, 0}));

  // CGAL, a union for each material, agrees on the segments, and knows the links where only one material is.
  const auto united = test::must(cgalUnion(scene));
  for (std::size_t k = 0; k < united.outline.size(); ++k) {
    EXPECT_EQ(united.known[k].ghost1, united.outline[k].start.x != kUnitsPerCell);
    EXPECT_EQ(united.known[k].ghost2, united.outline[k].end.x != kUnitsPerCell);
  }
  EXPECT_NE(differences(united.outline, outline), "");
  EXPECT_EQ(differences(withUnknownLinksOf(outline, united.outline, united.known), outline), "");
}

TEST(Preserve, OverlapWithNothingElseHasNoLinks) {
  // A vertex where only a wall and its coincident opposite end: no candidate, no link.
  PreservePairs preserve = preserving({{1, 2}});
  const Scene scene{{square({0, 0}, 1), polygon({1, 0}, 2, {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0.5}}),
                     square({0, 1}, 3), square({1, 1}, 3)},
                    preserve};
  const Outline outline = naiveOutline(scene);
  const OutlineSegment& wall = segment(outline, {1, 0.5}, {1, 1});
  EXPECT_EQ(wall.ghost1, point({1, 0}));
  EXPECT_EQ(wall.ghost2, std::nullopt);
  EXPECT_EQ(segment(outline, {1, 1}, {1, 0.5}).ghost1, std::nullopt);
  EXPECT_EQ(followLinks(outline), std::nullopt);
  EXPECT_FALSE(cgalUnion(scene)) << "3 joins 1 and 2, so there are no materials";
}

TEST(Preserve, EdgesAreCutAtVerticesOfOtherMaterials) {
  const Scene scene{{square({0, 0}, 1), polygon({1, 0}, 2, {{0, 0.5}, {0.5, 0}, {1, 0.5}, {0.5, 1}})},
                    preserving({{1, 2}})};
  const auto united = test::must(cgalUnion(scene));
  const Outline outline = naiveOutline(scene);
  EXPECT_EQ(outline.size(), 9U);
  EXPECT_EQ(differences(withUnknownLinksOf(outline, united.outline, united.known), outline), "");
}

TEST(Preserve, InsideACell) {
  const Scene scene{{polygon({0, 0}, 1, {{0, 0}, {1, 0}, {1, 1}}), polygon({0, 0}, 2, {{0, 0}, {1, 1}, {0, 1}})},
                    preserving({{2, 1}})};
  const Outline outline = naiveOutline(scene);
  EXPECT_EQ(outline.size(), 6U);
  EXPECT_EQ(segment(outline, {0, 0}, {1, 1}).block, 2U);
  EXPECT_EQ(segment(outline, {1, 1}, {0, 0}).block, 1U);
}

TEST(Preserve, MaterialsAreFoundOrRefused) {
  const auto scene = [](std::initializer_list<Block> blocks, std::initializer_list<std::pair<Block, Block>> pairs) {
    Scene result{{}, preserving(pairs)};
    for (const Block block : blocks) result.polygons.push_back(square({0, 0}, block));
    return result;
  };
  EXPECT_EQ(materials(scene({}, {}))->count, 0U);
  EXPECT_EQ(materials(scene({5, 9, 5}, {}))->count, 1U);
  EXPECT_EQ(materials(scene({1, 2}, {{1, 2}}))->count, 2U);
  EXPECT_EQ(materials(scene({1, 1}, {{1, 2}}))->count, 1U) << "2 is not in the scene";
  EXPECT_FALSE(materials(scene({1, 2, 3}, {{1, 2}}))) << "not transitive: 1 joins 3, 3 joins 2";
  EXPECT_FALSE(materials(scene({1, 2}, {{1, 1}}))) << "not reflexive";
  EXPECT_FALSE(materials(scene({1, 2, 3, 4}, {{1, 2}, {2, 3}, {3, 4}}))) << "3 and 4 both join 1, but not each other";
  const auto pairwise = test::must(materials(scene({1, 2, 3, 4}, {{1, 2}, {2, 3}, {3, 4}, {4, 1}})));
  EXPECT_EQ(pairwise.count, 2U);
  EXPECT_EQ(pairwise.of(1), pairwise.of(3));
  EXPECT_EQ(pairwise.of(2), pairwise.of(4));
  EXPECT_NE(pairwise.of(1), pairwise.of(2));
}

TEST(Preserve, PairsAreSymmetric) {
  PreservePairs pairs = preserving({{7, 2}, {2, 7}, {3, 3}});
  EXPECT_EQ(pairs.pairs().size(), 2U);
  EXPECT_TRUE(pairs(2, 7) && pairs(7, 2) && pairs(3, 3));
  EXPECT_FALSE(pairs(2, 3) || pairs(2, 2));
}

}  // namespace
}  // namespace lgs::oracle
