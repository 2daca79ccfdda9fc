#include "oracle/views/named_islands.h"

#include "oracle/reference/touching.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

namespace lgs::oracle {
namespace {

void say(const char* what, const NamedIslands& ones, const NamedIslands& others, std::string& text) {
  NamedIslands alone;
  std::ranges::set_difference(ones, others, std::back_inserter(alone));
  for (const auto& [west, doubleArea] : alone)
    text += fmt::format("{} island: westernmost vertex ({}, {}) in units, twice its area {}\n", what, west.x, west.y,
                        doubleArea);
}

}  // namespace

NamedIslands namedIslands(const Scene& scene) {
  const std::vector<std::size_t> set = setsOf(scene.polygons);
  std::map<std::size_t, NamedIsland> islands;
  for (std::size_t k = 0; k < set.size(); ++k) {
    const ScenePolygon& p = scene.polygons[k];
    const auto [entry, isNew] = islands.try_emplace(set[k]);
    NamedIsland& island = entry->second;
    if (isNew) island.west = toWorld(p.cell, p.vertices.front());
    for (std::size_t v = 0; v < p.vertices.size(); ++v) {
      const LocalPoint a = p.vertices[v], b = p.vertices[(v + 1) % p.vertices.size()];
      island.west = std::min(island.west, toWorld(p.cell, a));
      island.doubleArea += std::int64_t{a.x} * b.y - std::int64_t{a.y} * b.x;
    }
  }
  NamedIslands out;
  for (const auto& [index, island] : islands) out.push_back(island);
  std::ranges::sort(out);
  return out;
}

std::string describeIslands(const NamedIslands& expected, const NamedIslands& actual) {
  std::string text;
  say("missing", expected, actual, text);
  say("extra", actual, expected, text);
  return text;
}

}  // namespace lgs::oracle
