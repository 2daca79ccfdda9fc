// Law 7, what is refused: validation by itself, exhausted on tiny lattices. Every sequence of two to five points
// against slow rules that can be seen to be right.
#include "ground/polygon.h"
#include "oracle/reference/vector.h"
#include "proptests/support/exhaust.h"
#include "proptests/support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bitset>
#include <memory>
#include <optional>

namespace lgs::test {
namespace {

using detail::findDefect;
using detail::interiorsMeet;
using oracle::LocalPolygon;
using oracle::Vector;

/// Any sequence of points of a lattice of side × side points.
LocalPolygon anySequence(Exhaust& all, int length, int side) {
  LocalPolygon polygon;
  const std::int32_t step = kUnitsPerCell / (side - 1);
  for (int k = 0; k < length; ++k) {
    const std::int32_t x = all.below(side) * step;
    polygon.push_back({x, all.below(side) * step});
  }
  return polygon;
}

struct Exhausted {
  int length, side;
  std::int64_t total;
  std::int64_t good;  ///< in any of their rotations
};

// The second opinion is the harness's own code.
TEST(FindDefect, GivesTheRightReasonForEverySequence) {
  for (const Exhausted& e : {Exhausted{2, 3, 81, 0},
                             {3, 3, 729, 228},
                             {4, 3, 6'561, 568},
                             {5, 3, 59'049, 1'200},
                             {3, 4, 4'096, 1'548},
                             {4, 4, 65'536, 9'160},
                             {4, 5, 390'625, 67'144}}) {
    std::int64_t tried = 0, good = 0;
    Exhaust all;
    while (all.next()) {
      const LocalPolygon polygon = anySequence(all, e.length, e.side);
      if (all.isLeftOut()) continue;
      ++tried;
      const auto defect = findDefect(polygon);
      const auto fault = oracle::faultOf(polygon);
      ASSERT_EQ(defect ? std::optional(defect->code) : std::nullopt, fault) << rc::toString(AnyPolygon{polygon});
      good += !defect;
    }
    EXPECT_EQ(tried, exhausted(e.total));
    if (exhaustStride() == 1) {
      EXPECT_EQ(good, e.good) << e.length << " points of " << e.side << "×" << e.side;
    }
  }
}

/// Whether the vertices that a defect names are to blame for it.
void expectBlame(const LocalPolygon& polygon, const detail::Defect& defect) {
  const auto a = static_cast<std::size_t>(defect.vertex), b = static_cast<std::size_t>(defect.vertex2);
  if (defect.code == ErrorCode::repeatedVertex) {
    const auto firstLike = [&](std::size_t k) {
      return static_cast<std::size_t>(std::find(polygon.begin(), polygon.end(), polygon[k]) - polygon.begin());
    };
    std::size_t repeats = 1;
    while (firstLike(repeats) == repeats) ++repeats;
    EXPECT_EQ(b, repeats);
    EXPECT_EQ(a, firstLike(repeats));
  } else if (defect.code == ErrorCode::selfIntersecting) {
    EXPECT_TRUE(std::max(a, b) < polygon.size() && oracle::edgesMeet(polygon, a, b));
  } else {
    EXPECT_EQ(defect.vertex, -1);
    EXPECT_EQ(defect.vertex2, -1);
  }
}

TEST(FindDefect, NamesVerticesThatAreToBlame) {
  for (const int length : {3, 4, 5}) {
    Exhaust all;
    while (all.next()) {
      const LocalPolygon polygon = anySequence(all, length, 3);
      if (all.isLeftOut()) continue;
      if (const auto defect = findDefect(polygon)) expectBlame(polygon, *defect);
    }
  }
}

// --- Two polygons ----------------------------------------------------------------------------------------------------

// Points that lie on no line through two lattice points, so dense that every face of the arrangement of all those lines
// holds one: two interiors meet exactly if they have such a point in common.
constexpr int kSamples = 160;  // each way
using Inside = std::bitset<static_cast<std::size_t>(kSamples) * kSamples>;

/// The samples inside, by the crossing rule, in units of 1 / (2 · 1021) of a cell.
Inside samplesInside(const LocalPolygon& polygon) {
  constexpr std::int64_t kSteps = 1021;  // a prime number, so that no sample is on a line of small slope
  std::array<Vector, 5> corners{};
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    corners[k] = {2 * kSteps * polygon[k].x / kUnitsPerCell, 2 * kSteps * polygon[k].y / kUnitsPerCell};
  }
  Inside inside;
  bool onALine = false;
  for (std::size_t sample = 0; sample < inside.size(); ++sample) {
    const auto x = static_cast<std::int64_t>(sample % kSamples), y = static_cast<std::int64_t>(sample / kSamples);
    const std::int64_t sx = 2 * (kSteps * x / kSamples) + 3, sy = 2 * (kSteps * y / kSamples) + 5;
    bool odd = false;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Vector a = corners[k], b = corners[k + 1 == polygon.size() ? 0 : k + 1];
      if ((a.y > sy) == (b.y > sy)) continue;
      const std::int64_t turn = (b.x - a.x) * (sy - a.y) - (b.y - a.y) * (sx - a.x);
      onALine |= turn == 0;
      odd ^= (turn > 0) == (b.y > a.y);
    }
    inside[sample] = odd;
  }
  EXPECT_FALSE(onALine);
  return inside;
}

/// All good polygons of up to five vertices on a 3×3 lattice, each once: with its least vertex first.
std::vector<LocalPolygon> goodPolygons() {
  std::vector<LocalPolygon> polygons;
  for (const int length : {3, 4, 5}) {
    Exhaust all;
    while (all.next()) {
      LocalPolygon p = anySequence(all, length, 3);
      if (*std::min_element(p.begin(), p.end()) == p[0] && !oracle::faultOf(p)) polygons.push_back(std::move(p));
    }
  }
  return polygons;
}

TEST(InteriorsMeet, IsRightForAllPairs) {
  const std::vector<LocalPolygon> polygons = goodPolygons();
  ASSERT_EQ(polygons.size(), 458U);
  const auto inside = std::make_unique<Inside[]>(polygons.size());
  for (std::size_t k = 0; k < polygons.size(); ++k) inside[k] = samplesInside(polygons[k]);
  std::int64_t tried = 0, meeting = 0;
  Exhaust all;
  while (all.next()) {
    const std::size_t a = all.below(polygons.size()), b = all.below(polygons.size());
    if (all.isLeftOut()) continue;
    ++tried;
    const bool meet = interiorsMeet(polygons[a], polygons[b]);
    meeting += meet;
    ASSERT_EQ(meet, (inside[a] & inside[b]).any()) << "polygons " << a << " and " << b;
    ASSERT_EQ(meet, oracle::overlap(polygons[a], polygons[b]));
  }
  EXPECT_EQ(tried, exhausted(458 * 458));
  if (exhaustStride() == 1) {
    EXPECT_EQ(meeting, 194'168);
  }
}

}  // namespace
}  // namespace lgs::test
