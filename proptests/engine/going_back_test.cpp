// Law 12: going back to a mark, and loading what was saved, is never having left.
#include "scale.h"
#include "twins.h"

#include <gtest/gtest.h>

namespace lgs::engine_test {
namespace {

using oracle::Random;

PreserveRelation relationOf(Random& random) {
  if (random.chance(70)) return {};
  return [](Block a, Block b) { return a != b; };
}

/// A world in the middle of its life.
World someWorld(const PreserveRelation& relation, Random& random) {
  World world(relation);
  EXPECT_TRUE(world.shape(kUnitSquare));
  for (int k = random.below(40); k > 0; --k) make(world, randomEdit(world, random));
  return world;
}

/// Makes random edits in both worlds, which must answer the same.
void expectNoDifference(World& stayed, World& left, Random& random) {
  for (int k = 0; k < 30 && !testing::Test::HasFailure(); ++k) {
    const AnyEdit edit = randomEdit(stayed, random);
    const Outcome one = make(stayed, edit), other = make(left, edit);
    EXPECT_EQ(one, other) << "edit " << k << " of kind " << static_cast<int>(edit.kind);
  }
  EXPECT_EQ(copyOf(stayed.commit()), copyOf(left.commit()));
  EXPECT_TRUE(saved(stayed) == saved(left)) << "saved worlds differ";
}

class GoingBack : public testing::Test {
 protected:
  template <class Property>
  void forSeeds(std::int64_t count, Property&& property) {
    for (std::int64_t seed = 1; seed <= scaled(count) && !HasFailure(); ++seed) {
      SCOPED_TRACE("seed " + std::to_string(seed));
      Random random(static_cast<std::uint64_t>(seed));
      property(random, static_cast<std::uint64_t>(seed));
    }
  }
};

TEST_F(GoingBack, IsNeverHavingLeft) {
  forSeeds(400, [](Random& random, std::uint64_t seed) {
    const PreserveRelation relation = relationOf(random);
    Random again(seed + 1), same(seed + 1);
    World stayed = someWorld(relation, again), left = someWorld(relation, same);
    for (int visits = 1 + random.below(3); visits > 0; --visits) {
      const Mark mark = left.checkpoint();
      Mark inner;
      for (int k = random.below(25); k > 0; --k) {
        make(left, randomEdit(left, random));
        if (random.chance(10)) inner = left.checkpoint();
        if (random.chance(10) && inner) {
          EXPECT_TRUE(left.rollBack(inner));
        }
        if (random.chance(10) && inner) {
          EXPECT_TRUE(left.forget(inner));
          inner = {};
        }
      }
      ASSERT_TRUE(left.rollBack(mark));
      EXPECT_EQ(inner && left.rollBack(inner), false) << "a mark made after the moment one went back to";
      if (random.chance(50)) {
        ASSERT_TRUE(left.forget(mark));
      }
      Random next(seed + 2);
      expectNoDifference(stayed, left, next);
    }
  });
}

TEST_F(GoingBack, ReportsExactlyWhatItDoesToTheSegments) {
  forSeeds(400, [](Random& random, std::uint64_t) {
    World world = someWorld(relationOf(random), random);
    world.commit();
    Follower follower(world);
    const Mark mark = world.checkpoint();
    for (int rounds = 0; rounds < 4; ++rounds) {
      for (int k = random.below(20); k > 0; --k) {
        const AnyEdit edit = randomEdit(world, random);
        if (edit.kind == AnyEdit::Kind::commit)
          follower.follow(world, world.commit());
        else
          make(world, edit);
      }
      ASSERT_TRUE(world.rollBack(mark));
      follower.follow(world, world.changesOfRollBack());
      EXPECT_TRUE(follower.agrees(world));
      const Changes& changes = world.changesOfRollBack();
      for (const auto* ids : {&changes.removed, &changes.added, &changes.relinked})
        EXPECT_TRUE(std::is_sorted(ids->begin(), ids->end()));
    }
  });
}

TEST_F(GoingBack, LoadingIsNeverHavingLeft) {
  forSeeds(400, [](Random& random, std::uint64_t) {
    const PreserveRelation relation = relationOf(random);
    World stayed = someWorld(relation, random);
    stayed.commit();
    const std::vector<std::byte> bytes = saved(stayed);
    auto loaded = World::load(bytes, relation);
    ASSERT_TRUE(loaded) << message(loaded.error());
    EXPECT_TRUE(saved(*loaded) == bytes) << "saved again, a loaded world gives other bytes";
    EXPECT_EQ(snapshotOf(*loaded, {}), snapshotOf(stayed, {}));
    expectNoDifference(stayed, *loaded, random);
  });
}

TEST_F(GoingBack, ATransactionIsUndoneUnlessItIsKept) {
  forSeeds(200, [](Random& random, std::uint64_t seed) {
    Random again(seed), same(seed);
    World stayed = someWorld({}, again), left = someWorld({}, same);
    {
      const Transaction group = left.edit();
      for (int k = 0; k < 8; ++k) {
        const AnyEdit edit = randomEdit(left, random);
        if (edit.kind != AnyEdit::Kind::commit) make(left, edit);
      }
    }
    {
      Transaction group = left.edit();
      for (int k = 0; k < 8; ++k) {
        const AnyEdit edit = randomEdit(left, random);
        if (edit.kind == AnyEdit::Kind::commit) continue;
        EXPECT_EQ(make(left, edit), make(stayed, edit));
      }
      group.keep();
    }
    expectNoDifference(stayed, left, random);
  });
}

TEST_F(GoingBack, BytesThatWereNotWrittenAreRefused) {
  forSeeds(100, [](Random& random, std::uint64_t) {
    World world = someWorld({}, random);
    world.commit();
    const std::vector<std::byte> bytes = saved(world);
    std::vector<std::byte> wrong = bytes;
    if (random.chance(50)) {
      wrong.resize(random.below(bytes.size()));
    } else {
      wrong[random.below(bytes.size())] ^= std::byte{1} << random.below(8);
    }
    const auto loaded = World::load(wrong);
    ASSERT_FALSE(loaded);
    EXPECT_LE(loaded.error().offset, wrong.size());
    EXPECT_FALSE(message(loaded.error()).empty());
  });
}

TEST(GoingBackByHand, MarksThatAreNoneAreRefused) {
  World world;
  EXPECT_EQ(world.rollBack({}).error().code, ErrorCode::unknownMark);
  EXPECT_EQ(world.forget(Mark{7}).error().code, ErrorCode::unknownMark);
  const Mark mark = world.checkpoint();
  EXPECT_TRUE(world.forget(mark));
  EXPECT_EQ(world.rollBack(mark).error().code, ErrorCode::unknownMark);
  place(world, {}, unitSquare());
  EXPECT_EQ(world.save([](std::span<const std::byte>) {}).error().code, ErrorCode::uncommitted);
}

TEST(GoingBackByHand, SmallFiles) {
  World blocks, ramps;
  ASSERT_TRUE(blocks.fill({{0, 0}, {99, 99}}, shapeOf(blocks, {unitSquare()}), 1));
  Random random(1);
  for (const Cell cell : cellsOf({{0, 0}, {99, 99}})) place(ramps, cell, oracle::turned(ramp(), random.below(8)), 1);
  blocks.commit();
  ramps.commit();
  EXPECT_LT(saved(blocks).size(), 10'000U);
  EXPECT_LT(saved(ramps).size(), 40'000U);
}

}  // namespace
}  // namespace lgs::engine_test
