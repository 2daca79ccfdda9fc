#include "oracle/check/reach.h"

#include "oracle/reference/vector.h"

#include <fmt/format.h>
#include <algorithm>

namespace lgs::oracle {
namespace {

using Ring = std::vector<Point>;

Point after(const Ring& ring, std::size_t k) { return ring[k + 1 == ring.size() ? 0 : k + 1]; }

int sideOf(Point a, Point b, Point p) {
  const std::int64_t turn = cross(b - a, p - a);
  return (turn > 0) - (turn < 0);
}

// Whether two closed segments have a point in common; they may be points themselves.
bool meet(Point a, Point b, Point c, Point d) {
  const auto apart = [](std::int64_t p, std::int64_t q, std::int64_t r, std::int64_t s) {
    return std::max(p, q) < std::min(r, s) || std::max(r, s) < std::min(p, q);
  };
  if (apart(a.x, b.x, c.x, d.x) || apart(a.y, b.y, c.y, d.y)) return false;
  return sideOf(a, b, c) * sideOf(a, b, d) <= 0 && sideOf(c, d, a) * sideOf(c, d, b) <= 0;
}

bool meet(const Ring& one, const Ring& other) {
  for (std::size_t k = 0; k < one.size(); ++k)
    for (std::size_t i = 0; i < other.size(); ++i)
      if (meet(one[k], after(one, k), other[i], after(other, i))) return true;
  return false;
}

// How often rings run around a point that is on none of them.
int windingAround(Point p, const std::vector<Ring>& rings) {
  int winding = 0;
  for (const Ring& ring : rings) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Point a = ring[k], b = after(ring, k);
      if ((a.y <= p.y) == (b.y <= p.y)) continue;
      const bool rises = b.y > a.y;  // across a ray to the right
      if ((sideOf(a, b, p) > 0) == rises) winding += rises ? 1 : -1;
    }
  }
  return winding;
}

// Whether one of its vertices lies inside.
bool covers(const BrushEdit& brush, const ScenePolygon& polygon) {
  return std::ranges::any_of(polygon.vertices, [&](LocalPoint v) {
    const Point p = toWorld(polygon.cell, v);
    const int winding = windingAround(p, brush.rings);
    const bool isOnEdge =
        std::ranges::any_of(brush.rings, [&](const Ring& ring) { return !ring.empty() && meet(ring, {p}); });
    return !isOnEdge && (brush.isEvenOdd ? winding % 2 != 0 : winding != 0);
  });
}

// From whichever vertex they begin.
bool isSameRing(const LocalPolygon& a, const LocalPolygon& b) {
  LocalPolygon twice = a;
  twice.insert(twice.end(), a.begin(), a.end());
  return a.size() == b.size() && std::search(twice.begin(), twice.end(), b.begin(), b.end()) != twice.end();
}

Ring outlineOf(const ScenePolygon& polygon) {
  Ring outline;
  for (const LocalPoint v : polygon.vertices) outline.push_back(toWorld(polygon.cell, v));
  return outline;
}

// Whether two polygons have no point in common.
bool areApart(const ScenePolygon& a, const ScenePolygon& b) {
  const Ring one = outlineOf(a), other = outlineOf(b);
  return !meet(one, other) && windingAround(one[0], {other}) == 0 && windingAround(other[0], {one}) == 0;
}

// What comes out as it was keeps its handle.
bool hasOtherHandle(const ScenePolygon& now, const Brushed& done) {
  return std::ranges::any_of(done.removed, [&](const auto& entry) {
    const ScenePolygon& was = entry.second;
    return was.cell == now.cell && was.block == now.block && isSameRing(was.vertices, now.vertices);
  });
}

}  // namespace

bool mayMeet(const BrushEdit& brush, const ScenePolygon& polygon) {
  const Ring outline = outlineOf(polygon);
  for (const Ring& ring : brush.rings)
    if (!ring.empty() && (meet(ring, outline) || windingAround(ring[0], {outline}) != 0)) return true;
  const int winding = windingAround(outline[0], brush.rings);
  return brush.isEvenOdd ? winding % 2 != 0 : winding != 0;
}

std::string wrongReach(const BrushEdit& brush, const Brushed& done) {
  for (const Call& part : done.edits)
    if (part.kind == Call::Kind::add && hasOtherHandle(part.polygon(), done))
      return fmt::format("a polygon of cell ({}, {}) is as it was, but for its handle", part.comes[0].cell.i,
                         part.comes[0].cell.j);
  for (const Call& part : done.edits) {
    if (part.kind != Call::Kind::remove || std::ranges::find(done.rounded, part.name()) != done.rounded.end()) continue;
    if (!mayMeet(brush, done.removed.at(part.name())))
      return fmt::format("'{}' has changed, but is not reached", part.name());
  }
  for (const auto& [old, now] : done.became) {
    const auto isNow = [&, &name = now](const Call& part) {
      return part.kind == Call::Kind::add && part.name() == name;
    };
    const auto part = std::ranges::find_if(done.edits, isNow);
    if (part != done.edits.end() && areApart(done.removed.at(old), part->polygon()))
      return fmt::format("'{}' is said to be in what has nothing of it", old);
  }
  for (const std::string& name : done.rounded) {
    const ScenePolygon& polygon = done.removed.at(name);
    const bool stays = std::ranges::find(brush.staying, polygon.block) != brush.staying.end();
    if (!stays && covers(brush, polygon)) return fmt::format("'{}' is said to be bent alone, but is reached", name);
  }
  return "";
}

}  // namespace lgs::oracle
