// Scenes and outlines written down in cells, for tests that work them out by hand.
#pragma once

#include "oracle/reference/compare.h"
#include "oracle/reference/outline.h"
#include "oracle/reference/scene.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace lgs::oracle {

using At = std::pair<double, double>;

inline std::int64_t units(double inCells) { return std::llround(inCells * kUnitsPerCell); }
inline Point point(At p) { return {units(p.first), units(p.second)}; }

inline ScenePolygon polygon(Cell cell, Block block, std::initializer_list<At> vertices) {
  ScenePolygon result{cell, block, {}};
  for (const auto& [x, y] : vertices) {
    result.vertices.push_back({static_cast<std::int32_t>(units(x)), static_cast<std::int32_t>(units(y))});
  }
  return result;
}

inline ScenePolygon square(Cell cell, Block block = 0) {
  return polygon(cell, block, {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
}

// A closed chain: each segment linked to the one before and the one after it. `blocks` gives each segment's block, the
// last one also all that follow.
inline Outline chain(std::vector<At> vertices, std::vector<Block> blocks = {0}) {
  const std::size_t n = vertices.size();
  Outline result;
  for (std::size_t k = 0; k < n; ++k) {
    result.push_back({point(vertices[k]), point(vertices[(k + 1) % n]), blocks[std::min(k, blocks.size() - 1)],
                      point(vertices[(k + n - 1) % n]), point(vertices[(k + 2) % n])});
  }
  return result;
}

inline Outline together(const std::vector<Outline>& parts) {
  Outline result;
  for (const Outline& part : parts) result.insert(result.end(), part.begin(), part.end());
  std::sort(result.begin(), result.end());
  return result;
}

inline std::string differences(const Outline& expected, const Outline& actual) {
  return describe(compare(expected, actual));
}

}  // namespace lgs::oracle
