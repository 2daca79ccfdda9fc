// Much at once, in a copy of a world: many contents and segments come and go, and a place is left. What was there before
// stays as it was.
#include "fuzz/beside.h"
#include "fuzz/same.h"
#include "fuzz/units.h"

#include <algorithm>

namespace lgs::fuzz {
namespace {

using oracle::Random;

std::string saveAndLoad(World& world) {
  const std::vector<std::byte> bytes = saved(world);
  if (bytes.empty()) return "a world can not be saved";
  auto loaded = World::load(bytes, world.preserveRelation());
  if (!loaded) return "a world that was saved can not be loaded: " + message(loaded.error());
  std::string wrong = differenceOf(world, *loaded);
  world = std::move(*loaded);
  return wrong.empty() ? wrong : "a world that was saved comes back with " + wrong;
}

/// Chunks in a place where nothing else is.
CellRect emptyPlace(const World& world) {
  const CellRect all = world.bounds().value_or(CellRect{});
  const std::int32_t i = all.max.i < kMaxCell / 2 ? ((all.max.i | (kChunkSide - 1)) + 1 + kChunkSide)
                                                  : (all.min.i & -kChunkSide) - 4 * kChunkSide;
  const std::int32_t j = std::clamp(all.min.j, -kMaxCell / 2, kMaxCell / 2) & -kChunkSide;
  return {{i, j}, {i + 2 * kChunkSide - 1, j + 2 * kChunkSide - 1}};
}

/// So many segments that pages of them are given back; on every second cell, so that none is hidden.
std::string comeAndGo(World& world, const CellRect& cells) {
  Follower follower(world);
  const auto square = world.shape(kUnitSquare);
  for (std::int32_t j = cells.min.j; j <= cells.max.j; ++j)
    for (std::int32_t i = cells.min.i + (j & 1); i <= cells.max.i; i += 2)
      if (!world.add({i, j}, *square, 1)) return "an empty cell takes no square";
  if (std::string wrong = follower.follow(world, world.commit()); !wrong.empty()) return wrong;
  const auto count = world.clear(cells);
  if (!count || *count != world.segments(cells).size() / 4) return "squares apart have other than four segments";
  return follower.follow(world, world.commit());
}

/// More contents than are kept for later.
std::string wear(World& world, Cell cell) {
  std::uint64_t most = 0;
  for (std::int32_t k = 0; k < 2'300; ++k) {
    const auto placed = world.add(cell, {{0, 0}, {U, 0}, {U / 2, 1 + k}}, 1);
    if (!placed || !world.remove(*placed)) return "a triangle can not come and go";
    most = std::max(most, k % 256 == 0 ? world.stats().contents : 0);
  }
  world.commit();
  return most < 2'000 ? "" : "contents that no cell has are not forgotten";
}

}  // namespace

std::string crowdAndLeave(const World& world, Random& random) {
  World twin = builtAnew(world);
  twin.commit();
  const World before = twin;
  const CellRect place = emptyPlace(twin);
  if (std::string wrong = random.chance(50) ? comeAndGo(twin, place) : wear(twin, place.min); !wrong.empty())
    return wrong;
  const auto gone = twin.forgetChunks(place);
  if (!gone || *gone == 0) return "a place that was left is not forgotten";
  if (!samePolygons(before, twin)) return "who comes and goes leaves other polygons";
  if (std::string wrong = saveAndLoad(twin); !wrong.empty()) return wrong;
  // What a world unloads and forgets comes back in another one.
  std::vector<std::vector<std::byte>> chunks;
  const CellRect all{{-kMaxCell, -kMaxCell}, {kMaxCell, kMaxCell}};
  if (!twin.unload(all, [&](Cell, auto bytes) { chunks.emplace_back(bytes.begin(), bytes.end()); }))
    return "a world can not be unloaded";
  twin.commit();
  if (!twin.segments().empty() || !twin.firstUnloaded(all) != chunks.empty()) return "an unloaded world shows segments";
  const auto forgotten = twin.forgetChunks(all);
  if (!forgotten || *forgotten != chunks.size() || twin.stats().chunks != 0) return "unloaded chunks are not forgotten";
  World other(world.preserveRelation());
  for (World* w : {&twin, &other}) {
    random.shuffle(chunks);
    for (const auto& chunk : chunks)
      if (const auto back = w->reload(chunk); !back) return "a chunk does not come back: " + message(back.error());
    w->commit();
    if (!samePolygons(before, *w)) return "what was unloaded comes back as other polygons";
    if (std::string wrong = differenceByLaws(*w); !wrong.empty()) return wrong;
    if (std::string wrong = saveAndLoad(*w); !wrong.empty()) return wrong;
  }
  return "";
}

}  // namespace lgs::fuzz
