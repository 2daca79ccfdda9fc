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

/// Gives bytes the checksum that they should have.
void seal(std::vector<std::byte>& bytes) {
  std::uint32_t sum = 0xffff'ffff;
  for (std::size_t k = 0; k + 4 < bytes.size(); ++k) {
    sum ^= std::to_integer<std::uint32_t>(bytes[k]);
    for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ (0xedb8'8320u & (0u - (sum & 1u)));
  }
  for (std::size_t k = 0; k < 4; ++k) bytes[bytes.size() - 4 + k] = static_cast<std::byte>(~sum >> 8 * k & 0xffu);
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

/// Bytes of ill will have the right checksum: what they say is read, and must be good or be refused.
TEST_F(GoingBack, BytesOfIllWillAreRefusedOrAreAWorld) {
  int refused = 0;
  forSeeds(600, [&](Random& random, std::uint64_t) {
    World world = someWorld({}, random);
    world.commit();
    std::vector<std::byte> bytes = saved(world);
    constexpr std::size_t kHead = 8, kTail = 4;
    for (int k = 1 + random.below(3); k > 0; --k) {
      const std::size_t at = kHead + random.below(bytes.size() - kHead - kTail);
      bytes[at] = std::byte{
          random.pick<unsigned char>({0, 1, 2, 3, 0x7f, 0x80, 0xff, static_cast<unsigned char>(random.below(256))})};
    }
    seal(bytes);
    auto loaded = World::load(bytes);
    if (!loaded) {
      ++refused;
      EXPECT_LE(loaded.error().offset, bytes.size());
      return;
    }
    const std::vector<std::byte> again = saved(*loaded);
    auto twin = World::load(again);
    ASSERT_TRUE(twin) << message(twin.error());
    expectNoDifference(*loaded, *twin, random);
  });
  EXPECT_GT(refused, 0);
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
