// Threads: a build with an executor gives what a build without gives, to the last id, whatever the executor does; and
// reading is safe beside reading. Built a second time with the thread sanitizer, which sees races that change nothing.
#include "oracle/generate/random.h"
#include "proptests/support/scale.h"
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>

#include <thread>

namespace lgs::test {
namespace {

using oracle::Random;
using Job = std::function<void(std::size_t)>;

/// Thread t of n does the jobs t, t + n, …, without a word to the others: a shared counter would order what they do, and
/// hide races from the sanitizer.
template <std::size_t n>
void onThreads(std::size_t count, const Job& job) {
  std::vector<std::jthread> threads;
  for (std::size_t t = 0; t < n; ++t)
    threads.emplace_back([&, t] {
      for (std::size_t k = t; k < count; k += n) job(k);
    });
}

void inOrder(std::size_t count, const Job& job) {
  for (std::size_t k = 0; k < count; ++k) job(k);
}

void backwards(std::size_t count, const Job& job) {
  for (std::size_t k = count; k-- > 0;) job(k);
}

/// Edits on some chunks on both sides of zero, the same each time that they are made.
struct Edits {
  std::uint64_t seed = 0;
  CellRect cells;
  int percent = 0;     ///< of the cells that get something
  bool isMix = false;  ///< shapes of all kinds, else squares alone
  PreserveRelation preserve;

  explicit Edits(std::uint64_t s) : seed(s) {
    Random random(s);
    const std::int32_t i = random.below(140) - 100, j = random.below(140) - 100;
    cells = {{i, j}, {i + random.below(100), j + random.below(71)}};
    percent = random.chance(50) ? 100 : 1 + random.below(60);
    isMix = random.chance(70);
    if (random.chance(30)) preserve = [](Block a, Block b) { return a != b; };
    if (random.chance(15)) preserve = [](Block a, Block b) { return (a + b) % 3 == 0; };
  }

  void make(World& world) const {
    Random random(seed);
    std::vector<ShapeId> shapes;
    for (const oracle::NamedShape& shape : oracle::degenerateShapes()) {
      std::vector<LocalPolygon> polygons;
      const int symmetry = random.below(8);
      for (const LocalPolygon& p : shape.polygons) polygons.push_back(oracle::turned(p, symmetry));
      shapes.push_back(shapeOf(world, polygons));
    }
    const ShapeId square = shapeOf(world, {unitSquare()});
    for (const Cell cell : cellsOf(cells)) {
      if (!random.chance(percent)) continue;
      // Where polygons overlap, the second is refused, which is as good an edit as any.
      for (int times = random.chance(20) ? 2 : 1; times != 0; --times)
        static_cast<void>(world.add(cell, isMix ? random.pick(shapes) : square, random.below(3U)));
    }
  }
};

/// What a world shows once it is built, changed, emptied, and built again.
struct Story {
  std::vector<ChangeLists> changes;
  std::vector<Snapshot> snapshots;
  friend bool operator==(const Story&, const Story&) = default;
};

Story storyOf(const Edits& edits, const Executor& executor) {
  Story story;
  World world(edits.preserve);
  const std::vector<Cell> cells = cellsOf(edits.cells);
  const auto commit = [&] {
    story.changes.push_back(copyOf(world.commit(executor)));
    story.snapshots.push_back(snapshotOf(world, cells));
  };
  edits.make(world);
  commit();
  Random random(edits.seed);
  for (int k = 0; k < 20; ++k) removeAll(world, random.pick(cells));
  commit();
  EXPECT_TRUE(world.clear(edits.cells));
  commit();
  edits.make(world);
  commit();
  return story;
}

TEST(Threads, ABuildIsTheSameWithAnyExecutor) {
  std::size_t segments = 0;
  for (std::int64_t k = 0; k < scaled(60); ++k) {
    const Edits edits(static_cast<std::uint64_t>(k));
    const Story expected = storyOf(edits, {});
    segments += expected.changes[0].added.size();
    ASSERT_EQ(storyOf(edits, inOrder), expected) << "world " << k;
    ASSERT_EQ(storyOf(edits, backwards), expected) << "world " << k;
    ASSERT_EQ(storyOf(edits, onThreads<2>), expected) << "world " << k;
    ASSERT_EQ(storyOf(edits, onThreads<5>), expected) << "world " << k;
  }
  EXPECT_GT(segments, 1000U);
}

// What the random worlds hardly ever have: chunks with one cell each, and a free side between them.
TEST(Threads, ABuildOfOneCellAChunkIsTheSame) {
  const auto build = [](const Executor& executor) {
    World world;
    place(world, {31, 0}, eighths({{0, 0}, {4, 0}, {0, 4}}));
    place(world, {32, 0}, unitSquare());
    ChangeLists changes = copyOf(world.commit(executor));
    return std::pair(changes, snapshotOf(world, cellsOf({{31, 0}, {32, 0}})));
  };
  EXPECT_EQ(build(inOrder), build({}));
}

TEST(Threads, TheExecutorIsAskedWhereThereAreNoSegments) {
  std::size_t jobs = 0;
  const Executor counting = [&](std::size_t count, const Job& job) {
    jobs += count;
    inOrder(count, job);
  };
  World world;
  world.commit(counting);
  EXPECT_EQ(jobs, 0U);
  const ShapeId square = shapeOf(world, {unitSquare()});
  ASSERT_TRUE(world.fill({{0, 0}, {95, 63}}, square, 1));
  EXPECT_EQ(world.commit(counting).added.size(), 2U * (96 + 64));
  EXPECT_EQ(jobs, 3U * 6) << "count, create, link for each of six chunks";
  ASSERT_TRUE(world.clear({{3, 3}, {4, 4}}));
  EXPECT_EQ(world.commit(counting).added.size(), 8U);
  EXPECT_EQ(jobs, 3U * 6);
  ASSERT_TRUE(world.clear({{0, 0}, {95, 63}}));
  world.commit(counting);
  EXPECT_EQ(jobs, 3U * 6);
  ASSERT_TRUE(world.fill({{0, 0}, {31, 31}}, square, 1));
  EXPECT_EQ(world.commit(counting).added.size(), 4U * 32);
  EXPECT_EQ(jobs, 3U * (6 + 1));
}

TEST(Threads, ReadingIsSafeBesideReading) {
  const Edits edits(3);
  World world(edits.preserve);
  edits.make(world);
  world.commit();
  const std::vector<Cell> cells = cellsOf(edits.cells);
  const Snapshot expected = snapshotOf(world, cells);
  std::vector<int> isSame(3);
  onThreads<3>(isSame.size(), [&](std::size_t k) {
    isSame[k] = snapshotOf(world, cells) == expected && world.segments(edits.cells).size() == expected.segments.size();
  });
  EXPECT_EQ(isSame, std::vector<int>(3, 1));
}

}  // namespace
}  // namespace lgs::test
