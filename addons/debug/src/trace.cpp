#include <lgs/debug.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <tuple>
#include <vector>

namespace lgs {
namespace {

/// In cells: a fraction with the least denominator, which is a power of two.
std::string inCells(std::int32_t units) {
  const std::int32_t common = std::gcd(units, kUnitsPerCell);
  const std::string whole = std::to_string(units / common);
  return common == kUnitsPerCell ? whole : whole + "/" + std::to_string(kUnitsPerCell / common);
}

struct Placed {
  Cell cell;
  PlacedPolygon polygon;
};

std::vector<Placed> inOrder(const World& world) {
  std::vector<Placed> all;
  world.forEachPolygon([&](Cell cell, const PlacedPolygon& polygon) { all.push_back({cell, polygon}); });
  std::ranges::sort(all, {}, [](const Placed& p) { return std::tuple(p.cell.j, p.cell.i, p.polygon.handle); });
  return all;
}

std::string preserveLines(const PreserveRelation& preserve, const std::vector<Placed>& all) {
  std::string lines;
  if (!preserve) return lines;
  std::set<Block> blocks;
  for (const Placed& p : all) blocks.insert(p.polygon.block);
  for (auto a = blocks.begin(); a != blocks.end(); ++a)
    for (auto b = a; b != blocks.end(); ++b)
      if (preserve(*a, *b)) lines += "preserve " + std::to_string(*a) + " " + std::to_string(*b) + "\n";
  return lines;
}

}  // namespace

std::string writeTrace(const World& world) {
  const std::vector<Placed> all = inOrder(world);
  std::string trace = "lgs-trace 1\n" + preserveLines(world.preserveRelation(), all);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const auto& [cell, polygon] = all[k];
    trace += "add p" + std::to_string(k + 1) + " " + std::to_string(cell.i) + " " + std::to_string(cell.j) + " " +
             std::to_string(polygon.block) + " ";
    for (const LocalPoint v : polygon.vertices) trace += " " + inCells(v.x) + " " + inCells(v.y);
    trace += "\n";
  }
  return trace;
}

}  // namespace lgs
