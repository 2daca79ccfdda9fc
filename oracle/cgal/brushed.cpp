#include "oracle/cgal/brushed.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>
#include <CGAL/Polygon_vertical_decomposition_2.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <sstream>

namespace lgs::oracle {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using PolygonSet = CGAL::Polygon_set_2<Kernel>;
using Polygon = PolygonSet::Polygon_2;
using WithHoles = PolygonSet::Polygon_with_holes_2;
using Segments = std::vector<Kernel::Segment_2>;

Kernel::Point_2 toCgal(Point p) { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }

std::vector<WithHoles> parts(const PolygonSet& set) {
  std::vector<WithHoles> result;
  set.polygons_with_holes(std::back_inserter(result));
  return result;
}

Polygon polygonOf(const ScenePolygon& p) {
  Polygon polygon;
  for (const LocalPoint v : p.vertices) polygon.push_back(toCgal(toWorld(p.cell, v)));
  return polygon;
}

std::map<Block, PolygonSet> byBlock(const Scene& scene) {
  std::map<Block, PolygonSet> sets;
  for (const ScenePolygon& p : scene.polygons) sets[p.block].join(polygonOf(p));
  return sets;
}

PolygonSet united(const std::map<Block, PolygonSet>& blocks) {
  PolygonSet result;
  for (const auto& [block, set] : blocks) result.join(set);
  return result;
}

// A point is inside a ring if an odd number of the triangles from the ring's first vertex to its edges cover it.
PolygonSet regionOf(const BrushEdit& edit) {
  PolygonSet region;
  for (const std::vector<Point>& ring : edit.rings) {
    if (!edit.isEvenOdd) {
      Polygon polygon;
      for (const Point p : ring) polygon.push_back(toCgal(p));
      region.join(polygon);
      continue;
    }
    for (std::size_t k = 1; k + 1 < ring.size(); ++k) {
      Polygon triangle;
      for (const Point p : {ring[0], ring[k], ring[k + 1]}) triangle.push_back(toCgal(p));
      if (CGAL::orientation(triangle[0], triangle[1], triangle[2]) == CGAL::COLLINEAR) continue;
      if (triangle.is_clockwise_oriented()) triangle.reverse_orientation();
      region.symmetric_difference(triangle);
    }
  }
  return region;
}

std::map<Block, PolygonSet> exactResult(const Scene& before, const BrushEdit& edit) {
  std::map<Block, PolygonSet> blocks = byBlock(before);
  PolygonSet region = regionOf(edit);
  for (const Block block : edit.staying) region.difference(blocks[block]);
  if (edit.deed == BrushEdit::Deed::fill) {
    region.difference(united(blocks));
  } else {
    for (auto& [block, set] : blocks) set.difference(region);
  }
  if (edit.deed != BrushEdit::Deed::carve) blocks[edit.block].join(region);
  return blocks;
}

// The sides of a polygon, each as one segment.
void addSides(const Polygon& polygon, Segments& edges) {
  Polygon corners;
  const std::size_t n = polygon.size();
  for (std::size_t k = 0; k < n; ++k)
    if (!CGAL::collinear(polygon[(k + n - 1) % n], polygon[k], polygon[(k + 1) % n])) corners.push_back(polygon[k]);
  edges.insert(edges.end(), corners.edges_begin(), corners.edges_end());
}

void addEdges(const PolygonSet& set, Segments& edges) {
  for (const WithHoles& part : parts(set)) {
    addSides(part.outer_boundary(), edges);
    for (const Polygon& hole : part.holes()) addSides(hole, edges);
  }
}

using Convex = std::vector<Kernel::Point_2>;

// The distance from an edge is a convex function: if it is at most 1 in all corners of a convex polygon, it is in all
// of it. Otherwise another edge may be near to a part of it, so it is halved across its longest side, some times.
bool isNear(const Convex& piece, const Segments& edges, int halvings) {
  for (const Kernel::Segment_2& edge : edges) {
    const auto isNearEdge = [&](const Kernel::Point_2& p) { return CGAL::squared_distance(p, edge) <= 1; };
    if (std::all_of(piece.begin(), piece.end(), isNearEdge)) return true;
  }
  if (halvings == 0) return false;
  std::size_t longest = 0;
  const auto after = [&](std::size_t k) { return (k + 1) % piece.size(); };
  const auto length = [&](std::size_t k) { return CGAL::to_double(CGAL::squared_distance(piece[k], piece[after(k)])); };
  for (std::size_t k = 1; k < piece.size(); ++k)
    if (length(k) > length(longest)) longest = k;
  // From the middle of the longest side to the corner halfway around: two convex halves.
  const Kernel::Point_2 middle = CGAL::midpoint(piece[longest], piece[after(longest)]);
  const std::size_t steps = (piece.size() + 1) / 2;
  Convex first{middle}, second{middle};
  for (std::size_t k = 0, at = after(longest); k < piece.size(); ++k, at = after(at)) {
    if (k < steps) first.push_back(piece[at]);
    if (k + 1 >= steps) second.push_back(piece[at]);
  }
  return isNear(first, edges, halvings - 1) && isNear(second, edges, halvings - 1);
}

std::optional<std::string> farFrom(const PolygonSet& exact, const PolygonSet& real, const Segments& edges) {
  constexpr int kHalvings = 48;  // two of them halve a long, thin piece: the last ones are smaller than a unit
  PolygonSet difference = exact;
  difference.symmetric_difference(real);
  for (const WithHoles& part : parts(difference)) {
    std::vector<Polygon> pieces;
    CGAL::Polygon_vertical_decomposition_2<Kernel>()(part, std::back_inserter(pieces));
    for (const Polygon& piece : pieces) {
      if (isNear(Convex(piece.vertices_begin(), piece.vertices_end()), edges, kHalvings)) continue;
      std::ostringstream text;
      text << "differs from the exact result far from its edges, in";
      for (const Kernel::Point_2& p : piece.vertices())
        text << " (" << CGAL::to_double(p.x()) << ", " << CGAL::to_double(p.y()) << ")";
      return text.str();
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> farFromExact(const Scene& before, const BrushEdit& edit, const Scene& after) {
  std::map<Block, PolygonSet> exact = exactResult(before, edit), real = byBlock(after);
  Segments edges;
  for (const auto& [block, set] : exact) addEdges(set, edges);
  for (const auto& [block, set] : real) exact.try_emplace(block);
  for (const auto& [block, set] : exact)
    if (const auto complaint = farFrom(set, real[block], edges))
      return "block " + std::to_string(block) + " " + *complaint;
  const PolygonSet solid = united(exact);
  Segments outline;
  addEdges(solid, outline);
  if (const auto complaint = farFrom(solid, united(real), outline)) return "the solid " + *complaint;
  return std::nullopt;
}

}  // namespace lgs::oracle
