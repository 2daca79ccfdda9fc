// What marks take: of each cell that was edited, what it held at the mark, however often it was edited since.
#include "oracle/calls/random.h"
#include "proptests/support/worlds.h"

#include <lgs/brush.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

namespace lgs::test {
namespace {

using oracle::Random;

/// Full blocks, in which a tunnel is dug for each mark. A second world does the same without marks.
class Digging {
 public:
  Digging(double radius, bool commitsEachCircle) : radius_(radius), commitsEachCircle_(commitsEachCircle) {
    for (World* world : {&marked, &plain_}) {
      EXPECT_TRUE(world->fill({{0, 0}, {119, 67}}, shapeOf(*world, {unitSquare()}), 1));
      world->commit();
    }
  }

  /// Of many circles, with a mark before it or without one.
  void stroke(bool isMarked = true) {
    if (isMarked) marks.push_back(marked.mark());
    DoublePoint at{1.0 * random_.between(10, 110), 1.0 * random_.between(10, 58)};
    const DoublePoint step{random_.between(-100, 100) / 250.0, random_.between(-100, 100) / 250.0};
    const bool paints = random_.chance(33);
    for (int k = 0; k < kCircles; ++k) {
      circle(at, paints);
      if (commitsEachCircle_ || k + 1 == kCircles) {
        const Changes& changes = marked.commit();
        edited += static_cast<std::int64_t>(28 * (changes.removed.size() + changes.relinked.size()));
        plain_.commit();
      }
      at = {at.x + step.x, at.y + step.y};
    }
  }

  std::int64_t bytesOfMarks() const {
    return static_cast<std::int64_t>(marked.stats().bytes) - static_cast<std::int64_t>(plain_.stats().bytes);
  }

  World marked;
  std::vector<Mark> marks;
  /// Bytes: what the edits need. The polygons that their cells held before, at 8 bytes a vertex, in lists of 8 and 8 a
  /// polygon, and the segments that went or were linked anew, at 28.
  std::int64_t edited = 0;

 private:
  static constexpr int kCircles = 20;

  void circle(DoublePoint at, bool paints) {
    const Region region = lgs::circle(latticePoint(at), static_cast<std::int64_t>(radius_ * kUnitsPerCell), 24);
    std::map<Cell, std::vector<PlacedPolygon>> before;
    const std::vector<Cell> cells = lgs::cellsOf(region).value();
    for (const Cell cell : cells) before[cell] = marked.polygons(cell);
    std::map<Cell, std::int64_t> bytes;
    for (const auto& [cell, polygons] : before) {
      if (polygons.size() > 1) bytes[cell] = static_cast<std::int64_t>(8 + 8 * polygons.size());
      for (const PlacedPolygon& p : polygons) bytes[cell] += static_cast<std::int64_t>(8 * p.vertices.size());
    }
    for (World* world : {&marked, &plain_})
      EXPECT_TRUE(paints ? paint(*world, region, 2, PaintMode::replace) : carve(*world, region));
    for (const auto& [cell, polygons] : before) {
      const std::vector<PlacedPolygon> now = marked.polygons(cell);
      const auto handle = [](const PlacedPolygon& p) { return p.handle; };
      if (!std::ranges::equal(polygons, now, {}, handle, handle)) edited += bytes[cell];
    }
  }

  double radius_;
  bool commitsEachCircle_;
  World plain_;
  Random random_{7};
};

TEST(BrushMarks, TakeLittleMoreThanTwiceWhatTheEditsNeed) {
  for (const double radius : {0.6, 1.5}) {
    for (const bool commitsEachCircle : {false, true}) {
      Digging world(radius, commitsEachCircle);
      for (int k = 0; k < 400; ++k) world.stroke();
      EXPECT_LE(4 * world.bytesOfMarks(), 9 * world.edited) << "radius " << radius;
      std::printf("radius %.1f, a commit for each %s: marks take %.2f MB, the edits need %.2f MB\n", radius,
                  commitsEachCircle ? "circle" : "stroke", static_cast<double>(world.bytesOfMarks()) / 1e6,
                  static_cast<double>(world.edited) / 1e6);
    }
  }
}

// However long a game goes on with one mark.
TEST(BrushMarks, OneMarkTakesNoMoreThanTheWorldDidThen) {
  Digging world(1.5, true);
  world.stroke();
  for (int k = 0; k < 150; ++k) world.stroke(false);
  const std::int64_t bytes = world.bytesOfMarks();
  for (int k = 0; k < 150; ++k) world.stroke(false);
  EXPECT_LT(world.bytesOfMarks(), 2 * bytes);
  ASSERT_TRUE(world.marked.rollBack(world.marks.front()));
  EXPECT_EQ(world.marked.stats().segments, 2U * (120 + 68));
}

}  // namespace
}  // namespace lgs::test
