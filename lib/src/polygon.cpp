#include "polygon.h"

#include "geometry/relation.h"
#include "geometry/simple.h"
#include "geometry/sort.h"

#include <lgs/world.h>

#include <vector>

namespace lgs::detail {
namespace {

std::int32_t index(std::size_t i) { return static_cast<std::int32_t>(i); }

bool isInsideCell(LocalPoint p) { return p.x >= 0 && p.x <= kUnitsPerCell && p.y >= 0 && p.y <= kUnitsPerCell; }

std::optional<Defect> findRepeatedVertex(PolygonView p) {
  std::vector<std::int32_t> order(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) order[i] = index(i);
  const auto at = [&](std::int32_t i) { return p[static_cast<std::size_t>(i)]; };
  detail::sort(order, [&](auto a, auto b) { return at(a) != at(b) ? at(a) < at(b) : a < b; });
  std::optional<Defect> first;
  for (std::size_t k = 1; k < order.size(); ++k) {
    if (at(order[k - 1]) != at(order[k])) continue;
    if (!first || order[k] < first->vertex2) first = Defect{ErrorCode::repeatedVertex, order[k - 1], order[k]};
  }
  return first;
}

}  // namespace

std::optional<Defect> findDefect(PolygonView polygon) {
  if (polygon.size() < 3) return Defect{ErrorCode::tooFewVertices};
  if (polygon.size() > kMaxVerticesPerCell) return Defect{ErrorCode::capacity};
  for (std::size_t i = 0; i < polygon.size(); ++i)
    if (!isInsideCell(polygon[i])) return Defect{ErrorCode::outsideCell, index(i)};
  if (!isSimple(polygon)) {  // only then it takes long to say why
    if (const auto repeated = findRepeatedVertex(polygon)) return repeated;
    if (doubleArea(polygon) == 0) return Defect{ErrorCode::zeroArea};
    if (const auto edges = findSelfIntersection(polygon))
      return Defect{ErrorCode::selfIntersecting, index(edges->first), index(edges->second)};
  }
  if (doubleArea(polygon) < 0) return Defect{ErrorCode::clockwise};
  return std::nullopt;
}

bool interiorsMeet(PolygonView p, PolygonView q) { return relation(p, q) != Relation::apart; }

}  // namespace lgs::detail
