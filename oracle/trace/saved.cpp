#include "oracle/trace/saved.h"

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

namespace lgs::oracle {

Trace traceOf(const World& world) {
  std::vector<std::pair<Cell, PlacedPolygon>> all;
  world.forEachPolygon([&](Cell cell, const PlacedPolygon& polygon) { all.emplace_back(cell, polygon); });
  std::ranges::sort(all, {}, [](const auto& p) { return std::tuple(p.first.j, p.first.i, p.second.handle); });
  Trace trace;
  for (const auto& [cell, polygon] : all) {
    trace.calls.push_back(Call::add("p" + std::to_string(trace.calls.size() + 1),
                                    {cell, polygon.block, {polygon.vertices.begin(), polygon.vertices.end()}}));
  }
  trace.calls.push_back(Call::commit());
  return trace;
}

}  // namespace lgs::oracle
