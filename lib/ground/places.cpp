#include "ground/places.h"

#include "geometry/relation.h"
#include "geometry/sort.h"

#include <algorithm>

namespace lgs::detail {
namespace {

/// Where a point lies as to one polygon.
Spot::Where locate(PolygonView polygon, LocalPoint p) {
  Sight sight;
  see(p, p, polygon, sight);
  if (sight.inside) return Spot::Where::inside;
  return sight.outside ? Spot::Where::outside : Spot::Where::edge;
}

}  // namespace

void polygonsOf(const Ground& ground, Cell cell, std::vector<PlacedPolygon>& out) {
  out.clear();
  const CellAt at = ground.grid.find(cell);
  if (at && !at.chunk->isUnloaded) ground.read(at.ref(), ground.held(at), out);
}

Expected<PlacedPolygon> polygonOf(const Ground& ground, PolygonHandle handle) {
  return ground.find(handle).map([&](const Ground::Found& found) {
    return PlacedPolygon{handle, ground.held(found.at)[found.slot].block,
                         ground.catalogue.vertices(ground.content(found.at).polygons[found.slot])};
  });
}

/// Calls visit(CellAt, Cell) for the cells of a rectangle that hold polygons in memory.
template <class Visit>
void forEachHolding(const Ground& ground, const CellRect& cells, Visit&& visit) {
  ground.grid.forEachCell(cells, [&](CellAt at, Cell cell) {
    if (!at.chunk->isUnloaded && ground.held(at).size() != 0) visit(at, cell);
  });
}

void forEachPolygon(const Ground& ground, const CellRect& cells, const World::PolygonVisitor& visit) {
  if (lgs::isEmpty(cells) || !visit) return;
  std::vector<PlacedPolygon> polygons;
  forEachHolding(ground, cells, [&](CellAt at, Cell cell) {
    polygons.clear();
    ground.read(at.ref(), ground.held(at), polygons);
    for (const PlacedPolygon& polygon : polygons) visit(cell, polygon);
  });
}

std::optional<CellRect> boundsOf(const Ground& ground) {
  std::optional<CellRect> bounds;
  forEachHolding(ground, kWholeWorld, [&](CellAt, Cell cell) {
    if (!bounds) bounds = CellRect{cell, cell};
    bounds->min = {std::min(bounds->min.i, cell.i), std::min(bounds->min.j, cell.j)};
    bounds->max = {std::max(bounds->max.i, cell.i), std::max(bounds->max.j, cell.j)};
  });
  return bounds;
}

Spot spotAt(const Ground& ground, Point p) {
  Spot spot;
  if (!inRange(p)) return spot;
  spot.cell = lgs::cellAt(p);
  std::vector<PlacedPolygon> polygons;
  // On a common side a point is in the closed cells on both sides of it.
  const Cell low = lgs::cellAt(Point{p.x - 1, p.y - 1}), high = lgs::cellAt(p);
  for (Cell cell = low; cell.j <= high.j; ++cell.j) {
    for (cell.i = low.i; cell.i <= high.i; ++cell.i) {
      if (ground.grid.isUnloaded(cell)) return {Spot::Where::unloaded, {}, 0, cell};
      polygonsOf(ground, cell, polygons);
      const Point origin = toWorld(cell, {});
      const LocalPoint local{static_cast<std::int32_t>(p.x - origin.x), static_cast<std::int32_t>(p.y - origin.y)};
      for (const PlacedPolygon& polygon : polygons) {
        const Spot::Where where = locate(polygon.vertices, local);
        if (where == Spot::Where::outside || spot.where == where) continue;
        spot = {where, polygon.handle, polygon.block, cell};
        if (where == Spot::Where::inside) return spot;
      }
    }
  }
  return spot;
}

bool holdsPolygonsOf(const Ground& ground, const Ground& other) {
  using Polygon = std::pair<std::vector<LocalPoint>, Block>;
  std::vector<PlacedPolygon> placed;
  const auto read = [&placed](const Ground& from, Cell cell) {
    std::vector<Polygon> out;
    polygonsOf(from, cell, placed);
    for (const PlacedPolygon& p : placed) {
      out.emplace_back(std::vector(p.vertices.begin(), p.vertices.end()), p.block);
      std::vector<LocalPoint>& vertices = out.back().first;
      std::rotate(vertices.begin(), std::min_element(vertices.begin(), vertices.end()), vertices.end());
    }
    detail::sort(out);
    return out;
  };
  bool areSame = true;
  forEachHolding(other, kWholeWorld,
                 [&](CellAt, Cell cell) { areSame = areSame && read(ground, cell) == read(other, cell); });
  return areSame;
}

void count(const Ground& ground, Stats& stats) {
  forEachHolding(ground, kWholeWorld, [&](CellAt at, Cell) {
    stats.polygons += ground.held(at).size();
    ++stats.cells;
  });
  stats.shapes = ground.catalogue.shapeCount();
  stats.contents = ground.catalogue.contentCount();
  stats.chunks = ground.grid.count();
  stats.bytes += ground.bytes();
}

}  // namespace lgs::detail
