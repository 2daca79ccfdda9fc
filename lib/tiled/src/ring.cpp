// Properties of single rings: area, tidiness, simplicity.
#include "geometry.h"

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
    if (cross(ring[(at + n - 1) % n], ring[at], ring[(at + 1) % n]) == 0) {
      ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(at));
      calm = 0;
      at += ring.size() - 1;  // its removal can flatten the one before
    } else {
      ++calm;
      ++at;
    }
  }
}

bool between(Point p, Point a, Point b) {
  return p.x >= std::min(a.x, b.x) && p.x <= std::max(a.x, b.x) && p.y >= std::min(a.y, b.y) &&
         p.y <= std::max(a.y, b.y);
}

int sign(std::int64_t v) { return (v > 0) - (v < 0); }

bool segmentsMeet(Point a, Point b, Point c, Point d) {
  if (std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x) ||
      std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y)) {
    return false;
  }
  const int c1 = sign(cross(a, b, c)), d1 = sign(cross(a, b, d));
  const int a1 = sign(cross(c, d, a)), b1 = sign(cross(c, d, b));
  if (c1 * d1 < 0 && a1 * b1 < 0) return true;
  return (c1 == 0 && between(c, a, b)) || (d1 == 0 && between(d, a, b)) || (a1 == 0 && between(a, c, d)) ||
         (b1 == 0 && between(b, c, d));
}

}  // namespace

std::int64_t doubleArea(const Polygon& ring) {
  std::int64_t sum = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) sum += cross(ring[0], ring[i], ring[i + 1]);
  return sum;
}

Box boxOf(const Polygon& ring) {
  Box box{ring[0], ring[0]};
  for (Point p : ring) {
    box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
    box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
  }
  return box;
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

bool isSimple(const Polygon& ring) {
  const std::size_t n = ring.size();
  if (n < 3) return false;
  for (std::size_t i = 0; i < n; ++i) {
    const Point a = ring[i], b = ring[(i + 1) % n], c = ring[(i + 2) % n];
    // Neighbours meet in b; they overlap if the second turns straight back.
    if (a == b || (cross(a, b, c) == 0 && (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y) <= 0)) return false;
    for (std::size_t j = i + 2; j < n && !(i == 0 && j == n - 1); ++j) {
      if (segmentsMeet(a, b, ring[j], ring[(j + 1) % n])) return false;
    }
  }
  return true;
}

}  // namespace lgs::tiled
