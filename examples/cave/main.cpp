// A miner looks for the way through a cave while others dig, build and undo. After each commit only the cells that
// changed get other pieces, and the way is looked for again.
#include "way.h"

#include <lgs/brush.h>
#include <lgs/pieces.h>
#include <lgs/world.h>

#include <cstdio>

namespace {

constexpr lgs::CellRect kCave{{0, 0}, {31, 15}};
constexpr lgs::Block kRock = 1, kWall = 2;

int refused(const lgs::Error& error) {
  std::printf("%s\n", lgs::message(error).c_str());
  return 1;
}

lgs::Point at(double x, double y) { return lgs::latticePoint({x, y}); }

struct Miner {
  lgs::World world;
  lgs::Pieces pieces{world};
  examples::Way way;

  /// After each commit and roll-back.
  void look(const char* what, const lgs::Changes& changes) {
    const std::uint64_t workedOut = pieces.stats().workedOut;
    if (!pieces.update(world, changes)) pieces = lgs::Pieces(world);
    const std::size_t others = pieces.changed().size();
    const auto found = examples::findWay(pieces, {at(1.5, 8), at(30.5, 8), kCave, lgs::kUnitsPerCell / 4});
    way = found.value_or(examples::Way());
    std::printf("%s: other pieces in %zu cells, %d contents worked out; ", what, others,
                static_cast<int>(pieces.stats().workedOut - workedOut));
    if (found) std::printf("a way of %.1f cells through %zu pieces\n", way.length, way.pieces.size());
    if (!found) std::printf("no way\n");
  }
};

}  // namespace

int main() {
  Miner miner;
  lgs::World& world = miner.world;
  if (const auto done = world.followCells(true); !done) return refused(done.error());
  const auto square = world.shape(lgs::kUnitSquare);
  if (!square) return 1;
  if (const auto done = world.fill(kCave, *square, kRock); !done) return refused(done.error());
  const lgs::Point tunnel[]{at(1.5, 8), at(5, 12),  at(10, 13), at(13, 5),
                            at(19, 3),  at(22, 11), at(27, 12), at(30.5, 8)};
  const std::int64_t wide = lgs::kUnitsPerCell * 9 / 10;
  if (const auto done = carve(world, lgs::thickLine(tunnel, wide)); !done) return refused(done.error());
  for (const lgs::Point hall : {at(10, 12), at(20, 4), at(26, 11)})
    if (const auto done = carve(world, lgs::circle(hall, 2 * lgs::kUnitsPerCell)); !done) return refused(done.error());
  const lgs::Region boulder = lgs::circle(at(20, 4), lgs::kUnitsPerCell * 7 / 10, 16);
  if (const auto done = paint(world, boulder, kRock, lgs::PaintMode::fill); !done) return refused(done.error());
  miner.look("a cave", world.commit());

  const lgs::Point hole[]{at(11.5, 11), at(16, 10), at(21.5, 10)};
  if (const auto done = carve(world, lgs::thickLine(hole, wide / 2)); !done) return refused(done.error());
  miner.look("a short cut is dug", world.commit());

  const lgs::Mark mark = world.mark();
  const lgs::Region door = lgs::rectangle(at(24, 11), {0, 1}, 3 * lgs::kUnitsPerCell, lgs::kUnitsPerCell / 8);
  if (const auto done = paint(world, door, kWall, lgs::PaintMode::fill); !done) return refused(done.error());
  miner.look("a wall is built", world.commit());

  if (const auto done = world.rollBack(mark); !done) return refused(done.error());
  miner.look("and undone", world.changesOfRollBack());
}
