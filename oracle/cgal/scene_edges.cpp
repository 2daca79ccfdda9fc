#include "oracle/cgal/scene_edges.h"

#include "oracle/reference/vector.h"
#include "oracle/reference/words.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <stdexcept>

namespace lgs::oracle {
namespace {

bool covers(const ScenePolygon& polygon, Point start, Point end) {
  Point from = toWorld(polygon.cell, polygon.vertices.back());
  for (const LocalPoint vertex : polygon.vertices) {
    const Point to = toWorld(polygon.cell, vertex);
    if (isOnSegment(start, from, to) && isOnSegment(end, from, to) && dot(end - start, to - from) > 0) return true;
    from = to;
  }
  return false;
}

}  // namespace

SceneEdges::SceneEdges(const Scene& scene) : scene_(scene) {
  byCell_.reserve(scene.polygons.size());
  for (const ScenePolygon& polygon : scene.polygons) {
    byCell_.emplace_back(polygon.cell, static_cast<std::uint32_t>(byCell_.size()));
  }
  std::sort(byCell_.begin(), byCell_.end());
}

template <class Visit>
void SceneEdges::forPolygonsNear(Point point, Visit visit) const {
  // A point on a line between cells belongs to both sides.
  const auto left = static_cast<std::int32_t>(cellIndex(point.x - 1));
  const auto right = static_cast<std::int32_t>(cellIndex(point.x));
  const auto below = static_cast<std::int32_t>(cellIndex(point.y - 1));
  const auto above = static_cast<std::int32_t>(cellIndex(point.y));
  for (std::int32_t i = left; i <= right; ++i) {
    auto entry = std::lower_bound(byCell_.begin(), byCell_.end(), std::pair(Cell{i, below}, std::uint32_t{0}));
    for (; entry != byCell_.end() && entry->first <= Cell{i, above}; ++entry) visit(entry->second);
  }
}

std::uint32_t SceneEdges::owner(Point start, Point end) const {
  std::optional<std::uint32_t> found;
  forPolygonsNear(start, [&](std::uint32_t p) {
    if (!found && covers(scene_.polygons[p], start, end)) found = p;
  });
  if (!found) throw std::invalid_argument("no polygon of the scene has an edge along " + inWords(start, end));
  return *found;
}

std::vector<Point> SceneEdges::cutOutline(const ScenePolygon& polygon) const {
  std::vector<Point> outline;
  for (std::size_t k = 0; k < polygon.vertices.size(); ++k) {
    const Point from = toWorld(polygon.cell, polygon.vertices[k]);
    const Point to = toWorld(polygon.cell, polygon.vertices[(k + 1) % polygon.vertices.size()]);
    std::vector<Point> cuts;
    // Where a vertex of another cell lies inside this edge, the edge runs along a side of both cells. So both cells
    // contain its start, and looking there is enough.
    forPolygonsNear(from, [&](std::uint32_t p) {
      for (const LocalPoint v : scene_.polygons[p].vertices) {
        const Point vertex = toWorld(scene_.polygons[p].cell, v);
        if (vertex != from && vertex != to) cuts.push_back(vertex);
      }
    });
    // Keep only those inside the edge, in its order.
    const auto key = [&](Point v) { return dot(v - from, to - from); };
    cuts.erase(std::remove_if(cuts.begin(), cuts.end(), [&](Point v) { return !isOnSegment(v, from, to); }),
               cuts.end());
    std::sort(cuts.begin(), cuts.end(), [&](Point a, Point b) { return key(a) < key(b); });
    outline.push_back(from);
    std::unique_copy(cuts.begin(), cuts.end(), std::back_inserter(outline));
  }
  return outline;
}

}  // namespace lgs::oracle
