// Cost under attack, found by a search (search.h): of edits of cells with many polygons, and of chunks that leave and
// come back with such cells in them.
#include "search.h"

#include <lgs/world.h>

#include <gtest/gtest.h>

#include <map>

namespace lgs::cost_test {
namespace {

using oracle::LocalPolygon;

struct Standing {
  Cell cell;
  LocalPolygon polygon;
};

/// In the order in which they are placed. The last one is taken away and put back.
using Crowd = std::vector<Standing>;

constexpr std::int32_t kMiddle = 31;  // of the cells, the one at a corner of its chunk

Cell drawCell(Random& random) {
  return random.chance(70) ? Cell{kMiddle, kMiddle}
                           : Cell{kMiddle - 1 + random.below(3), kMiddle - 1 + random.below(3)};
}

std::int32_t drawPlace(Random& random, std::int32_t step) { return random.below(kUnitsPerCell / step + 1) * step; }

/// A box, a row of boxes, triangles around a point, or a box with many vertices on its floor.
void addTo(Crowd& crowd, Random& random) {
  const Cell cell = drawCell(random);
  const std::int32_t step = kUnitsPerCell >> random.below(9);
  const LocalPoint at{drawPlace(random, step), drawPlace(random, step)};
  const LocalPoint to{std::min(at.x + step, kUnitsPerCell), std::min(at.y + step, kUnitsPerCell)};
  switch (random.below(4)) {
    case 0:
      for (std::int32_t x = 0; x < kUnitsPerCell && step > 16; x += step)
        crowd.push_back({cell, {{x, at.y}, {x + step, at.y}, {x + step, to.y}, {x, to.y}}});
      break;
    case 1:
      for (std::int32_t y = 0; y < kUnitsPerCell && step > 16; y += step)
        crowd.push_back({cell, {at, {kUnitsPerCell, y}, {kUnitsPerCell, y + step}}});
      break;
    case 2: {
      LocalPolygon polygon{{to.x, to.y}, {at.x, to.y}};
      for (std::int32_t x = at.x; x <= to.x; x += std::max(step / 64, 1)) polygon.push_back({x, at.y});
      crowd.push_back({cell, std::move(polygon)});
      break;
    }
    default:
      crowd.push_back({cell, {at, {to.x, at.y}, to, {at.x, to.y}}});
  }
}

Crowd drawCrowd(Random& random) {
  Crowd crowd;
  while (crowd.size() < 10) addTo(crowd, random);
  return crowd;
}

void changeCrowd(Crowd& crowd, Random& random) {
  if (random.chance(50)) return addTo(crowd, random);
  const auto at = [&] { return crowd.begin() + static_cast<std::ptrdiff_t>(random.below(crowd.size())); };
  if (random.chance(40) && crowd.size() > 1) crowd.erase(at());
  std::iter_swap(at(), crowd.end() - 1);
}

World built(const Crowd& crowd, std::vector<Standing>& placed) {
  World world;
  for (const Standing& standing : crowd)
    if (world.add(standing.cell, standing.polygon, 1)) placed.push_back(standing);
  world.commit();
  return world;
}

/// Vertices by cell, and their squares together.
struct Sizes {
  std::map<std::pair<std::int32_t, std::int32_t>, double> ofCells;
  double all = 0, squares = 0;

  explicit Sizes(const std::vector<Standing>& placed) {
    for (const auto& [cell, polygon] : placed) ofCells[{cell.i, cell.j}] += static_cast<double>(polygon.size());
    for (const auto& [cell, size] : ofCells) {
      all += size;
      squares += size * size;
    }
  }
};

constexpr double kFixed = 20;  // vertices: what an edit costs in any case

double costOfEdits(const Crowd& crowd) {
  std::vector<Standing> placed;
  World world = built(crowd, placed);
  if (placed.empty()) return 0;
  const Sizes sizes(placed);
  const auto& [cell, polygon] = placed.back();
  const double there = sizes.ofCells.at({cell.i, cell.j});
  const PolygonHandle last = world.polygons(cell).back().handle;
  const auto edits = visitsOf([&] {
    EXPECT_TRUE(world.remove(last));
    EXPECT_TRUE(world.add(cell, polygon, 1));
  });
  return static_cast<double>(edits) / ((there + kFixed) * (there + kFixed));
}

double costOfCommit(const Crowd& crowd) {
  std::vector<Standing> placed;
  World world = built(crowd, placed);
  if (placed.empty()) return 0;
  const Cell cell = placed.back().cell;
  EXPECT_TRUE(world.remove(world.polygons(cell).back().handle));
  const auto cost = visitsOf([&] { world.commit(); });
  return static_cast<double>(cost) / (Sizes(placed).all + kFixed);
}

TEST(CostSearch, OfEditsFindsNoneBeyondTheSquareOfTheVertices) {
  EXPECT_LT(dearest<Crowd>(drawCrowd, changeCrowd, costOfEdits, 3, 150), 1.5);
}

TEST(CostSearch, OfCommitsFindsNoneBeyondTheVerticesThatAreNear) {
  EXPECT_LT(dearest<Crowd>(drawCrowd, changeCrowd, costOfCommit, 3, 100), 100);
}

/// Into another world, which knows none of its contents.
double costOfReload(const Crowd& crowd) {
  std::vector<Standing> placed;
  World world = built(crowd, placed);
  if (placed.empty()) return 0;
  std::vector<std::vector<std::byte>> chunks;
  const auto keep = [&](Cell, std::span<const std::byte> chunk) { chunks.emplace_back(chunk.begin(), chunk.end()); };
  EXPECT_TRUE(world.unload({{0, 0}, {2 * kMiddle + 1, 2 * kMiddle + 1}}, keep));
  World other;
  const auto cost = visitsOf([&] {
    for (const auto& chunk : chunks) EXPECT_TRUE(other.reload(chunk));
    other.commit();
  });
  return static_cast<double>(cost) / (1'024 * static_cast<double>(chunks.size()) + Sizes(placed).squares);
}

TEST(CostSearch, OfChunksThatComeBackFindsNoneBeyondTheSquareOfTheirVertices) {
  EXPECT_LT(dearest<Crowd>(drawCrowd, changeCrowd, costOfReload, 3, 100), 50);
}

}  // namespace
}  // namespace lgs::cost_test
