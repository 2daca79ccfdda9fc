// The canonical form of loops, and the comparison of outlines in words.
#include "oracle/reference/compare.h"
#include "oracle/reference/canonical.h"
#include "outlines_by_hand.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace lgs::oracle {
namespace {

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
    Outline broken = outline;
    --broken[k].ghost2->y;  // no segment leads there; the next one in order is the right one
    EXPECT_EQ(followLinks(broken), std::nullopt);
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

TEST(Compare, TellsMissingAndExtraSegmentsFirst) {
  const Outline expected = together({chain({{0, 0}, {1, 0}, {1, 1}, {0, 1}})});
  Outline actual = expected;
  actual[0].block = 9;
  actual.pop_back();
  actual.push_back({point({2, 0}), point({3, 0}), 0, {}, {}});
  using enum Difference::Kind;
  std::vector<Difference::Kind> kinds;
  for (const Difference& difference : compare(expected, actual)) kinds.push_back(difference.kind);
  EXPECT_EQ(kinds, (std::vector{missing, extra, block}));
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
            "missing segment: (0, 0) → (0+21845/65536, 0), the bottom of cell (0, 0): not cut at "
            "(0+21845/65536, 0)\n... and 4 more\n");
  EXPECT_NE(differences(outline, cut).find("it should go on to (1, 0)"), std::string::npos);
}

TEST(Compare, RecognisesWallsThatAreLostAndTurned) {
  const OutlineSegment up{point({0.5, 0.25}), point({0.5, 0.5}), 1, {}, {}}, down{up.end, up.start, 2, {}, {}};
  const auto notes = [](const Outline& expected, const Outline& actual) {
    std::vector<std::string> all;
    for (const Difference& difference : compare(expected, actual)) all.push_back(difference.note);
    return all;
  };
  using Notes = std::vector<std::string>;
  EXPECT_EQ(notes({up, down}, {up}), Notes{"an overlap to be preserved, of which only the other side is there"});
  EXPECT_EQ(notes({up, down}, {}), Notes(2, "an overlap to be preserved, cancelled"));
  EXPECT_EQ(notes({up}, {}), Notes{""});
  EXPECT_EQ(notes({}, {up}), Notes{""});
  EXPECT_EQ(notes({up}, {down}),
            (Notes{"it is there in the opposite direction", "only the opposite direction should be there"}));
  EXPECT_EQ(notes({}, {{up.start, up.start, 1, {}, {}}}), Notes{"it has no length"});
}

TEST(Compare, Owners) {
  const OwnedOutline expected{chain({{-0.25, -1}, {0, -1}, {0, 0}}), {4, 4, 5}};
  OwnedOutline actual = expected;
  EXPECT_TRUE(compare(expected, actual).empty());
  actual.owner[1] = 6;
  EXPECT_EQ(describe(compare(expected, actual)),
            "wrong owner: segment (0, -1) → (0, 0), the right side of cell (-1, -1): expected polygon 4 of the "
            "scene, got 6\n");
}

}  // namespace
}  // namespace lgs::oracle
