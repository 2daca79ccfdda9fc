// The references themselves: the naive one and CGAL's union against outlines worked out by hand, and against each other
// on random scenes. Everything else in the project is tested against these two.
#include "oracle/cgal/cgal_union.h"
#include "oracle/reference/canonical.h"
#include "oracle/reference/compare.h"
#include "oracle/reference/naive.h"
#include "oracle/reference/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace lgs::oracle {
namespace {

// --- Scenes and outlines in cells ------------------------------------------------------------------------------------

using At = std::pair<double, double>;

std::int64_t units(double inCells) { return std::llround(inCells * kUnitsPerCell); }
Point point(At p) { return {units(p.first), units(p.second)}; }

ScenePolygon polygon(Cell cell, Block block, std::initializer_list<At> vertices) {
  ScenePolygon result{cell, block, {}};
  for (const auto& [x, y] : vertices) {
    result.vertices.push_back({static_cast<std::int32_t>(units(x)), static_cast<std::int32_t>(units(y))});
  }
  return result;
}

ScenePolygon square(Cell cell, Block block = 0) { return polygon(cell, block, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}); }

// A closed chain: each segment linked to the one before and the one after it. `blocks` gives each segment's block, the
// last one also all that follow.
Outline chain(std::vector<At> vertices, std::vector<Block> blocks = {0}) {
  const std::size_t n = vertices.size();
  Outline result;
  for (std::size_t k = 0; k < n; ++k) {
    result.push_back({point(vertices[k]), point(vertices[(k + 1) % n]), blocks[std::min(k, blocks.size() - 1)],
                      point(vertices[(k + n - 1) % n]), point(vertices[(k + 2) % n])});
  }
  return result;
}

Outline together(std::vector<Outline> parts) {
  Outline result;
  for (const Outline& part : parts) result.insert(result.end(), part.begin(), part.end());
  std::sort(result.begin(), result.end());
  return result;
}

std::string differences(const Outline& expected, const Outline& actual) { return describe(compare(expected, actual)); }

// Both references give the chains, with every link known, and CGAL's boundary cycles are those that the links make.
void expectChains(const Scene& scene, std::vector<Outline> chains) {
  const Outline expected = together(std::move(chains));
  EXPECT_EQ(differences(expected, naiveOutline(scene)), "") << "naive";
  const auto united = cgalUnion(scene);
  ASSERT_TRUE(united);
  EXPECT_EQ(differences(expected, united->outline), "") << "CGAL";
  EXPECT_TRUE(std::all_of(united->known.begin(), united->known.end(), [](KnownLinks k) { return k == KnownLinks{}; }));
  const auto followed = followLinks(expected);
  ASSERT_TRUE(followed);
  EXPECT_EQ(canonical(*followed), canonical(united->loops));
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
  const auto united = cgalUnion(scene);
  ASSERT_TRUE(united);
  for (std::size_t k = 0; k < united->outline.size(); ++k) {
    EXPECT_EQ(united->known[k].ghost1, united->outline[k].start.x != kUnitsPerCell);
    EXPECT_EQ(united->known[k].ghost2, united->outline[k].end.x != kUnitsPerCell);
  }
  EXPECT_NE(differences(united->outline, outline), "");
  EXPECT_EQ(differences(withUnknownLinksOf(outline, united->outline, united->known), outline), "");
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
  const auto united = cgalUnion(scene);
  ASSERT_TRUE(united);
  const Outline outline = naiveOutline(scene);
  EXPECT_EQ(outline.size(), 9U);
  EXPECT_EQ(differences(withUnknownLinksOf(outline, united->outline, united->known), outline), "");
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
  const auto pairwise = materials(scene({1, 2, 3, 4}, {{1, 2}, {2, 3}, {3, 4}, {4, 1}}));
  ASSERT_TRUE(pairwise);
  EXPECT_EQ(pairwise->count, 2U);
  EXPECT_EQ(pairwise->of(1), pairwise->of(3));
  EXPECT_EQ(pairwise->of(2), pairwise->of(4));
  EXPECT_NE(pairwise->of(1), pairwise->of(2));
}

TEST(Preserve, PairsAreSymmetric) {
  PreservePairs pairs = preserving({{7, 2}, {2, 7}, {3, 3}});
  EXPECT_EQ(pairs.pairs().size(), 2U);
  EXPECT_TRUE(pairs(2, 7) && pairs(7, 2) && pairs(3, 3));
  EXPECT_FALSE(pairs(2, 3) || pairs(2, 2));
}

// --- Canonical form and comparison -----------------------------------------------------------------------------------

TEST(Canonical, DropsStraightVerticesOfDegreeTwoOnly) {
  const Loops loops{{{0, 0}, {10, 0}, {20, 0}, {20, 20}}, {{10, 0}, {15, -5}, {5, -5}}};
  const Loops expected{{{0, 0}, {10, 0}, {20, 0}, {20, 20}}, {{5, -5}, {10, 0}, {15, -5}}};
  EXPECT_EQ(canonical(loops), expected);
  EXPECT_EQ(canonical({loops[0]}), (Loops{{{0, 0}, {20, 0}, {20, 20}}}));
}

