// The ground of a game, without physics: whatever is dug, undone, streamed, saved and loaded, in any order, matter is
// neither doubled nor lost.
#include "addons/falling/tests/area.h"
#include "proptests/support/law.h"

#include <lgs/ground.h>
#include <lgs/hashes.h>

#include <gtest/gtest.h>

#include <array>

namespace lgs::test {
namespace {

constexpr Block kStone = 1, kBedrock = 2, kWood = 3;
constexpr CellRect kEverywhere{{-kMaxCell, -kMaxCell}, {kMaxCell, kMaxCell}};

/// Ground up to row 20, with caves, on bedrock in row 0; nothing above it and below it.
void hills(World& land, const CellRect& chunk) {
  if (chunk.min.j != 0) return;
  const ShapeId square = land.shape(kUnitSquare).value();
  for (std::int32_t i = chunk.min.i; i <= chunk.max.i; ++i) {
    for (std::int32_t j = 0; j <= 20; ++j) {
      if (j == 0 || (i * 7 + j * 5) % 11 > 1) {
        EXPECT_TRUE(land.add({i, j}, square, j == 0 ? kBedrock : kStone));
      }
    }
  }
}

GroundOptions options(std::size_t chunksAtOnce = 100, AtEdge atEdge = AtEdge::holds) {
  return {.isAnchor = [](Block block, Cell) { return block == kBedrock; },
          .atEdge = atEdge,
          .staying = [](Block block) { return block == kBedrock; },
          .land = hills,
          .chunksAtOnce = chunksAtOnce,
          .undoSteps = 6};
}

std::vector<std::byte> saved(Ground<>& ground) {
  std::vector<std::byte> bytes;
  EXPECT_TRUE(
      ground.save([&](std::span<const std::byte> more) { bytes.insert(bytes.end(), more.begin(), more.end()); }));
  return bytes;
}

/// All that there is, on the shelf too.
struct Matter {
  std::int64_t ground = 0, rocks = 0, land = 0;  ///< twice the areas; `land` is what was made
  std::uint64_t hash = 0;                        ///< of the ground
  std::size_t rockCount = 0;
};
Matter matterOf(Ground<>& ground) {
  const auto all = loadGround(saved(ground), {}, kEverywhere, shelfInMemory());
  EXPECT_TRUE(all);
  Matter matter{areaOf(all->world), 0, 0, groundHash(all->world, kEverywhere), all->rocks.size()};
  for (const Rock& rock : all->rocks)
    for (const BodyPolygon& p : rock.ground.polygons) matter.rocks += areaOf(p.vertices);
  for (const Cell corner : all->land) {
    World land;
    hills(land, chunkAround(corner));
    matter.land += areaOf(land);
  }
  return matter;
}

/// A player who digs, builds, goes back and forth in time and in space. Each stroke has brought or taken so much.
class Play {
 public:
  explicit Play(std::uint64_t seed) : state_(seed) { expectAll(); }
  void turn() {
    const bool isWhole = ground_->window(cellsAt(at_));  // goes on
    EXPECT_TRUE(isWhole || chunksAtOnce_ < 100);
    EXPECT_TRUE(!isWhole || !ground_->world().firstUnloaded(cellsAt(at_)));
    const int what = below(100);
    if (what < 40) {
      stroke([&] { return ground_->dig(circle(somewhere(), (1 + below(4)) * kUnitsPerCell, 8)); });
    } else if (what < 45) {
      stroke([&] { return ground_->paint(circle(somewhere(), (1 + below(2)) * kUnitsPerCell, 8), kWood); });
    } else if (what < 62) {
      if (ground_->undo()) --now_;
    } else if (what < 72) {
      if (ground_->redo()) ++now_;
    } else if (what < 85) {
      at_ += 16 * (below(5) - 2);
    } else if (what < 95) {
      settleOne();
    } else {
      load();
    }
    EXPECT_LE(now_, static_cast<std::int64_t>(brought_.size()));
    expectAll();
  }

