#include "loops.h"

#include <algorithm>
#include <map>
#include <utility>

namespace lgs::tiled {
namespace {

/// Removes vertices that repeat, lie on a straight line between their neighbours, or are the tip of a spike.
void dropFlatVertices(Polygon& ring) {
  std::size_t calm = 0;  // vertices in a row that stay
  std::size_t at = 0;
  while (ring.size() >= 3 && calm < ring.size()) {
    const std::size_t n = ring.size();
    at %= n;
    if (orientation(ring[(at + n - 1) % n], ring[at], ring[(at + 1) % n]) == 0) {
      ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(at));
      calm = 0;
      at += ring.size() - 1;  // its removal can flatten the one before
    } else {
      ++calm;
      ++at;
    }
  }
}

}  // namespace

std::size_t crossings(const Polygon& a, const Polygon& b, std::size_t most) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size() && count <= most; ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) count += crossProperly(a[i], nextVertex(a, i), b[j], nextVertex(b, j));
  }
  return count;
}

Polygon ringOf(std::span<const LocalPoint> vertices) {
  Polygon ring;
  for (const LocalPoint v : vertices) ring.push_back({v.x, v.y});
  return ring;
}

std::vector<LocalPoint> localRing(const Polygon& ring) {
  std::vector<LocalPoint> vertices;
  for (const Point p : ring) vertices.push_back({static_cast<std::int32_t>(p.x), static_cast<std::int32_t>(p.y)});
  return vertices;
}

std::vector<Polygon> tidyLoops(Polygon ring) {
  std::vector<Polygon> loops;
  std::vector<Polygon> todo{std::move(ring)};
  while (!todo.empty()) {
    Polygon current = std::move(todo.back());
    todo.pop_back();
    dropFlatVertices(current);
    if (current.size() < 3) continue;
    std::map<Point, std::size_t> seen;
    std::size_t again = 0;  // the first vertex that was there before
    while (again < current.size() && seen.emplace(current[again], again).second) ++again;
    if (again == current.size()) {
      loops.push_back(std::move(current));
      continue;
    }
    const auto from = current.begin() + static_cast<std::ptrdiff_t>(seen[current[again]]);
    const auto to = current.begin() + static_cast<std::ptrdiff_t>(again);
    Polygon loop(from, to);
    current.erase(from, to);
    todo.push_back(std::move(current));
    todo.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace lgs::tiled
