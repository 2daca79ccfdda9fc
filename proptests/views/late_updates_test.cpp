// A view may be updated late: after the frame's own commit, after chunks left, or after something was foreseen. Then it
// refuses, or is what a look at the whole world gives (law 15); it never says that it is right and is not.
#include "proptests/support/must.h"

#include <lgs/hashes.h>
#include <lgs/islands.h>
#include <lgs/pieces.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace lgs::test {
namespace {

constexpr CellRect kLeft{{0, 0}, {31, 31}}, kRight{{32, 0}, {63, 31}};

/// Two chunks, of which the left one is full and has the anchor.
World worldWith(bool hasRelation) {
  World world(hasRelation ? PreserveRelation([](Block a, Block b) { return a != b; }) : PreserveRelation());
  const ShapeId square = must(world.shape(kUnitSquare));
  EXPECT_TRUE(world.followCells(true));
  EXPECT_TRUE(world.fill(kLeft, square, 2));
  EXPECT_TRUE(world.fill({{32, 0}, {40, 10}}, square, 1));
  world.commit();
  return world;
}

struct Views {
  explicit Views(const World& world) : loops(world), islands(world, isAnchor), hashes(world), pieces(world) {}
  static bool isAnchor(Block block, Cell) { return block == 2; }

  Loops loops;
  Islands islands;
  GroundHashes hashes;
  Pieces pieces;
};

/// What can be seen of each view, as text.
std::string seen(const Loops& loops) { return std::to_string(loops.all().size()) + " loops"; }
std::string seen(const Islands& islands) {
  std::string text;
  std::vector<std::uint64_t> anchors;
  for (const IslandId id : islands.all()) anchors.push_back(islands.island(id)->anchors);
  std::ranges::sort(anchors);
  for (const std::uint64_t count : anchors) text += "an island of " + std::to_string(count) + " anchors; ";
  return text;
}
std::string seen(const GroundHashes& hashes) { return std::to_string(hashes.hash()); }
std::string seen(const Pieces& pieces) {
  std::size_t count = 0;
  for (std::int32_t j = 0; j < 32; ++j)
    for (std::int32_t i = 0; i < 64; ++i) count += pieces.solidPieces({i, j}).size();
  return std::to_string(count) + " pieces";
}

enum class Leaves : bool { nothing, aChunk };

struct Late {
  const char* name;
  std::function<void(World&, Views&)> meanwhile;
  bool isRefused;  ///< by those that read cells
  Leaves leaves = Leaves::nothing;
};

const std::vector<Late> kLate{
    {"nothing", [](World&, Views&) {}, false},
    {"a commit that finds nothing", [](World& world, Views&) { world.commit(); }, true},
    {"two of them",
     [](World& world, Views&) {
       world.commit();
       world.commit();
     },
     true},
    {"a chunk leaves", [](World& world, Views&) { EXPECT_TRUE(world.unload(kLeft, {})); }, false, Leaves::aChunk},
    {"something is foreseen",
     [](World& world, Views&) {
       Islands others(world, Views::isAnchor);
       static_cast<void>(foresee(world, others, [](World& w) { return w.clear({50, 5}).has_value(); }));
     },
     true}};

void expectRight(const char* view, bool isTaken, const Late& late, const std::string& is, const std::string& wanted) {
  EXPECT_TRUE(isTaken || late.isRefused) << view << " after " << late.name;
  EXPECT_TRUE(!isTaken || is == wanted) << view << " after " << late.name << ": " << is << ", not " << wanted;
}

TEST(LateUpdates, AreRefusedOrRight) {
  for (const bool hasRelation : {false, true})
    for (const bool rollsBack : {false, true})
      for (const Late& late : kLate) {
        World world = worldWith(hasRelation);
        Views views(world);
        const Mark mark = world.mark();
        EXPECT_TRUE(world.clear({{32, 0}, {32, 31}}));
        Changes changes = world.commit();
        if (rollsBack) {
          ASSERT_TRUE(views.loops.update(world, changes) && views.islands.update(world, changes) &&
                      views.hashes.update(world, changes) && views.pieces.update(world, changes));
          EXPECT_TRUE(world.rollBack(mark));
          changes = world.changesOfRollBack();
        }
        const World then = world;
        late.meanwhile(world, views);
        const bool loops = views.loops.update(world, changes), islands = views.islands.update(world, changes),
                   hashes = views.hashes.update(world, changes), pieces = views.pieces.update(world, changes);
        const std::string where = std::string(hasRelation ? "with" : "without") + " a relation, after a " +
                                  (rollsBack ? "roll-back" : "commit");
        SCOPED_TRACE(where);
        const Views anew(then);
        expectRight("loops", loops, late, seen(views.loops), seen(anew.loops));
        if (late.leaves == Leaves::nothing)  // islands are updated before: islands.h says so
          expectRight("islands", islands, late, seen(views.islands), seen(anew.islands));
        expectRight("hashes", hashes, late, seen(views.hashes), seen(anew.hashes));
        expectRight("pieces", pieces, late, seen(views.pieces), seen(anew.pieces));
      }
}

// Hashes come from the other end of a line as well, made up so that sums are 0.
TEST(LateUpdates, HashesThatAreMadeUpAreFoundWhereSumsAreZero) {
  World world;
  GroundHashes hashes(world);
  hashes.set({0, 0}, 1);
  hashes.set({1000, 1000}, ~std::uint64_t{0});
  constexpr CellRect kAll{{-kMaxCell, -kMaxCell}, {kMaxCell, kMaxCell}};
  EXPECT_EQ(hashes.hashes(kAll).size(), 2U);
  hashes.set({0, 0}, 5);
  ASSERT_EQ(hashes.hashes({{0, 0}, {0, 0}}).size(), 1U);
  EXPECT_EQ(hashes.hashes({{0, 0}, {0, 0}}).front().hash, 5U);
}

// Loops of a world with a relation keep a second world. It holds no more chunks than the first one.
TEST(LateUpdates, ASecondWorldForgetsChunksToo) {
  World world([](Block a, Block b) { return a != b; });
  EXPECT_TRUE(world.followCells(true));
  Loops loops(world);
  for (std::int32_t k = 0; k < 200; ++k) {
    const Cell cell{32 * k, 0};
    EXPECT_TRUE(world.add(cell, kUnitSquare, 1));
    ASSERT_TRUE(loops.update(world, world.commit()));
    EXPECT_TRUE(world.clear({cell, cell}));
    ASSERT_TRUE(loops.update(world, world.commit()));
    EXPECT_TRUE(world.forgetChunks({cell, {cell.i + 31, 31}}));
  }
  EXPECT_EQ(loops.outline(world).stats().chunks, 0U);
}

}  // namespace
}  // namespace lgs::test
