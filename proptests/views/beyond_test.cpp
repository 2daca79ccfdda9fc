// Islands over the edge of memory: a view follows chunks that leave and come back as it follows edits, and what hangs
// together with unloaded ground never falls.
#include "oracle/views/beyond_check.h"
#include "oracle/views/recompute.h"
#include "proptests/laws/unloaded.h"
#include "proptests/support/law.h"
#include "proptests/support/must.h"

#include <gtest/gtest.h>
#include <lgs/unloaded.h>

namespace lgs::test {
namespace {

constexpr Block kHeld = 2;

bool isHeld(Block block, Cell) { return block == kHeld; }

/// A world of which chunks are unloaded, one with the same ground that has all of them, and a view of the former. Random
/// ones are `lgs check`'s (oracle/check/laws/views.cpp).
class Window {
 public:
  explicit Window(PreserveRelation relation = {}) : part_(relation), whole_(relation) {
    EXPECT_TRUE(part_.followCells(true));
    islands_ = Islands(part_, isHeld);
    EXPECT_EQ(check_.begin(part_, all(), islands_), "");
  }

  World& part() { return part_; }
  const Islands& islands() const { return islands_; }
  const IslandChanges& changes() const { return islands_.changes(); }
  bool isLoaded(Cell cell) const { return !part_.firstUnloaded({cell, cell}); }

  /// An edit of both worlds.
  template <class Edit>
  void edit(const Edit& edit) {
    edit(part_);
    edit(whole_);
  }
  void unload(const CellRect& cells) { EXPECT_TRUE(part_.unload(cells, shelf_.sink())); }
  void reload(const CellRect& cells) {
    for (std::int32_t j = cells.min.j & ~31; j <= cells.max.j; j += 32)
      for (std::int32_t i = cells.min.i & ~31; i <= cells.max.i; i += 32)
        EXPECT_TRUE(isLoaded({i, j}) || shelf_.reload(part_, {i, j}));
  }
  void commit() {
    whole_.commit();
    follow(part_.commit());
  }
  void mark() { marks_.push_back({part_.checkpoint(), whole_.checkpoint()}); }
  bool hasMarks() const { return !marks_.empty(); }
  void goBack(std::size_t to) {
    marks_.resize(to + 1);
    EXPECT_TRUE(part_.rollBack(marks_.back().first) && whole_.rollBack(marks_.back().second));
    follow(part_.changesOfRollBack());
  }
  std::size_t marks() const { return marks_.size(); }
  /// A view that begins now says the same.
  void begin() {
    oracle::BeyondCheck check(isHeld);
    EXPECT_EQ(check.begin(part_, all(), Islands(part_, isHeld)), "");
  }
  IslandId at(Cell cell) const {
    const auto polygons = part_.polygons(cell);
    return polygons.empty() ? IslandId{} : islands_.of(part_, polygons.front().handle);
  }

 private:
  oracle::WholeGround all() const {
    oracle::WholeGround ground{oracle::bareScene(whole_).polygons, {}};
    for (const CellRect& chunk : unloadedChunks(part_)) ground.away.insert(chunk.min);
    return ground;
  }
  void follow(const Changes& changes) {
    ASSERT_TRUE(islands_.update(part_, changes));
    ASSERT_EQ(check_.update(part_, all(), islands_), "");
  }

