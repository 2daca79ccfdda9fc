// The part that follows a world with views: islands, with the loops in them, and hashes of the ground.
#include "editor.h"
#include "parts.h"

#include <lgs/hashes.h>
#include <lgs/islands.h>

#include <vector>

namespace platform {
namespace {

void put(Hash& hash, lgs::IslandId id) { hash.number(id.value); }
void put(Hash& hash, lgs::LoopId id) { hash.number(id.value); }
template <class Pair>
requires requires(Pair pair) { pair.into; }
void put(Hash& hash, const Pair& pair) {
  put(hash, pair.from);
  put(hash, pair.into);
}
void put(Hash& hash, const lgs::LoopFacts& loop) {
  put(hash, loop.id);
  hash.sign(loop.doubleArea.high);
  hash.number(loop.doubleArea.low);
  hash.number(loop.segments);
  for (const lgs::Point point : {loop.min, loop.max, loop.west}) platform::put(hash, point);
  platform::put(hash, loop.first);
}
void put(Hash& hash, const lgs::IslandFacts& island) {
  put(hash, island.id);
  put(hash, island.outer);
  hash.number(island.anchors);
}
void put(Hash& hash, const lgs::HashedSquare& square) {
  platform::put(hash, square.cells.min);
  hash.number(square.hash);
}
template <class Value>
void putList(Hash& hash, const std::vector<Value>& values) {
  hash.number(values.size());
  for (const Value& value : values) put(hash, value);
}
/// Of loops, or of islands.
template <class Changes>
void putChanges(Hash& hash, const Changes& changes) {
  for (const auto* ids : {&changes.added, &changes.removed, &changes.changed}) putList(hash, *ids);
  putList(hash, changes.joined);
  putList(hash, changes.before);
}

}  // namespace

void views(Hash& hash) {
  Random choices(1'600);
  Editor editor(hash, 600);
  lgs::World& world = editor.world();
  putResult(hash, world.followCells(true));
  lgs::Islands islands(world, [](lgs::Block block, lgs::Cell) { return block == 0; });
  lgs::GroundHashes hashes(world);
  for (int k = 0; k < 1'500; ++k) {
    editor.edits(choices.between(1, 8));
    const lgs::Changes& changes = world.commit();
    hash.byte(islands.update(world, changes) && hashes.update(world, changes) ? 1 : 0);
    putChanges(hash, islands.loops().changes());
    putList(hash, islands.loops().changes().split);
    putChanges(hash, islands.changes());
    putList(hash, islands.changes().cutOff);
    putList(hash, islands.loose());
    hash.number(hashes.hash());
    hash.step();
  }
  for (const lgs::IslandId id : islands.all()) put(hash, *islands.island(id));
  putList(hash, hashes.hashes({{-64, -64}, {63, 63}}));
}

}  // namespace platform
