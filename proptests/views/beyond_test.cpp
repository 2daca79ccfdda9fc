// Islands over the edge of memory: a view follows chunks that leave and come back as it follows edits, and what hangs
// together with unloaded ground never falls.
#include "beyond_check.h"

#include "proptests/laws/unloaded.h"
#include "proptests/support/law.h"
#include "proptests/support/must.h"

#include <gtest/gtest.h>

namespace lgs::test {
namespace {

constexpr Block kHeld = 2;

bool isHeld(Block block, Cell) { return block == kHeld; }

/// A world of which chunks are unloaded, one with the same ground that has all of them, and a view of the former.
class Window {
 public:
  explicit Window(PreserveRelation relation = {}) : part_(relation), whole_(relation) {
    EXPECT_TRUE(part_.followCells(true));
    islands_ = Islands(part_, isHeld);
    EXPECT_EQ(check_.begin(part_, whole_, islands_), "");
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
    BeyondCheck check(isHeld);
    EXPECT_EQ(check.begin(part_, whole_, Islands(part_, isHeld)), "");
  }
  IslandId at(Cell cell) const {
    const auto polygons = part_.polygons(cell);
    return polygons.empty() ? IslandId{} : islands_.of(part_, polygons.front().handle);
  }

 private:
  void follow(const Changes& changes) {
    ASSERT_TRUE(islands_.update(part_, changes));
    ASSERT_EQ(check_.update(part_, whole_, islands_), "");
  }

  World part_, whole_;
  Shelf shelf_;
  Islands islands_{part_};
  BeyondCheck check_{isHeld};
  std::vector<std::pair<Mark, Mark>> marks_;
};

/// Edits around the corner that four chunks have in common, which leave and come back.
void live(std::uint64_t seed, bool withMarks, const PreserveRelation& relation) {
  oracle::Random choices(seed);
  Window window(relation);
  std::vector<ShapeId> shapes;
  window.edit([&](World& world) {
    oracle::Random random(7);  // the same turns
    shapes = turnedShapes(world, random);
  });
  const auto cell = [&] { return Cell{choices.between(-3, 2), choices.between(-2, 1)}; };
  const auto chunks = [&] {
    const std::int32_t i = choices.between(-1, 0), j = choices.between(-1, 0);
    return CellRect{chunkAt(i, j).min, chunkAt(choices.between(i, 0), choices.between(j, 0)).max};
  };
  for (int k = 0; k < 60 && !::testing::Test::HasFailure(); ++k) {
    const int what = choices.below(100);
    const Cell at = cell();
    const Block block = choices.below(3U);
    if (what < 30) {
      if (window.isLoaded(at))
        window.edit([&, shape = choices.pick(shapes)](World& w) { static_cast<void>(w.add(at, shape, block)); });
    } else if (what < 40) {
      if (window.isLoaded(at)) window.edit([&](World& w) { static_cast<void>(w.clear(at)); });
    } else if (what < 45) {
      const CellRect row{{-3, at.j}, {2, at.j}};
      window.edit([&](World& w) {
        if (!window.part().firstUnloaded(row))
          for (const Cell c : cellsOf(row)) static_cast<void>(w.add(c, shapes[0], block));
      });
    } else if (what < 65) {
      if (relation) window.commit();
      choices.chance(50) ? window.unload(chunks()) : window.reload(chunks());
    } else if (what < 72 && withMarks) {
      window.commit();
      if (window.hasMarks() && choices.chance(60))
        window.goBack(choices.below(window.marks()));
      else
        window.mark();
    } else {
      window.commit();
      if (!relation && choices.chance(20)) window.begin();
    }
  }
  window.commit();
  window.reload({chunkAt(-1, -1).min, chunkAt(0, 0).max});
  window.commit();
}

LGS_LAW(BeyondMemory, IslandsAreAsTheWholeGroundHasThem, 400, (std::uint64_t seed)) { live(seed, false, {}); }

LGS_LAW(BeyondMemory, GoingBackLeavesTheWindowOpen, 200, (std::uint64_t seed)) { live(seed, true, {}); }

LGS_LAW(BeyondMemory, UnderAPreserveRelation, 100, (std::uint64_t seed)) {
  live(seed, false, [](Block a, Block b) { return a == 0 && b == 1; });
}

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
