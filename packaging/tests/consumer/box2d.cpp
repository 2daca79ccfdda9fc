// The smallest game with Box2D: two blocks side by side, one dug away.
#include <lgs/box2d/terrain.h>
#include <lgs/world.h>
#include <cstdio>

namespace {

template <class Physics>
bool digs(Physics&& physics) {
  lgs::World world;
  const auto square = world.shape(lgs::kUnitSquare);
  if (!square || !world.add({0, 0}, *square, 1)) return false;
  const auto right = world.add({1, 0}, *square, 2);
  world.commit();
  lgs::box2d::Terrain terrain(physics, world);
  if (!right || terrain.edges().counts().edges != 6 || !world.remove(*right)) return false;
  terrain.sync(world.commit());
  return terrain.edges().counts().edges == 4 && terrain.bodyCount() == 1;
}

}  // namespace

int main() {
#ifdef B2_IS_NULL  // Box2D 3
  const b2WorldDef definition = b2DefaultWorldDef();
  const bool fine = digs(b2CreateWorld(&definition));
#else
  const bool fine = digs(b2World({0, -10}));
#endif
  std::puts(fine ? "consumer: fine" : "consumer: not the edges that were expected");
  return fine ? 0 : 1;
}
