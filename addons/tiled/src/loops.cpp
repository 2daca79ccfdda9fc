#include "loops.h"

#include <algorithm>
#include <cstdint>
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

namespace {

/// What two segments have in common, the least first.
enum class Contact : std::uint8_t { nothing, point, line };

Contact contact(const Polygon& ring, std::size_t i, std::size_t j) {
  const Point a = ring[i], b = nextVertex(ring, i), c = ring[j], d = nextVertex(ring, j);
  if (!segmentsMeet(a, b, c, d)) return Contact::nothing;
  if (cross(b - a, d - c) != 0) return Contact::point;
  const Point low = std::max(std::min(a, b), std::min(c, d)), high = std::min(std::max(a, b), std::max(c, d));
  return low == high ? Contact::point : Contact::line;
}

}  // namespace

bool collapses(const Polygon& drawn, const Polygon& snapped) {
  std::vector<std::size_t> edges;  // that still have a length
  for (std::size_t i = 0; i < snapped.size(); ++i) {
    if (snapped[i] != nextVertex(snapped, i)) edges.push_back(i);
  }
  if (edges.empty()) return true;
  for (std::size_t p = 0; p < edges.size(); ++p) {
    for (std::size_t q = p + 1; q < edges.size(); ++q) {
      const Contact now = contact(snapped, edges[p], edges[q]);
      if (now == Contact::nothing) continue;
      const bool areNeighbours = q == p + 1 || (p == 0 && q + 1 == edges.size());
      const Contact before = contact(drawn, edges[p], edges[q]);
      if (now > std::max(before, areNeighbours ? Contact::point : Contact::nothing)) return true;
    }
  }
  return false;
}

}  // namespace lgs::tiled
