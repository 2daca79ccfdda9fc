// The commit that costs a view most, found by a search (search.h): for each unit that the header of the view says its
// update() costs. The headers state the bounds.
#include "ground.h"
#include "oracle/calls/shapes.h"
#include "search.h"

#include <lgs/hashes.h>
#include <lgs/islands.h>
#include <lgs/pieces.h>

#include <gtest/gtest.h>

#include <span>
#include <tuple>

namespace lgs::cost_test {
namespace {

using oracle::LocalPolygon;
using Polygons = std::vector<LocalPolygon>;

constexpr CellRect kField{{-80, -6}, {79, 5}};  // over twelve chunks
constexpr Block kAnchor = 2;
constexpr std::int32_t kSide = kUnitsPerCell;

/// Nine triangles apart from each other: islands by themselves.
Polygons dots() {
  Polygons triangles;
  for (std::int32_t y = 1; y < kSide; y += kSide / 3)
    for (std::int32_t x = 1; x < kSide; x += kSide / 3) triangles.push_back({{x, y}, {x + 99, y}, {x + 99, y + 99}});
  return triangles;
}

/// Four polygons around a hole.
Polygons frame() {
  constexpr LocalPoint kA{kSide / 4, kSide / 4}, kB{kSide * 3 / 4, kSide / 4}, kC{kSide * 3 / 4, kSide * 3 / 4},
      kD{kSide / 4, kSide * 3 / 4};
  return {{{0, 0}, {kSide, 0}, kB, kA},
          {{kSide, 0}, {kSide, kSide}, kC, kB},
          {{kSide, kSide}, {0, kSide}, kD, kC},
          {{0, kSide}, {0, 0}, kA, kD}};
}

const std::vector<Polygons>& shapes() {
  static const std::vector<Polygons> all = [] {
    std::vector<Polygons> made{
        {{{0, 0}, {kSide, 0}, {kSide, kSide}, {0, kSide}}}, dots(), frame(), {comb(3)}, {comb(8)}};
    for (const oracle::NamedShape& shape : oracle::degenerateShapes()) made.push_back(shape.polygons);
    return made;
  }();
  return all;
}

/// The same edit again and again, along a row.
struct Stroke {
  std::size_t shape = 0;  ///< 0: clears; else one more than its place in shapes()
  Block block = 1;
  Cell cell;
  std::int32_t width = 1, height = 1, step = 1, times = 1;
};

/// A world, and then one commit.
struct Edits {
  std::vector<Stroke> before, then;
};

Stroke drawStroke(Random& random) {
  Stroke s;
  s.shape = random.chance(30) ? 0 : random.chance(50) ? 1 : 1 + random.below(shapes().size());
  s.block = random.chance(50) ? kAnchor : 1;
  s.cell = {random.between(kField.min.i, kField.max.i), random.between(kField.min.j, kField.max.j)};
  if (random.chance(40)) s.cell = kField.min;
  s.width = random.pick(std::vector{1, 1, 2, 3, 40, 160});
  s.height = random.pick(std::vector{1, 1, 2, 3, 12});
  s.step = random.between(1, 4);
  s.times = random.pick(std::vector{1, 3, 20, 80});
  return s;
}

Edits drawEdits(Random& random) {
  Edits edits;
  for (auto* strokes : {&edits.before, &edits.then})
    for (int k = 3; k > 0; --k) strokes->push_back(drawStroke(random));
  return edits;
}

void changeStroke(Stroke& s, Random& random) {
  const Stroke other = drawStroke(random);
  const int what = random.below(6);
  if (what == 0) s.shape = other.shape;
  if (what == 1) s.block = other.block;
  if (what == 2) s.cell = {s.cell.i + random.between(-2, 2), s.cell.j + random.between(-2, 2)};
  if (what == 3) std::tie(s.width, s.height) = std::pair(other.width, other.height);
  if (what == 4) s.step = other.step;
  if (what == 5) s.times = random.chance(50) ? other.times : std::max(1, s.times + random.between(-3, 3));
}

void changeEdits(Edits& edits, Random& random) {
  std::vector<Stroke>& strokes = random.chance(50) ? edits.before : edits.then;
  const auto at = static_cast<std::ptrdiff_t>(random.below(strokes.size()));
  const int kind = random.below(6);
  if (kind == 0 && strokes.size() > 1)
    strokes.erase(strokes.begin() + at);
  else if (kind == 1 && strokes.size() < 8)
    strokes.insert(strokes.begin() + at,
                   random.chance(50) ? drawStroke(random) : strokes[static_cast<std::size_t>(at)]);
  else
    changeStroke(strokes[static_cast<std::size_t>(at)], random);
}

/// What goes beyond a number of polygons is left out, so that a case is quick.
void make(World& world, const std::vector<Stroke>& strokes) {
  std::int64_t left = 1'000;
  for (const Stroke& s : strokes) {
    const std::size_t polygons = s.shape == 0 ? 1 : shapes()[s.shape - 1].size();
    for (std::int32_t k = 0; k < s.times; ++k) {
      const Cell from{s.cell.i + k * s.step, s.cell.j};
      const CellRect cells{
          {std::max(from.i, kField.min.i), std::max(from.j, kField.min.j)},
          {std::min(from.i + s.width - 1, kField.max.i), std::min(from.j + s.height - 1, kField.max.j)}};
      if (isEmpty(cells)) continue;
      left -= static_cast<std::int64_t>(polygons) * (cells.max.i - cells.min.i + 1) * (cells.max.j - cells.min.j + 1);
      if (left < 0) return;
      EXPECT_TRUE(world.clear(cells));
      if (s.shape == 0) continue;
      EXPECT_TRUE(world.fill(cells, world.shape(shapes()[s.shape - 1]).value(), s.block));
    }
  }
}

// --- The views, and what their headers say an update costs

std::size_t segmentsIn(const Changes& changes) {
  return changes.removed.size() + changes.added.size() + changes.relinked.size();
}

/// The changed cells, and the edges of the polygons that they held and hold.
std::size_t edgesIn(std::span<const CellChange> changes) {
  std::size_t edges = changes.size();
  for (const CellChange& change : changes)
    for (const auto& polygons : {change.before, change.now})
      for (const PlacedPolygon& p : polygons) edges += p.vertices.size();
  return edges;
}

struct OfLoops {
  explicit OfLoops(const World& world) : view(world) {}
  void update(const World& world, const Changes& changes) { EXPECT_TRUE(view.update(world, changes)); }
  static std::size_t units(const World&, const Changes& changes) { return segmentsIn(changes); }
  Loops view;
};

struct OfIslands {
  explicit OfIslands(const World& world) : view(world, [](Block block, Cell) { return block == kAnchor; }) {}
  void update(const World& world, const Changes& changes) {
    walked = view.walked();
    EXPECT_TRUE(view.update(world, changes));
    walked = view.walked() - walked;
  }
  std::size_t units(const World& world, const Changes& changes) const {
    constexpr std::size_t kRows = 4 * 160;  // cells, which a few rays may pass
    return segmentsIn(changes) + edgesIn(world.cellChanges()) + static_cast<std::size_t>(walked) + kRows;
  }
  Islands view;
  std::uint64_t walked = 0;
};

/// Of a view that follows cells.
template <class View>
struct OfCells {
  explicit OfCells(const World& world) : view(world) {}
  void update(const World& world, const Changes& changes) { EXPECT_TRUE(view.update(world, changes)); }
  static std::size_t units(const World& world, const Changes&) { return edgesIn(world.cellChanges()); }
  View view;
};

/// What the update after the commit costs for each unit.
template <class View>
double costOf(const Edits& edits) {
  World world;
  const auto become = [&](const std::vector<Stroke>& strokes) -> const Changes& {
    make(world, strokes);
    return world.commit();
  };
  // Once before, so that the world has its size: lists that grow cost at once what they save later.
  become(edits.before);
  become(edits.then);
  EXPECT_TRUE(world.clear(kField));
  become(edits.before);
  EXPECT_TRUE(world.followCells(true));
  View view(world);
  const Changes& changes = become(edits.then);
  const auto cost = visitsOf([&] { view.update(world, changes); });
  return static_cast<double>(cost) / static_cast<double>(view.units(world, changes) + 1);
}

template <class View>
double dearestUnit() {
  return dearest<Edits>(drawEdits, changeEdits, costOf<View>, 3, 120);
}

TEST(CostSearchOfViews, LoopsCostTheSegmentsThatChanged) { EXPECT_LT(dearestUnit<OfLoops>(), 2'000); }

TEST(CostSearchOfViews, IslandsCostWhatChangedAndWhatIsWalkedThrough) { EXPECT_LT(dearestUnit<OfIslands>(), 2'500); }

TEST(CostSearchOfViews, HashesCostTheChangedCells) { EXPECT_LT(dearestUnit<OfCells<GroundHashes>>(), 400); }

TEST(CostSearchOfViews, PiecesCostTheChangedCells) { EXPECT_LT(dearestUnit<OfCells<Pieces>>(), 2'500); }

}  // namespace
}  // namespace lgs::cost_test
