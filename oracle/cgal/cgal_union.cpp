// CGAL takes half a minute to compile. Only this file and brushed.cpp include it, and they are compiled together.
#include "oracle/cgal/cgal_union.h"

#include "oracle/cgal/scene_edges.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <utility>

namespace lgs::oracle {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using PolygonSet = CGAL::Polygon_set_2<Kernel>;
using Polygon = PolygonSet::Polygon_2;
using Arrangement = PolygonSet::Arrangement_2;
using Halfedge = Arrangement::Halfedge_const_handle;

// CGAL computes relative to the scene's least cell, so that its coordinates stay small, and exact as doubles, wherever
// in the world the scene is.
class Frame {
 public:
  explicit Frame(const Scene& scene) {
    if (scene.polygons.empty()) return;
    Cell least = scene.polygons.front().cell;
    for (const ScenePolygon& p : scene.polygons) {
      least = {std::min(least.i, p.cell.i), std::min(least.j, p.cell.j)};
    }
    origin_ = toWorld(least, {0, 0});
  }

  Kernel::Point_2 toCgal(Point p) const {
    return {static_cast<double>(p.x - origin_.x), static_cast<double>(p.y - origin_.y)};
  }
  Point toLattice(const Kernel::Point_2& p) const {
    return {toInteger(p.x()) + origin_.x, toInteger(p.y()) + origin_.y};
  }

 private:
  // A union of polygons with disjoint interiors has only vertices of the input: lattice points.
  static std::int64_t toInteger(const Kernel::FT& coordinate) {
    const auto [low, high] = CGAL::to_interval(coordinate);
    if (low != high || low != std::floor(low)) throw std::invalid_argument("polygons of the scene cross each other");
    return static_cast<std::int64_t>(low);
  }

  Point origin_;
};

// Unites all polygons in one call. CGAL overlays up to kSweepAtOnce arrangements in one sweep, and splits a longer
// list. Its default is 5. With 100 a world of 3×3 to 8×8 cells is a single sweep, which takes half to two thirds of the
// time. (A single sweep over 10,000 polygons takes many times as long.) Polygon_set_2 hides the parameter, its base
// class does not.
PolygonSet unite(const std::vector<Polygon>& polygons) {
  constexpr unsigned kSweepAtOnce = 100;
  PolygonSet result;
  CGAL::General_polygon_set_2<PolygonSet::Traits_2>& base = result;
  base.join(polygons.begin(), polygons.end(), kSweepAtOnce);
  return result;
}

// A halfedge has its face on its left. It is part of the boundary if its left is solid and its right is free.
bool isBoundary(Halfedge h) { return h->face()->contained() && !h->twin()->face()->contained(); }

// The neighbours of a boundary halfedge along the free face on its right. The walk around that face goes the other way,
// so the successor is what that walk came from.
Halfedge successor(Halfedge h) { return h->twin()->prev()->twin(); }
Halfedge predecessor(Halfedge h) { return h->twin()->next()->twin(); }

void readSegments(const Arrangement& arrangement, const Frame& frame, Outline& outline) {
  for (auto h = arrangement.halfedges_begin(); h != arrangement.halfedges_end(); ++h) {
    if (!isBoundary(h)) continue;
    const auto at = [&](Arrangement::Vertex_const_handle v) { return frame.toLattice(v->point()); };
    outline.push_back({at(h->source()), at(h->target()), 0, at(predecessor(h)->source()), at(successor(h)->target())});
  }
}

void readLoops(const Arrangement& arrangement, const Frame& frame, Loops& loops) {
  const auto readCycle = [&](Arrangement::Ccb_halfedge_const_circulator cycle) {
    loops.emplace_back();
    const auto first = cycle;
    do loops.back().push_back(frame.toLattice(cycle->source()->point()));
    while (++cycle != first);
    std::reverse(loops.back().begin(), loops.back().end());  // the free face was on the left
  };
  for (auto face = arrangement.faces_begin(); face != arrangement.faces_end(); ++face) {
    if (face->contained()) continue;
    for (auto cycle = face->outer_ccbs_begin(); cycle != face->outer_ccbs_end(); ++cycle) readCycle(*cycle);
    for (auto cycle = face->inner_ccbs_begin(); cycle != face->inner_ccbs_end(); ++cycle) readCycle(*cycle);
  }
}

// Sorts the outline and names owners and blocks.
void nameOwners(const Scene& scene, const SceneEdges& edges, CgalUnion& result) {
  std::sort(result.outline.begin(), result.outline.end());
  for (OutlineSegment& segment : result.outline) {
    result.owner.push_back(edges.owner(segment.start, segment.end));
    segment.block = scene.polygons[result.owner.back()].block;
  }
}

// A link is known if all segments at its vertex are of one material.
void markKnownLinks(const Materials& materials, CgalUnion& result) {
  result.known.resize(result.outline.size());
  if (materials.count <= 1) return;
  std::vector<std::pair<Point, std::uint32_t>> materialsAt;  // sorted and distinct, so a vertex with two is seen twice
  for (const OutlineSegment& s : result.outline) {
    const std::uint32_t material = materials.of(s.block);
    materialsAt.emplace_back(s.start, material);
    materialsAt.emplace_back(s.end, material);
  }
  std::sort(materialsAt.begin(), materialsAt.end());
  materialsAt.erase(std::unique(materialsAt.begin(), materialsAt.end()), materialsAt.end());
  const auto hasOne = [&](Point vertex) {
    const auto first = std::lower_bound(materialsAt.begin(), materialsAt.end(), std::pair(vertex, std::uint32_t{0}));
    return std::next(first) == materialsAt.end() || std::next(first)->first != vertex;
  };
  for (std::size_t k = 0; k < result.outline.size(); ++k) {
    result.known[k] = {hasOne(result.outline[k].start), hasOne(result.outline[k].end)};
  }
}

}  // namespace

std::optional<CgalUnion> cgalUnion(const Scene& scene) {
  const std::optional<Materials> partition = materials(scene);
  if (!partition) return std::nullopt;
  const Frame frame(scene);
  const SceneEdges edges(scene);

  std::vector<std::vector<Polygon>> polygonsOf(partition->count);
  for (const ScenePolygon& scenePolygon : scene.polygons) {
    Polygon& polygon = polygonsOf[partition->of(scenePolygon.block)].emplace_back();
    if (partition->count == 1) {
      for (const LocalPoint v : scenePolygon.vertices) polygon.push_back(frame.toCgal(toWorld(scenePolygon.cell, v)));
    } else {
      // Law 1 cuts edges at the vertices of any polygon, and a union does not see those of another material.
      for (const Point v : edges.cutOutline(scenePolygon)) polygon.push_back(frame.toCgal(v));
    }
  }

  CgalUnion result;
  for (const std::vector<Polygon>& polygons : polygonsOf) {
    const PolygonSet united = unite(polygons);
    readSegments(united.arrangement(), frame, result.outline);
    readLoops(united.arrangement(), frame, result.loops);
  }
  nameOwners(scene, edges, result);
  markKnownLinks(*partition, result);
  return result;
}

}  // namespace lgs::oracle
