#include "oracle/cgal/partition.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>

namespace lgs::oracle {
namespace partition {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using PolygonSet = CGAL::Polygon_set_2<Kernel>;
using Polygon = PolygonSet::Polygon_2;

Polygon toCgal(const LocalPolygon& polygon) {
  Polygon out;
  for (const LocalPoint p : polygon) out.push_back({p.x, p.y});
  return out;
}

PolygonSet united(const std::vector<LocalPolygon>& polygons) {
  std::vector<Polygon> list;
  for (const LocalPolygon& p : polygons) list.push_back(toCgal(p));
  PolygonSet set;
  set.join(list.begin(), list.end());
  return set;
}

/// The pieces lie one beside the other if their areas add up to that of what they cover.
std::optional<std::string> fault(const PieceList& pieces, const PolygonSet& whole, const Kernel::FT& area) {
  Kernel::FT sum = 0;
  for (const LocalPolygon& piece : pieces) {
    const Polygon polygon = toCgal(piece);
    if (!polygon.is_simple()) return "a piece is not simple";
    if (!polygon.is_counterclockwise_oriented()) return "a piece runs clockwise";
    if (!polygon.is_convex()) return "a piece is not convex";
    sum += polygon.area();
  }
  PolygonSet difference = united(pieces);
  difference.symmetric_difference(whole);
  if (!difference.is_empty()) return "the pieces do not make up the whole";
  if (sum != area) return "the interiors of two pieces meet";
  return std::nullopt;
}

}  // namespace
}  // namespace partition

std::optional<std::string> notAPartition(const std::vector<LocalPolygon>& polygons, const std::vector<PieceList>& solid,
                                         const PieceList& free) {
  constexpr std::int32_t U = kUnitsPerCell;
  const LocalPolygon cell{{0, 0}, {U, 0}, {U, U}, {0, U}};
  partition::Kernel::FT left = partition::toCgal(cell).area();
  for (std::size_t k = 0; k < polygons.size(); ++k) {
    const partition::Kernel::FT area = partition::toCgal(polygons[k]).area();
    left -= area;
    if (const auto fault = partition::fault(solid[k], partition::united({polygons[k]}), area))
      return "of polygon " + std::to_string(k) + ": " + *fault;
  }
  partition::PolygonSet rest = partition::united({cell});
  rest.difference(partition::united(polygons));
  if (const auto fault = partition::fault(free, rest, left)) return "of the free part: " + *fault;
  return std::nullopt;
}

}  // namespace lgs::oracle
