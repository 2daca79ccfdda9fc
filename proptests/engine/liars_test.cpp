// Functions that a world is given and that do not do what world.h asks of them. The outline may be wrong then. No
// memory is touched that is not the world's: the sanitizers watch.
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>

namespace lgs::test {
namespace {

/// Triangles and blocks across a corner of four chunks.
void build(World& world) {
  const ShapeId block = shapeOf(world, {unitSquare()}), ramp = shapeOf(world, {{{0, 0}, {U, 0}, {0, U}}});
  const ShapeId halves =
      shapeOf(world, {{{0, 0}, {U / 3, 0}, {U / 2, U}, {0, U}}, {{U / 3, 0}, {U, 0}, {U, U}, {U / 2, U}}});
  std::uint32_t k = 0;
  for (std::int32_t j = -3; j < 4; ++j)
    for (std::int32_t i = -3; i < 4; ++i, ++k) {
      const ShapeId shape = k % 3 == 0 ? block : k % 3 == 1 ? ramp : halves;
      ASSERT_TRUE(world.add({i, j}, shape, k % 4));
    }
}

std::vector<SegmentFields> segmentsOf(const World& world) { return snapshotOf(world, {}).segments; }

TEST(Liars, AnExecutorThatRepeatsOrLeavesOutJobsChangesNothing) {
  using Job = std::function<void(std::size_t)>;
  const std::vector<Executor> liars{
      [](std::size_t, const Job&) {},
      [](std::size_t count, const Job& job) {
        for (std::size_t k = 0; k < count; k += 2) job(k);
      },
      [](std::size_t count, const Job& job) {
        for (std::size_t k = 2 * count + 3; k-- > 0;) job(k / 2);
      },
      [](std::size_t, const Job& job) { job(SIZE_MAX); },
  };
  World honest;
  build(honest);
  honest.commit();
  for (std::size_t liar = 0; liar < liars.size(); ++liar) {
    World world;
    build(world);
    EXPECT_EQ(world.commit(liars[liar]).added, honest.segments()) << "executor " << liar;
    EXPECT_EQ(segmentsOf(world), segmentsOf(honest));
  }
}

// It leaves code that is compiled without exceptions, so nothing could be cleaned up: the program ends.
TEST(LiarsDeathTest, WhoeverThrowsEndsTheProgram) {
  const auto throws = [](auto...) { throw 7; };
  World world;
  build(world);
  EXPECT_DEATH(world.commit([&](std::size_t, const std::function<void(std::size_t)>&) { throws(); }), "");
  world.commit();
  EXPECT_DEATH(world.forEachPolygon([&](Cell, const PlacedPolygon&) { throws(); }), "");
  EXPECT_DEATH(static_cast<void>(world.save([&](std::span<const std::byte>) { throws(); })), "");
  World other([&](Block, Block) {
    throws();
    return true;
  });
  EXPECT_DEATH(build(other), "");
}

TEST(Liars, WhoIsEmptyIsNotCalled) {
  World world;
  build(world);
  world.commit({});
  world.forEachPolygon({});
  EXPECT_TRUE(world.save({}));
  EXPECT_TRUE(world.preserveRelation() == nullptr);
}

// It answers at random. The numbers are the same in each run.
TEST(Liars, ARelationThatContradictsItselfTouchesNothingElse) {
  for (std::uint32_t seed = 1; seed <= 60; ++seed) {
    const auto state = std::make_shared<std::uint32_t>(seed);
    World world([state](Block, Block) {
      *state = *state * 1'664'525u + 1'013'904'223u;
      return (*state >> 16 & 1u) != 0;
    });
    build(world);
    const Executor inTurn = [](std::size_t count, const std::function<void(std::size_t)>& job) {
      for (std::size_t k = 0; k < count; ++k) job(k);
    };
    seed % 2 == 0 ? world.commit(inTurn) : world.commit();
    const Mark mark = world.mark();
    for (std::int32_t k = 0; k < 20; ++k) {
      const Cell cell{k % 7 - 3, k % 5 - 2};
      for (const PlacedPolygon& p : world.polygons(cell))
        static_cast<void>(world.setBlock(p.handle, static_cast<Block>(k % 3)));
      if (k % 4 == 0) static_cast<void>(world.clear(cell));
      world.commit();
    }
    static_cast<void>(segmentsOf(world));
    static_cast<void>(world.loops());
    World copy(world);
    EXPECT_TRUE(world.rollBack(mark));
    world.commit();
    static_cast<void>(World::load(saved(copy), world.preserveRelation()));
  }
}

}  // namespace
}  // namespace lgs::test
