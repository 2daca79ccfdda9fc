#include "oracle/cgal/brushed.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>
#include <CGAL/Polygon_vertical_decomposition_2.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <sstream>

namespace lgs::oracle {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using PolygonSet = CGAL::Polygon_set_2<Kernel>;
using Polygon = PolygonSet::Polygon_2;
using WithHoles = PolygonSet::Polygon_with_holes_2;
struct Side {
  Kernel::Segment_2 segment;
  CGAL::Bbox_2 box = segment.bbox();
};
using Sides = std::vector<Side>;

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

std::map<Block, PolygonSet> byBlock(const std::vector<ScenePolygon>& polygons) {
  std::map<Block, std::vector<Polygon>> ofBlocks;
  for (const ScenePolygon& p : polygons) ofBlocks[p.block].push_back(polygonOf(p));
  std::map<Block, PolygonSet> sets;
  for (const auto& [block, all] : ofBlocks) sets[block].join(all.begin(), all.end());
  return sets;
}

CGAL::Bbox_2 boxOf(const ScenePolygon& p) { return polygonOf(p).bbox(); }

// What stands before and after an edit, without what is in both and touches neither a change nor the region: there is
// no difference at it, and CGAL would take most of its time for it.
struct BeforeAndAfter {
  std::vector<ScenePolygon> before, after;
};

BeforeAndAfter withoutFar(const Scene& before, const BrushEdit& edit, const Scene& after) {
  std::vector<CGAL::Bbox_2> boxes;
  for (const std::vector<Point>& ring : edit.rings) {
    CGAL::Bbox_2& box = boxes.emplace_back();
    for (const Point p : ring) box += toCgal(p).bbox();
  }
  const auto isIn = [](const Scene& scene, const ScenePolygon& p) {
    return std::ranges::find(scene.polygons, p) != scene.polygons.end();
  };
  for (const ScenePolygon& p : before.polygons)
    if (!isIn(after, p)) boxes.push_back(boxOf(p));
  for (const ScenePolygon& p : after.polygons)
    if (!isIn(before, p)) boxes.push_back(boxOf(p));
  const auto near = [&](const Scene& scene) {
    std::vector<ScenePolygon> kept;
    std::ranges::copy_if(scene.polygons, std::back_inserter(kept), [&](const ScenePolygon& p) {
      return std::ranges::any_of(boxes, [box = boxOf(p)](const CGAL::Bbox_2& b) { return CGAL::do_overlap(box, b); });
    });
    return kept;
  };
  return {near(before), near(after)};
}

PolygonSet united(const std::vector<ScenePolygon>& polygons) {
  std::vector<Polygon> all;
  for (const ScenePolygon& p : polygons) all.push_back(polygonOf(p));
  PolygonSet result;
  result.join(all.begin(), all.end());
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

struct Exact {
  std::map<Block, PolygonSet> blocks;
  PolygonSet solid;
};

Exact exactResult(const std::vector<ScenePolygon>& before, const BrushEdit& edit) {
  Exact result{byBlock(before), united(before)};
  PolygonSet region = regionOf(edit);
  for (const Block block : edit.staying) region.difference(result.blocks[block]);
  if (edit.deed == BrushEdit::Deed::fill) {
    region.difference(result.solid);
  } else {
    for (auto& [block, set] : result.blocks) set.difference(region);
  }
  if (edit.deed == BrushEdit::Deed::carve) {
    result.solid.difference(region);
  } else {
    result.blocks[edit.block].join(region);
    result.solid.join(region);
  }
  return result;
}

// The sides of a polygon, each as one segment.
void addSides(const Polygon& polygon, Sides& edges) {
  Polygon corners;
  const std::size_t n = polygon.size();
  for (std::size_t k = 0; k < n; ++k)
    if (!CGAL::collinear(polygon[(k + n - 1) % n], polygon[k], polygon[(k + 1) % n])) corners.push_back(polygon[k]);
  for (auto edge = corners.edges_begin(); edge != corners.edges_end(); ++edge) edges.push_back({*edge});
}

void addEdges(const PolygonSet& set, Sides& edges) {
  for (const WithHoles& part : parts(set)) {
    addSides(part.outer_boundary(), edges);
    for (const Polygon& hole : part.holes()) addSides(hole, edges);
  }
}

// The sides of a solid that rounding may move: none on a line between cells, since a brush cuts along these.
Sides movable(const PolygonSet& solid) {
  Sides sides;
  addEdges(solid, sides);
  const auto isOnGrid = [](double min, double max) {
    return min == max && std::fmod(min, static_cast<double>(kUnitsPerCell)) == 0;
  };
  std::erase_if(sides, [&](const Side& side) {
    return isOnGrid(side.box.xmin(), side.box.xmax()) || isOnGrid(side.box.ymin(), side.box.ymax());
  });
  return sides;
}

using Convex = std::vector<Kernel::Point_2>;

// The distance from an edge is a convex function: if it is at most `reach` in all corners of a convex polygon, it is in all
// of it. Otherwise another edge may be near to a part of it, so it is halved across its longest side, some times.
bool isNear(const Convex& piece, const Sides& edges, int reach, int halvings) {
  const double most = reach + 1;  // more than enough: boxes are rounded outwards
  for (const Side& edge : edges) {
    const CGAL::Bbox_2 around(edge.box.xmin() - most, edge.box.ymin() - most, edge.box.xmax() + most,
                              edge.box.ymax() + most);
    const auto isNearEdge = [&](const Kernel::Point_2& p) {
      return CGAL::do_overlap(p.bbox(), around) && CGAL::squared_distance(p, edge.segment) <= reach * reach;
    };
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
  return isNear(first, edges, reach, halvings - 1) && isNear(second, edges, reach, halvings - 1);
}

std::optional<std::string> farFrom(const PolygonSet& exact, const PolygonSet& real, const Sides& edges, int reach = 1) {
  constexpr int kHalvings = 48;  // two of them halve a long, thin piece: the last ones are smaller than a unit
  PolygonSet difference = exact;
  difference.symmetric_difference(real);
  for (const WithHoles& part : parts(difference)) {
    std::vector<Polygon> pieces;
    CGAL::Polygon_vertical_decomposition_2<Kernel>()(part, std::back_inserter(pieces));
    for (const Polygon& piece : pieces) {
      if (isNear(Convex(piece.vertices_begin(), piece.vertices_end()), edges, reach, kHalvings)) continue;
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
  const BeforeAndAfter near = withoutFar(before, edit, after);
  Exact exact = exactResult(near.before, edit);
  std::map<Block, PolygonSet> real = byBlock(near.after);
  Sides edges;
  for (const auto& [block, set] : exact.blocks) addEdges(set, edges);
  for (const auto& [block, set] : real) exact.blocks.try_emplace(block);
  for (const auto& [block, set] : exact.blocks)
    if (const auto complaint = farFrom(set, real[block], edges))
      return "block " + std::to_string(block) + " " + *complaint;
  if (const auto complaint = farFrom(exact.solid, united(near.after), movable(exact.solid)))
    return "the solid " + *complaint;
  return std::nullopt;
}

std::optional<std::string> seamIn(const Scene& before, const BrushEdit& filled, const Scene& after) {
  const PolygonSet ground = byBlock(before.polygons)[filled.block];
  PolygonSet outside = regionOf(filled);
  outside.difference(ground);
  if (!outside.is_empty()) return std::nullopt;
  const auto complaint = farFrom(ground, byBlock(after.polygons)[filled.block], movable(ground), 2);
  return complaint ? std::optional("a carved region that is filled again " + *complaint) : std::nullopt;
}

}  // namespace lgs::oracle
