// A block is placed and dug away. It counts the segments each time.
#include <lgs/world.h>

int main() {
  lgs::World world;
  const auto block = world.add({0, 0}, lgs::kUnitSquare, 1);
  if (!block || world.commit().added.size() != 4) return 1;
  return world.remove(*block) && world.commit().removed.size() == 4 ? 0 : 1;
}
