// A hole in a block: a game that uses the brushes of the installed package.
#include <lgs/brush.h>

int main() {
  lgs::World world;
  if (!world.add({0, 0}, lgs::kUnitSquare, 1)) return 1;
  const auto done = lgs::carve(world, lgs::circle(lgs::latticePoint({0.5, 0.5}), lgs::kUnitsPerCell / 4, 8));
  return done && world.commit().added.size() == 12 ? 0 : 1;
}
