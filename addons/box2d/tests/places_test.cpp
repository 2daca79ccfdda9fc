// Where something changed: the places of boxes are those that a search from box to box finds.
#include "addons/box2d/src/places.h"
#include "oracle/calls/random.h"

#include <gtest/gtest.h>
#include <cmath>
#include <set>

namespace lgs::box2d_test {
namespace {

using box2d::Box;
using box2d::ChangedPlace;

constexpr double kCell = kUnitsPerCell;

bool areBeside(const Box& a, const Box& b) {
  const auto apart = [](double x, double y) { return std::abs(std::floor(x / kCell) - std::floor(y / kCell)); };
  return apart(a.min.x, b.min.x) <= 1 && apart(a.min.y, b.min.y) <= 1;
}

/// The indices of each place.
std::set<std::set<std::uint32_t>> searched(const std::vector<Box>& boxes) {
  std::set<std::set<std::uint32_t>> places;
  std::set<std::uint32_t> known;
  for (std::uint32_t k = 0; k < boxes.size(); ++k) {
    if (known.contains(k)) continue;
    std::vector<std::uint32_t> place{k};
    known.insert(k);
    for (std::size_t next = 0; next < place.size(); ++next) {
      for (std::uint32_t other = 0; other < boxes.size(); ++other)
        if (areBeside(boxes[place[next]], boxes[other]) && known.insert(other).second) place.push_back(other);
    }
    places.emplace(place.begin(), place.end());
  }
  return places;
}

TEST(Box2dChangedPlaces, AreThoseThatASearchFinds) {
  oracle::Random random(1);
  for (int times = 0; times < 2'000; ++times) {
    std::vector<Box> boxes(static_cast<std::size_t>(random.below(40)));
    const int side = 1 + random.below(16);
    for (Box& box : boxes) {
      const double x = (random.below(2 * side) - side) * kCell / 2, y = (random.below(2 * side) - side) * kCell / 2;
      box = {{x, y}, {x + random.below(3) * kCell / 2, y + random.below(3) * kCell / 2}};
    }
    std::set<std::set<std::uint32_t>> found;
    for (const ChangedPlace& place : placesOf(boxes)) {
      EXPECT_TRUE(std::ranges::is_sorted(place.boxes));
      found.emplace(place.boxes.begin(), place.boxes.end());
      Box all = boxes[place.boxes.front()];
      for (const std::uint32_t k : place.boxes) all = around(all, boxes[k]);
      EXPECT_EQ(all.min.x, place.box.min.x);
      EXPECT_EQ(all.min.y, place.box.min.y);
      EXPECT_EQ(all.max.x, place.box.max.x);
      EXPECT_EQ(all.max.y, place.box.max.y);
    }
    ASSERT_EQ(found, searched(boxes));
  }
}

}  // namespace
}  // namespace lgs::box2d_test
