// A miner digs through rock to a vein of ore, and takes the last cut back. After each commit the areas of rock and ore
// are right, and no cell was looked at that had not changed.
#include "area_by_block.h"

#include <lgs/world.h>

#include <cstdio>

namespace {

constexpr auto U = lgs::kUnitsPerCell;
constexpr lgs::Block kRock = 1, kOre = 2;

int refused(const lgs::Error& error) {
  std::printf("%s\n", lgs::message(error).c_str());
  return 1;
}

void print(const char* what, const lgs::World& world, const examples::AreaByBlock& view) {
  std::printf("%s: %zu cells changed;", what, world.cellChanges().size());
  for (const auto& [block, area] : view.areas()) {
    const double cells = static_cast<double>(area.cells) + static_cast<double>(area.halfUnits) / examples::Area::kCell;
    std::printf(" %g of %s", cells, block == kRock ? "rock" : "ore");
  }
  std::printf("\n");
}

}  // namespace

int main() {
  lgs::World world;
  const auto square = world.shape(lgs::kUnitSquare);
  const auto ramp = world.shape({{0, 0}, {U, 0}, {U, U}});
  if (!square || !ramp) return 1;
  if (const auto done = world.fill({{0, 0}, {99, 99}}, *square, kRock); !done) return refused(done.error());
  world.commit();
  if (const auto done = world.followCells(true); !done) return refused(done.error());
  examples::AreaByBlock view(world);  // the only time that it looks at all cells
  print("at first", world, view);

  for (int j = 97; j <= 99; ++j)
    if (const auto done = world.clear(lgs::Cell{50, j}); !done) return refused(done.error());
  if (const auto done = world.replace({50, 96}, *ramp, kOre); !done) return refused(done.error());
  world.commit();
  view.update(world.cellChanges());
  print("a shaft", world, view);

  const lgs::Mark mark = world.mark();
  if (const auto done = world.clear(lgs::Cell{50, 96}); !done) return refused(done.error());
  world.commit();
  view.update(world.cellChanges());
  print("mined", world, view);

  if (const auto done = world.rollBack(mark); !done) return refused(done.error());
  view.update(world.cellChanges());
  print("undone", world, view);
}
