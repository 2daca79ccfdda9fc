#include "bench/published/published_lattice.h"

#include <algorithm>
#include <cmath>

namespace lgs::bench {
namespace {

std::optional<Point> toLattice(const std::optional<Vec2>& v) { return v ? std::optional(toLattice(*v)) : std::nullopt; }

}  // namespace

Point toLattice(Vec2 v) {
  const auto round = [](float c) { return std::llround(double{c} * kUnitsPerCell); };
  return {round(v.x), round(v.y)};
}

std::vector<Vec2> floatVertices(const oracle::ScenePolygon& polygon) {
  std::vector<Vec2> out;
  for (const LocalPoint v : polygon.vertices) {
    const Point p = toWorld(polygon.cell, v);
    out.push_back({static_cast<float>(static_cast<double>(p.x) / kUnitsPerCell),
                   static_cast<float>(static_cast<double>(p.y) / kUnitsPerCell)});
  }
  return out;
}

oracle::Outline outlineOf(const Published& published) {
  oracle::Outline out;
  published.forEachSegment([&](const PublishedSegment& s) {
    out.push_back({toLattice(s.start), toLattice(s.end), s.ogBlock, toLattice(s.ghost1), toLattice(s.ghost2)});
  });
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace lgs::bench