  World part_, whole_;
  Shelf shelf_;
  Islands islands_{part_};
  oracle::BeyondCheck check_{isHeld};
  std::vector<std::pair<Mark, Mark>> marks_;
};

void put(World& world, Cell cell, Block block = 1) { place(world, cell, unitSquare(), block); }

TEST(BeyondMemoryByHand, ARockThatReachesTheEdgeIsHeldUntilItsOtherEndIsThere) {
  Window window;
  window.edit([](World& world) {
    for (std::int32_t i = 28; i < 36; ++i) put(world, {i, 5});
  });
  window.commit();
  const IslandId rock = window.at({28, 5});
  EXPECT_EQ(window.islands().loose(), std::vector{rock});
  window.unload(chunkAt(1, 0));
  window.commit();
  EXPECT_EQ(window.changes().joined, (std::vector{IslandPair{rock, kBeyond}}));
  EXPECT_EQ(window.at({28, 5}), kBeyond);
  EXPECT_TRUE(window.islands().loose().empty());
  window.edit([](World& world) { removeAll(world, {30, 5}); });
  window.commit();
  EXPECT_EQ(window.changes().cutOff, (std::vector{IslandPair{kBeyond, window.at({28, 5})}}));
  EXPECT_EQ(window.islands().loose(), std::vector{window.at({28, 5})});
  window.reload(chunkAt(1, 0));
  window.commit();
  EXPECT_EQ(window.changes().cutOff, (std::vector{IslandPair{kBeyond, window.at({31, 5})}}));
  EXPECT_EQ(window.islands().loose(), std::vector{window.at({31, 5})}) << "nothing holds what came";
}

TEST(BeyondMemoryByHand, AnIslandAroundAnUnloadedChunkIsHeldByIt) {
  Window window;
  window.edit([](World& world) {
    for (const Cell cell : cellsOf({{-1, -1}, {32, 32}}))
      if (!contains(CellRect{{0, 0}, {31, 31}}, cell)) put(world, cell);
    for (std::int32_t i = 0; i < 4; ++i) put(world, {i, 10}, i == 3 ? kHeld : 1);
  });
  window.commit();
  EXPECT_EQ(window.islands().island(window.at({-1, -1}))->anchors, 1U);
  window.unload(chunkAt(0, 0));
  window.commit();
  EXPECT_EQ(window.at({-1, -1}), kBeyond) << "no loop leads beyond";
  window.begin();
  const CellRect cut{{-1, 9}, {-1, 11}};  // the middle one touches the bedrock's arm, and the others its corners
  window.edit([&](World& world) {
    for (const Cell cell : cellsOf(cut)) removeAll(world, cell);
  });
  window.commit();
  EXPECT_EQ(window.islands().loose(), std::vector{window.at({-1, -1})}) << "it was cut off from the bedrock";
  window.edit([&](World& world) {
    for (const Cell cell : cellsOf(cut)) put(world, cell);
  });
  window.commit();
  EXPECT_EQ(window.at({-1, -1}), kBeyond);
  window.reload(chunkAt(0, 0));
  window.commit();
  EXPECT_EQ(window.islands().island(window.at({-1, -1}))->anchors, 1U);
}

TEST(BeyondMemoryByHand, ARockDugOutAlongTheEdgeKeepsItsAnchors) {
  Window window;
  window.edit([](World& world) {
    fill(world, {{0, 0}, {63, 31}});
    removeAll(world, {10, 10});
    put(world, {10, 10}, kHeld);
  });
  window.commit();
  window.unload(chunkAt(1, 0));
  window.commit();
  EXPECT_EQ(window.at({10, 10}), kBeyond);
  window.edit([](World& world) {
    for (std::int32_t j = 0; j < 32; ++j) removeAll(world, {31, j});
  });
  window.commit();
  EXPECT_EQ(window.islands().island(window.at({10, 10}))->anchors, 1U) << "nobody had counted it";
}

// The view has a world of its own under a preserve relation, and no roll-back tells it what is unloaded.
TEST(BeyondMemoryByHand, UnderAPreserveRelationARollBackMakesUnloadedGroundUnknown) {
  World world([](Block a, Block b) { return a == 0 && b == 1; });
  ASSERT_TRUE(world.followCells(true));
  Islands islands(world, isHeld);
  const auto follow = [&](const Changes& changes) { ASSERT_TRUE(islands.update(world, changes)); };
  put(world, {31, 5});
  put(world, {32, 5});
  follow(world.commit());
  const Mark mark = world.checkpoint();
  Shelf shelf;
  for (int k = 0; k < 2; ++k) {
    removeAll(world, {32, 5});
    follow(world.commit());
    must(world.unload(chunkAt(1, 0), shelf.sink()));
    follow(world.commit());
    EXPECT_EQ(islands.all().size(), 1U);
    ASSERT_TRUE(world.rollBack(mark));
    follow(world.changesOfRollBack());
    EXPECT_TRUE(islands.all().empty()) << "what it hangs on is there again";
    EXPECT_TRUE(shelf.reload(world, {32, 0}));
    follow(world.commit());
    EXPECT_EQ(islands.all().size(), 1U);
  }
}

TEST(BeyondMemoryByHand, AChainThatClosesWithOtherIdsWasBeyond) {
  Window window;
  window.edit([](World& w) { put(w, {-1, 1}); });
  window.commit();
  window.mark();
  window.edit([](World& w) { put(w, {0, 2}); });  // it touches the other one in a corner
  window.commit();
  window.unload(chunkAt(-1, 0));
  window.commit();
  window.reload(chunkAt(-1, 0));
  window.commit();
  window.unload(chunkAt(0, 0));
  window.commit();
  ASSERT_EQ(window.at({-1, 1}), kBeyond);
  window.goBack(0);  // the ids are those of the mark, and nothing is beyond
  EXPECT_EQ(window.changes().cutOff, (std::vector{IslandPair{kBeyond, window.at({-1, 1})}}));
  EXPECT_TRUE(window.changes().added.empty());
}

}  // namespace
}  // namespace lgs::test
