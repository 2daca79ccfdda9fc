// Clipper 6 as a shared object for `lgs check --engine-so`: it unites all polygons anew at each commit.
//
// Ghosts are the neighbours in the ring. They are not the laws' where rings touch, so `ghosts` is not promised.
#include <lgs/lattice.h>
#include <lgs/lgs_engine.h>

#include <polyclipping/clipper.hpp>

#include <map>
#include <string>

namespace {

using ClipperLib::Path;
using Polygons = std::map<std::string, Path>;  // by name: the whole engine

Polygons& polygonsOf(void* self) { return *static_cast<Polygons*>(self); }

void* create() { return new Polygons; }
void destroy(void* self) { delete &polygonsOf(self); }
void reset(void* self) { polygonsOf(self).clear(); }
void preserve(void*, std::uint32_t, std::uint32_t) {}
void remove(void* self, const char* name) { polygonsOf(self).erase(name); }

void add(void* self, const char* name, std::int32_t i, std::int32_t j, std::uint32_t, const std::int32_t* xy,
         std::size_t vertices) {
  Path& polygon = polygonsOf(self)[name];
  for (std::size_t k = 0; k < vertices; ++k) {
    const lgs::Point at = lgs::toWorld({i, j}, {xy[2 * k], xy[2 * k + 1]});
    polygon.emplace_back(at.x, at.y);
  }
}

// Outer rings are counter-clockwise, holes clockwise: the solid is on the left.
void tell(const Path& ring, const lgs_engine_answer* answer) {
  for (std::size_t k = 0, n = ring.size(); k < n; ++k) {
    const auto &before = ring[(k + n - 1) % n], &a = ring[k], &b = ring[(k + 1) % n], &after = ring[(k + 2) % n];
    const lgs_engine_segment segment{{a.X, a.Y}, {b.X, b.Y}, {before.X, before.Y}, {after.X, after.Y}, 0, 0};
    answer->segments(answer->to, &segment, 1);
  }
}

void commit(void* self, const lgs_engine_answer* answer) {
  ClipperLib::Clipper clipper;
  for (const auto& [name, polygon] : polygonsOf(self)) clipper.AddPath(polygon, ClipperLib::ptSubject, true);
  ClipperLib::Paths united;
  clipper.Execute(ClipperLib::ctUnion, united, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  for (const Path& ring : united) tell(ring, answer);
}

}  // namespace

extern "C" const lgs_engine_table* lgs_engine() {
  static const lgs_engine_table kTable{
      LGS_ENGINE_VERSION, "Clipper", "several slants merged", create, destroy, reset, preserve, add, remove, commit};
  return &kTable;
}
