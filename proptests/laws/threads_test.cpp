// Threads: a build with an executor gives what a build without gives, to the last id, whatever the executor does; and
// reading is safe beside reading. Built a second time with the thread sanitizer, which sees races that change nothing.
#include "oracle/check/isolated.h"
#include "proptests/support/law.h"
#include "proptests/support/scale.h"
#include "proptests/support/worlds.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <ostream>
#include <thread>

namespace lgs::test {
namespace {

using oracle::Random;
using Job = std::function<void(std::size_t)>;

/// Thread t of n does the jobs t, t + n, …, without a word to the others: a shared counter would order what they do,
/// and hide races from the sanitizer.
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

/// What a world shows after each commit.
struct Built {
  std::vector<ChangeLists> changes;
  std::vector<Snapshot> snapshots;
  friend bool operator==(const Built&, const Built&) = default;
};

/// A world that is built, changed, emptied, and built again, always with one executor.
struct Building {
  World world;
  Executor executor;
  std::vector<Cell> cells;  // that were sown
  Built story;

  void commit() {
    story.changes.push_back(copyOf(world.commit(executor)));
    story.snapshots.push_back(snapshotOf(world, cells));
  }
};

struct Step {
  enum class Kind : std::uint8_t { sow, dig, empty, commit };
  Kind kind{};
  CellRect cells;      ///< to sow: on some chunks, on both sides of zero
  int percent = 100;   ///< of the cells that get something
  bool isMix = false;  ///< of all kinds of shapes, else squares alone
  std::uint64_t seed = 0;
};

/// Many edits, the same each time that they are made.
void sow(const Step& step, Building& building) {
  World& world = building.world;
  Random random(step.seed);
  const std::vector<ShapeId> shapes = turnedShapes(world, random);
  const ShapeId square = shapeOf(world, {unitSquare()});
  for (const Cell cell : cellsOf(step.cells)) {
    if (!random.chance(step.percent)) continue;
    building.cells.push_back(cell);
    for (int times = random.chance(20) ? 2 : 1; times != 0; --times) {
      const bool isEmpty = world.isEmpty(cell);
      const ShapeId shape = step.isMix ? random.pick(shapes) : square;
      const auto added = world.add(cell, shape, random.below(3U));
      if (added) {
        failUnless(isEmpty || shape != square, "a square is accepted where something stands");
      } else {  // as good an edit as any
        failUnless(!isEmpty, "refused in an empty cell");
        failUnless(added.error().code == ErrorCode::overlap && added.error().cell == cell,
                   "refused for another reason than an overlap, or with another cell");
      }
    }
  }
}

void make(const Step& step, Building& building) {
  Random random(step.seed);
  if (step.kind == Step::Kind::sow) sow(step, building);
  if (step.kind == Step::Kind::dig)
    for (int k = 0; k < 20 && !building.cells.empty(); ++k) removeAll(building.world, random.pick(building.cells));
  if (step.kind == Step::Kind::empty)  // the next commit finds no segments: it is a build
    failUnless(building.world.clear({{-200, -200}, {200, 200}}).has_value(), "it can not be cleared");
  if (step.kind == Step::Kind::empty || step.kind == Step::Kind::commit) building.commit();
}

struct Steps {
  std::vector<Step> list;
};

void showValue(const Steps& steps, std::ostream& out) {
  constexpr std::array kKinds{"sow", "dig 20 times", "clear all, and commit", "commit"};
  for (const auto& [kind, cells, percent, isMix, seed] : steps.list) {
    out << kKinds[static_cast<std::size_t>(kind)];
    if (kind == Step::Kind::sow)
      out << fmt::format(" cells ({}, {}) to ({}, {}), {} %, {}", cells.min.i, cells.min.j, cells.max.i, cells.max.j,
                         percent, isMix ? "any shapes" : "squares");
    out << fmt::format(", seed {}\n", seed);
  }
  out << "commit";
}

Step anyStep(Random& random) {
  using enum Step::Kind;
  Step step;
  step.kind = random.pick(std::vector{sow, sow, dig, empty, commit});
  const Cell min{random.between(-100, 39), random.between(-100, 39)};
  const std::int32_t width = random.between(1, 100), height = random.between(1, 71);
  step.cells = {min, {min.i + width - 1, min.j + height - 1}};
  if (random.chance(50)) step.percent = random.between(1, 60);
  step.isMix = random.chance(70);
  step.seed = random.below(1'000'000U);
  return step;
}

rc::Gen<Steps> anySteps() {
  return [](rc::Random chance, int size) {
    Random random(chance.next());
    std::vector<Step> list;
    for (int k = random.below(2 + size / 10); k > 0; --k) list.push_back(anyStep(random));
    return rc::shrinkable::map(
        rc::shrinkable::shrinkRecur(std::move(list),
                                    [](const std::vector<Step>& all) { return rc::shrink::removeChunks(all); }),
        [](std::vector<Step>&& shorter) { return Steps{std::move(shorter)}; });
  };
}

rc::Gen<PreserveRelation> anyRelation() {
  return rc::gen::weightedElement<PreserveRelation>({{55, PreserveRelation()},
                                                     {30, [](Block a, Block b) { return a != b; }},
                                                     {15, [](Block a, Block b) { return (a + b) % 3 == 0; }}});
}

Built builtBy(const Steps& steps, const PreserveRelation& relation, const Executor& executor) {
  Building building{World(relation), executor, {}, {}};
  for (const Step& step : steps.list) make(step, building);
  building.commit();
  return building.story;
}

TEST(Threads, ABuildIsTheSameWithAnyExecutor) {
  const oracle::Shared<std::size_t> segments;
  const auto law = [&](const Steps& steps, const PreserveRelation& relation) {
    const Built alone = builtBy(steps, relation, {});
    for (const ChangeLists& changes : alone.changes) *segments += changes.added.size();
    failUnless(builtBy(steps, relation, inOrder) == alone, "another one where the jobs are done in order");
    failUnless(builtBy(steps, relation, backwards) == alone, "another one where the jobs are done backwards");
    failUnless(builtBy(steps, relation, onThreads<2>) == alone, "another one on two threads");
    failUnless(builtBy(steps, relation, onThreads<5>) == alone, "another one on five threads");
  };
  forAll(60, law, anySteps(), anyRelation());
  if (testScale() < 1) return;  // a few cases may have nearly nothing
  EXPECT_GT(*segments, 1000U) << "worlds of nearly nothing";
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
  World world([](Block a, Block b) { return a != b; });
  Random random(3);
  const std::vector<ShapeId> shapes = turnedShapes(world, random);
  const CellRect rect{{-60, -40}, {20, 30}};
  const std::vector<Cell> cells = cellsOf(rect);
  for (const Cell cell : cells) ASSERT_TRUE(world.add(cell, random.pick(shapes), random.below(3U)));
  world.commit();
  const Snapshot expected = snapshotOf(world, cells);
  std::vector<int> isSame(3);
  onThreads<3>(isSame.size(), [&](std::size_t k) {
    isSame[k] = snapshotOf(world, cells) == expected && world.segments(rect).size() == expected.segments.size();
  });
  EXPECT_EQ(isSame, std::vector<int>(3, 1));
}

}  // namespace
}  // namespace lgs::test
