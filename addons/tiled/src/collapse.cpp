#include "collapse.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace lgs::tiled {
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
