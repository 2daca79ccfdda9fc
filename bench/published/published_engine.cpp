#include "bench/published/published_engine.h"

#include "bench/published/published_lattice.h"

#include <algorithm>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>

namespace lgs::bench {
namespace {

using Pair = std::pair<Block, Block>;

Pair pairOf(Block a, Block b) { return {std::min(a, b), std::max(a, b)}; }

struct Placed {
  Cell cell;
  std::vector<Vec2> vertices;
  Block block = 0;
};

struct World {
  std::set<Pair> preserve;
  Published published{[this](Block a, Block b) { return preserve.contains(pairOf(a, b)); }};
  std::unordered_map<std::string, Placed> placed;
};

// A world that is reset is another one.
struct Self {
  std::optional<World> world;
};

World& worldOf(void* self) { return *static_cast<Self*>(self)->world; }

void* create() { return new Self; }

void destroy(void* self) { delete static_cast<Self*>(self); }

void reset(void* self) { static_cast<Self*>(self)->world.emplace(); }

void preserve(void* self, std::uint32_t b1, std::uint32_t b2) { worldOf(self).preserve.insert(pairOf(b1, b2)); }

void add(void* self, const char* name, std::int32_t i, std::int32_t j, std::uint32_t block, const std::int32_t* xy,
         std::size_t vertices) {
  oracle::ScenePolygon polygon{{i, j}, block, {}};
  for (std::size_t k = 0; k < vertices; ++k) polygon.vertices.push_back({xy[2 * k], xy[2 * k + 1]});
  World& world = worldOf(self);
  const Placed& placed = world.placed[name] = {polygon.cell, floatVertices(polygon), block};
  world.published.add(placed.cell, placed.vertices, block);
}

void remove(void* self, const char* name) {
  World& world = worldOf(self);
  const auto found = world.placed.find(name);
  if (found == world.placed.end()) return;
  const Placed& placed = found->second;
  world.published.remove(placed.cell, placed.vertices, placed.block);
  world.placed.erase(found);
}

void commit(void* self, const lgs_engine_answer* answer) {
  Published& published = worldOf(self).published;
  published.compute();
  for (const oracle::OutlineSegment& s : outlineOf(published)) {
    const Point ghost1 = s.ghost1.value_or(Point()), ghost2 = s.ghost2.value_or(Point());
    const std::uint32_t missing = (s.ghost1 ? 0U : 1U) | (s.ghost2 ? 0U : 2U);
    const lgs_engine_segment segment{
        {s.start.x, s.start.y}, {s.end.x, s.end.y}, {ghost1.x, ghost1.y}, {ghost2.x, ghost2.y}, s.block, missing};
    answer->segments(answer->to, &segment, 1);
  }
}

}  // namespace

const lgs_engine_table* publishedEngine() {
  static const lgs_engine_table kTable{LGS_ENGINE_VERSION,
                                       "published",
                                       "ghosts blocks several slants preserve",
                                       create,
                                       destroy,
                                       reset,
                                       preserve,
                                       add,
                                       remove,
                                       commit};
  return &kTable;
}

}  // namespace lgs::bench
