// A miner cuts the last bridge of a rock, and the rock falls. The view of islands says so at that commit; the game
// takes the rock out of the ground, lets it fall by whole cells, and sets it back where it comes to rest.
#include <lgs/islands.h>

#include <cstdio>
#include <utility>

namespace {

constexpr lgs::Block kRock = 1, kBedrock = 2;

int refused(const lgs::Error& error) {
  std::printf("%s\n", lgs::message(error).c_str());
  return 1;
}

/// Tries one cell after the other on the way down. Returns how many it fell.
int settle(lgs::World& world, const lgs::Body& body) {
  int fallen = 0;
  for (;; ++fallen) {
    const lgs::Mark here = world.mark();
    const bool fits = put(world, body, {body.origin.i, body.origin.j - fallen - 1}).has_value();
    static_cast<void>(world.rollBack(here));
    static_cast<void>(world.forget(here));
    if (!fits) break;
  }
  static_cast<void>(put(world, body, {body.origin.i, body.origin.j - fallen}));
  return fallen;
}

}  // namespace

int main() {
  lgs::World world;
  const auto square = world.shape(lgs::kUnitSquare);
  if (!square) return refused(square.error());
  // A floor of bedrock, a pillar on it, and an arm that reaches out from the pillar.
  for (const auto& [cells, block] :
       {std::pair{lgs::CellRect{{0, 0}, {9, 0}}, kBedrock}, std::pair{lgs::CellRect{{0, 1}, {1, 6}}, kRock},
        std::pair{lgs::CellRect{{2, 5}, {8, 6}}, kRock}})
    if (const auto done = world.fill(cells, *square, block); !done) return refused(done.error());
  world.commit();
  if (const auto done = world.followCells(true); !done) return refused(done.error());
  lgs::Islands islands(world, [](lgs::Block block, lgs::Cell) { return block == kBedrock; });

  for (std::int32_t j = 6; j >= 5; --j) {
    if (const auto done = world.clear(lgs::Cell{3, j}); !done) return refused(done.error());
    if (!islands.update(world, world.commit())) return 1;
    std::printf("cell (3, %d) is dug: %zu cut off\n", j, islands.changes().cutOff.size());
  }
  for (const lgs::IslandPair& cut : islands.changes().cutOff) {
    for (const lgs::IslandId id : {cut.from, cut.into}) {
      const lgs::IslandFacts island = *islands.island(id);
      std::printf("%g cells, %s\n", island.outer.area(), island.anchors > 0 ? "held by bedrock" : "held by nothing");
      if (island.anchors > 0) continue;
      const auto body = lgs::take(world, islands, id);
      if (!body) return refused(body.error());
      std::printf("it falls %d cells", settle(world, *body));
      std::printf("; its middle is at (%g, %g) of it\n", body->mass.centroid.x, body->mass.centroid.y);
    }
  }
  if (!islands.update(world, world.commit())) return 1;
  std::printf("%zu island\n", islands.all().size());
}