 private:
  int below(int n) {
    state_ = state_ * 6'364'136'223'846'793'005U + 1'442'695'040'888'963'407U;
    return static_cast<int>((state_ >> 33) % static_cast<std::uint64_t>(n));
  }
  static CellRect cellsAt(std::int32_t i) { return {{i - 24, -8}, {i + 24, 40}}; }
  Point somewhere() { return toWorld({at_ + below(30) - 15, below(24)}, {0, 0}); }

  template <class Stroke>
  void stroke(const Stroke& stroke) {
    const Matter before = matterOf(*ground_);
    if (!stroke()) return;
    const Matter after = matterOf(*ground_);
    brought_.resize(static_cast<std::size_t>(now_));
    brought_.push_back(after.ground + after.rocks - before.ground - before.rocks);
    ++now_;
  }
  /// A rock that did not move yet fits where it was.
  void settleOne() {
    std::vector<NoPhysics::Handle> rocks;
    ground_->forEachRock([&](NoPhysics::Handle handle, const Body&) { rocks.push_back(handle); });
    if (rocks.empty()) return;
    const NoPhysics::Handle rock = rocks[static_cast<std::size_t>(below(static_cast<int>(rocks.size())))];
    if (ground_->world().firstUnloaded(ground_->host().rock(rock).ground.cells)) return;
    const auto done = ground_->settle(rock);
    EXPECT_TRUE(done || done.error().code == ErrorCode::overlap);
    if (done) brought_.resize(static_cast<std::size_t>(now_));  // there is nothing to redo any more
  }
  void load() {
    const std::vector<std::byte> bytes = saved(*ground_);
    auto other = std::make_unique<Ground<>>(options(chunksAtOnce_, atEdge_));
    other->window(cellsAt(at_));
    EXPECT_TRUE(other->load(bytes));
    EXPECT_FALSE(other->canUndo());
    ground_ = std::move(other);
    for (; now_ > 0; --now_) kept_ += brought_[static_cast<std::size_t>(now_ - 1)];
    brought_.clear();
  }
  void expectAll() {
    const Matter matter = matterOf(*ground_);
    std::int64_t expected = matter.land + kept_;
    for (std::int64_t k = 0; k < now_; ++k) expected += brought_[static_cast<std::size_t>(k)];
    EXPECT_EQ(matter.ground + matter.rocks, expected) << "matter was doubled or lost";
    for (const IslandId id : ground_->islands().all())
      EXPECT_TRUE(ground_->canRedo() || ground_->islands().island(id)->anchors > 0) << "something hangs in the air";
  }

