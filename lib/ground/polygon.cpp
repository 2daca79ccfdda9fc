#include "ground/polygon.h"

#include "geometry/relation.h"
#include "geometry/simple.h"
#include "geometry/sort.h"

#include <lgs/world.h>

#include <vector>

namespace lgs::detail {
namespace {

/// So few vertices are compared in pairs sooner than they are sorted.
constexpr std::size_t kSmall = 12;

std::int32_t index(std::size_t i) { return static_cast<std::int32_t>(i); }

bool isInsideCell(LocalPoint p) { return p.x >= 0 && p.x <= kUnitsPerCell && p.y >= 0 && p.y <= kUnitsPerCell; }

std::optional<Defect> findRepeatedVertex(std::span<const PlacedVertex> order) {
  std::optional<Defect> first;
  for (std::size_t k = 1; k < order.size(); ++k) {
    const auto earlier = static_cast<std::int32_t>(indexOf(order[k - 1]));
    const auto later = static_cast<std::int32_t>(indexOf(order[k]));
    if (!isSamePoint(order[k - 1], order[k])) continue;
    if (!first || later < first->vertex2) first = Defect{ErrorCode::repeatedVertex, earlier, later};
  }
  return first;
}

}  // namespace

void inOrder(std::span<const PolygonView> polygons, std::vector<PlacedVertex>& order) {
  static_assert(kMaxVerticesPerCell == 1u << 12);
  order.clear();
  for (const PolygonView polygon : polygons) {
    for (const LocalPoint p : polygon)
      order.push_back(static_cast<std::uint64_t>(p.x) << 32 | static_cast<std::uint64_t>(p.y) << 12 | order.size());
  }
  detail::sort(order);
}

std::optional<Defect> findDefect(PolygonView polygon) {
  if (polygon.size() < 3) return Defect{ErrorCode::tooFewVertices};
  if (polygon.size() > kMaxVerticesPerCell) return Defect{ErrorCode::capacity};
  for (std::size_t i = 0; i < polygon.size(); ++i)
    if (!isInsideCell(polygon[i])) return Defect{ErrorCode::outsideCell, index(i)};
  const bool isSmall = polygon.size() <= kSmall;
  if (!isSmall || findSelfIntersection(polygon)) {
    std::vector<PlacedVertex> order;
    order.reserve(polygon.size());
    inOrder({&polygon, 1}, order);
    if (const auto repeated = findRepeatedVertex(order)) return repeated;
    for (std::uint64_t& vertex : order) vertex = indexOf(vertex);
    if (isSmall || !isSimple(polygon, order)) {
      if (doubleArea(polygon) == 0) return Defect{ErrorCode::zeroArea};
      if (const auto edges = findSelfIntersection(polygon))
        return Defect{ErrorCode::selfIntersecting, index(edges->first), index(edges->second)};
    }
  }
  if (doubleArea(polygon) < 0) return Defect{ErrorCode::clockwise};
  return std::nullopt;
}

bool interiorsMeet(PolygonView p, PolygonView q) { return relation(p, q) != Relation::apart; }

}  // namespace lgs::detail
