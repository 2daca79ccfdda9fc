#include "walk.h"

#include "geometry/sort.h"
#include "rings.h"

#include <algorithm>
#include <tuple>
#include <unordered_set>

namespace lgs::detail {

std::optional<Standing> ownerOf(const World& world, const Segment& segment) {
  for (const PlacedPolygon& p : world.polygons(segment.cell)) {
    const bool owns = anyEdge(ringOf(segment.cell, p.vertices), [&](Point a, Point b) {
      return isOnSegment(segment.start, a, b) && isOnSegment(segment.end, a, b) &&
             sameDirection(b - a, segment.end - segment.start);
    });
    if (owns) return Standing{segment.cell, p};
  }
  return std::nullopt;
}

const std::vector<Standing>& Walk::from(const World& world, const Standing& start, Contact contact) {
  found_.assign(1, start);
  // Not kept: to clear it costs as much as the largest walk so far.
  std::unordered_set<PolygonHandle> seen{start.polygon.handle};
  for (std::size_t k = 0; k < found_.size(); ++k) {
    const Standing here = found_[k];
    const WorldRing ring = ringOf(here.cell, here.polygon.vertices);
    for (std::int32_t j = here.cell.j - 1; j <= here.cell.j + 1; ++j) {
      for (std::int32_t i = here.cell.i - 1; i <= here.cell.i + 1; ++i) {
        world.polygons({i, j}, held_);
        for (const PlacedPolygon& p : held_) {
          if (seen.contains(p.handle)) continue;
          const WorldRing other = ringOf({i, j}, p.vertices);
          if (contact == Contact::point ? !touch(ring, other) : !shareAnEdge(ring, other)) continue;
          seen.insert(p.handle);
          found_.push_back({{i, j}, p});
        }
      }
    }
  }
  walked_ += found_.size();
  detail::sort(found_, [](const Standing& a, const Standing& b) {
    return std::tuple(a.cell.j, a.cell.i, a.polygon.handle) < std::tuple(b.cell.j, b.cell.i, b.polygon.handle);
  });
  return found_;
}

}  // namespace lgs::detail