  std::uint64_t state_;
  std::size_t chunksAtOnce_ = static_cast<std::size_t>(std::array{1, 2, 5, 100}[static_cast<std::size_t>(below(4))]);
  AtEdge atEdge_ = below(3) == 0 ? AtEdge::open : AtEdge::holds;
  std::unique_ptr<Ground<>> ground_ = std::make_unique<Ground<>>(options(chunksAtOnce_, atEdge_));
  std::int32_t at_ = 0;
  std::int64_t kept_ = 0;              // brought by what can not be undone any more
  std::vector<std::int64_t> brought_;  // by each stroke
  std::int64_t now_ = 0;
};

LGS_LAW(Ground, NeitherDoublesNorLosesMatter, 20, (std::uint64_t seed)) {
  Play play(seed);
  for (int k = 0; k < 25 && !::testing::Test::HasFailure(); ++k) play.turn();
}

/// A bridge from a wall on bedrock to nowhere.
void buildBridge(Ground<>& ground) {
  EXPECT_TRUE(ground.edit([](World& world) -> Expected<void> {
    const ShapeId square = world.shape(kUnitSquare).value();
    if (const auto done = world.fill({{0, 0}, {0, 5}}, square, kBedrock); !done) return tl::unexpected(done.error());
    if (const auto done = world.fill({{1, 0}, {8, 0}}, square, kBedrock); !done) return tl::unexpected(done.error());
    if (const auto done = world.fill({{1, 5}, {8, 5}}, square, kStone); !done) return tl::unexpected(done.error());
    return {};
  }));
  ground.forgetUndo();
}

TEST(GroundByHand, UndoOverATakeAndOverASettle) {
  Ground<> ground({.isAnchor = options().isAnchor});
  buildBridge(ground);
  const auto rocks = [&] {
    std::vector<NoPhysics::Handle> handles;
    ground.forEachRock([&](NoPhysics::Handle handle, const Body&) { handles.push_back(handle); });
    return handles;
  };
  const auto cut = [](World& world) { return world.clear(Cell{2, 5}); };
  ASSERT_TRUE(ground.edit(cut));
  ASSERT_EQ(rocks().size(), 1U);
  EXPECT_TRUE(ground.world().isEmpty({5, 5}));
  ground.host().rock(rocks()[0]).placing.origin.y -= 4;
  ASSERT_TRUE(ground.place({0, 8}, kUnitSquare, kBedrock));  // another stroke, while it falls
  ASSERT_TRUE(ground.settle(rocks()[0]));
  EXPECT_TRUE(rocks().empty());
  EXPECT_FALSE(ground.world().isEmpty({5, 1}));
  ASSERT_TRUE(ground.undo());
  ASSERT_EQ(rocks().size(), 1U) << "it lies there, and is no ground";
  EXPECT_TRUE(ground.world().isEmpty({5, 1}));
  EXPECT_EQ(ground.host().rock(rocks()[0]).placing.origin.y, 1);
  ASSERT_TRUE(ground.undo());
  EXPECT_TRUE(rocks().empty()) << "it hangs at the bridge again";
  EXPECT_FALSE(ground.world().isEmpty({5, 5}));
  ASSERT_TRUE(ground.redo());
  ASSERT_EQ(rocks().size(), 1U) << "it falls again, from where it was";
  EXPECT_EQ(ground.host().rock(rocks()[0]).placing.origin.y, 5);
  EXPECT_TRUE(ground.redo() && !ground.redo());
  ground.step([] {});
  ASSERT_EQ(rocks().size(), 1U) << "without physics nothing settles by itself";
  ground.forget(rocks()[0]);
  EXPECT_TRUE(rocks().empty());
}

TEST(GroundByHand, BytesThatAreDamagedAreRefusedOrHold) {
  Ground<> ground({.isAnchor = options().isAnchor});
  buildBridge(ground);
  ASSERT_TRUE(ground.edit([](World& world) { return world.clear(Cell{2, 5}); }));
  const std::vector<std::byte> good = saved(ground);
  for (std::size_t k = 0; k < good.size(); ++k) {
    std::vector<std::byte> bad = good;
    bad[k] ^= std::byte{0x15};
    static_cast<void>(loadGround(bad, {}, kEverywhere, shelfInMemory()));
    EXPECT_FALSE(loadGround(std::span(good).first(k), {}, kEverywhere, shelfInMemory())) << "the first " << k;
  }
  EXPECT_TRUE(ground.load(good));
}

TEST(GroundByHand, DrawsWhatChanged) {
  Ground<> ground({});
  ASSERT_TRUE(ground.place({3, 4}, kUnitSquare, kStone));
  const auto first = ground.draw();
  std::size_t fills = 0, lines = 0;
  for (const GroundDrawing& d : first) fills += d.fills.size(), lines += d.lines.size();
  EXPECT_EQ(fills, 1U);
  EXPECT_EQ(lines, 4U);
  EXPECT_TRUE(ground.draw().empty());
  ASSERT_TRUE(ground.undo());
  const auto gone = ground.draw();
  EXPECT_EQ(gone.size(), first.size());
  for (const GroundDrawing& d : gone) EXPECT_TRUE(d.fills.empty() && d.lines.empty());
}

}  // namespace
}  // namespace lgs::test