TEST(Canonical, LeastRotationWhereTheLeastVertexIsVisitedTwice) {
  const Loops expected{{{0, 0}, {1, 2}, {0, 2}, {0, 0}, {2, 0}, {2, 1}}};
  Loops rotated = expected;
  for (std::size_t k = 0; k < expected[0].size(); ++k) {
    EXPECT_EQ(canonical(rotated), expected) << k;
    std::rotate(rotated[0].begin(), rotated[0].begin() + 1, rotated[0].end());
  }
}

TEST(Canonical, FollowsOnlyMutualLinks) {
  const Outline outline = together({chain({{0, 0}, {1, 0}, {1, 1}, {0, 1}})});
  EXPECT_EQ(followLinks(outline), (Loops{{point({0, 0}), point({1, 0}), point({1, 1}), point({0, 1})}}));
  for (std::size_t k = 0; k < outline.size(); ++k) {
    for (const std::optional<Point> wrong : {std::optional<Point>(), std::optional(point({5, 5}))}) {
      Outline broken = outline;
      broken[k].ghost1 = wrong;
      EXPECT_EQ(followLinks(broken), std::nullopt);
      broken = outline;
      broken[k].ghost2 = wrong;
      EXPECT_EQ(followLinks(broken), std::nullopt);
    }
  }
}

TEST(Compare, SaysWhatDiffersAndWhere) {
  const Outline squareOutline = together({chain({{1, 0}, {2, 0}, {2, 1}, {1, 1}}, {7})});
  const auto changed = [&](auto change) {
    Outline outline = squareOutline;
    change(outline);
    std::sort(outline.begin(), outline.end());
    return outline;
  };
  EXPECT_EQ(differences(squareOutline, squareOutline), "");
  // In order: the bottom, the left side, the right side, the top.
  EXPECT_EQ(differences(squareOutline, changed([](Outline& o) { o.erase(o.begin()); })),
            "missing segment: (1, 0) → (2, 0), the bottom of cell (1, 0), block 7\n");
  EXPECT_EQ(differences(squareOutline, changed([](Outline& o) { o[3].block = 8; })),
            "wrong block: expected 7, got 8; segment (2, 1) → (1, 1), the top of cell (1, 0), block 7\n");
  EXPECT_EQ(differences(squareOutline, changed([](Outline& o) {
                          o[2].ghost1 = o[2].end;
                          o[2].ghost2.reset();
                        })),
            "wrong ghost1 at (2, 0): expected (1, 0), got (2, 1); segment (2, 0) → (2, 1), the right side of cell "
            "(1, 0), block 7: no segment of the outline leads there\n"
            "wrong ghost2 at (2, 1): expected (1, 1), got none; segment (2, 0) → (2, 1), the right side of cell "
            "(1, 0), block 7\n");
  EXPECT_EQ(differences(changed([](Outline& o) { o.erase(o.begin() + 1); }), squareOutline),
            "extra segment: (1, 1) → (1, 0), the left side of cell (1, 0), block 7\n");
  EXPECT_EQ(differences(squareOutline, changed([](Outline& o) { o.push_back(o[0]); })),
            "extra segment: (1, 0) → (2, 0), the bottom of cell (1, 0), block 7: it is there twice\n");
}

TEST(Compare, RecognisesOverlapsAndCuts) {
  const Outline outline = together({chain({{0, 0}, {1, 0}, {1, 1}, {0, 1}})});
  const Outline overlap = together(
      {outline,
       {{point({0.5, 0.25}), point({0.0625, 0.5}), 3, {}, {}}, {point({0.0625, 0.5}), point({0.5, 0.25}), 4, {}, {}}}});
  EXPECT_EQ(differences(outline, overlap),
            "extra segment: (0.0625, 0.5) → (0.5, 0.25), inside cell (0, 0), block 4: an overlap that should have been "
            "cancelled\n"
            "extra segment: (0.5, 0.25) → (0.0625, 0.5), inside cell (0, 0), block 3: an overlap that should have been "
            "cancelled\n");
  const Outline cut = together({chain({{0, 0}, {1. / 3, 0}, {1, 0}, {1, 1}, {0, 1}})});
  EXPECT_EQ(describe(compare(cut, outline), 1),
            "missing segment: (0, 0) → (0+21845/65536, 0), the bottom of cell (0, 0), block 0: not cut at "
            "(0+21845/65536, 0)\n... and 4 more\n");
  EXPECT_NE(differences(outline, cut).find("it should go on to (1, 0)"), std::string::npos);
}

TEST(Compare, Owners) {
  const OwnedOutline expected{chain({{-0.25, -1}, {0, -1}, {0, 0}}), {4, 4, 5}};
  OwnedOutline actual = expected;
  EXPECT_TRUE(compare(expected, actual).empty());
  actual.owner[1] = 6;
  EXPECT_EQ(
      describe(compare(expected, actual)),
      "wrong owner: segment (0, -1) → (0, 0), the right side of cell (-1, -1), block 0: expected polygon 4 of the "
      "scene, got 6\n");
}

// --- The two references against each other ---------------------------------------------------------------------------

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
