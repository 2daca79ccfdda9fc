// This library's engine as a shared object for `lgs check --engine-so`: an example of an adapter in C++.
#include <lgs/lgs_engine.h>
#include <lgs/world.h>

#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace {

struct Engine {
  std::set<std::pair<lgs::Block, lgs::Block>> preserved;
  lgs::World world;
  std::unordered_map<std::string, lgs::PolygonHandle> handles;
  std::vector<std::pair<std::string, std::string>> refused;  // names and reasons
};

Engine& engineOf(void* self) { return *static_cast<Engine*>(self); }

void* create() { return new Engine; }
void destroy(void* self) { delete &engineOf(self); }
void reset(void* self) { engineOf(self) = Engine(); }

void preserve(void* self, std::uint32_t b1, std::uint32_t b2) {
  auto& [pairs, world, handles, refused] = engineOf(self);
  pairs.insert(std::minmax(b1, b2));
  world = lgs::World([known = pairs](lgs::Block a, lgs::Block b) { return known.contains(std::minmax(a, b)); });
}

void add(void* self, const char* name, std::int32_t i, std::int32_t j, std::uint32_t block, const std::int32_t* xy,
         std::size_t vertices) {
  auto& [pairs, world, handles, refused] = engineOf(self);
  std::vector<lgs::LocalPoint> points;
  for (std::size_t k = 0; k < vertices; ++k) points.push_back({xy[2 * k], xy[2 * k + 1]});
  const auto handle = world.add({i, j}, points, block);
  handle ? void(handles[name] = *handle) : refused.push_back({name, lgs::message(handle.error())});
}

void remove(void* self, const char* name) {
  auto& [pairs, world, handles, refused] = engineOf(self);
  if (const auto done = world.remove(handles[name]); !done) refused.push_back({name, lgs::message(done.error())});
}

void commit(void* self, const lgs_engine_answer* answer) {
  Engine& engine = engineOf(self);
  for (const auto& [name, reason] : std::exchange(engine.refused, {}))
    answer->refused(answer->to, name.c_str(), reason.c_str());
  const lgs::Changes& changes = engine.world.commit();
  const auto tell = [&](char sign, lgs::SegmentId id) {
    const lgs::Segment s = *engine.world.segment(id);
    const std::uint32_t missing = (s.predecessor ? 0U : 1U) | (s.successor ? 0U : 2U);
    const lgs_engine_segment told{{s.start.x, s.start.y},
                                  {s.end.x, s.end.y},
                                  {s.ghost1.x, s.ghost1.y},
                                  {s.ghost2.x, s.ghost2.y},
                                  s.block,
                                  missing};
    answer->changed(answer->to, sign, id.value, &told);
  };
  for (const lgs::SegmentId id : changes.removed) answer->changed(answer->to, '-', id.value, nullptr);
  for (const lgs::SegmentId id : changes.added) tell('+', id);
  for (const lgs::SegmentId id : changes.relinked) tell('~', id);
}

}  // namespace

extern "C" const lgs_engine_table* lgs_engine() {
  static const char* const kCan = "ghosts blocks several slants preserve refuses delta";
  static const lgs_engine_table kTable{
      LGS_ENGINE_VERSION, "LocalGridSeg", kCan, create, destroy, reset, preserve, add, remove, commit};
  return &kTable;
}
