// How much ground there is, for games that must neither double nor lose any.
#pragma once

#include <lgs/world.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace lgs::test {

/// Twice the area of polygons, in lattice units: exact.
inline std::int64_t areaOf(std::span<const LocalPoint> vertices) {
  std::int64_t sum = 0;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const LocalPoint a = vertices[k], b = vertices[(k + 1) % vertices.size()];
    sum += std::int64_t{a.x} * b.y - std::int64_t{a.y} * b.x;
  }
  return sum;
}
inline std::int64_t areaOf(const World& world) {
  std::int64_t sum = 0;
  world.forEachPolygon([&](Cell, const PlacedPolygon& p) { sum += areaOf(p.vertices); });
  return sum;
}

}  // namespace lgs::test
