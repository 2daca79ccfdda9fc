// Exact plane geometry on the lattice: what the importer needs to cut polygons along the grid and out of each other.
// All polygons are rings of lattice points; coordinates are relative to one cell and reach at most kMaxReach cells.
#pragma once

#include <lgs/lattice.h>

#include <cstdint>
#include <span>
#include <vector>

namespace lgs::tiled {

using Polygon = std::vector<Point>;

/// Twice the signed area of the triangle o, a, b: positive when it turns left.
constexpr std::int64_t cross(Point o, Point a, Point b) {
  return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

/// Twice the signed area: positive for a counter-clockwise ring.
std::int64_t doubleArea(const Polygon& ring);

struct Box {
  Point min, max;
};

/// The least box around a ring of at least one vertex.
Box boxOf(const Polygon& ring);

/// The ring without repeated and collinear vertices and without spikes, taken apart where it comes back to a vertex.
/// The orientation of each loop is kept; one whose area is 0 crosses itself.
std::vector<Polygon> tidyLoops(Polygon ring);

/// Whether no two edges meet, but for neighbours in their common vertex. O(n²).
bool isSimple(const Polygon& ring);

enum class Relation : std::uint8_t {
  apart,    ///< the interiors do not meet (the boundaries may touch)
  overlap,  ///< the interiors meet
  inside,   ///< a is a part of b, or all of it
};

/// How a lies to b; both simple and counter-clockwise. O(n·m).
Relation relation(const Polygon& a, const Polygon& b);

bool strictlyInside(Point p, const Polygon& ring);

/// Whether every vertex of a lies in b or misses it by a lattice unit or two, as rounding may cause. O(n·m).
bool nearlyInside(const Polygon& a, const Polygon& b);

/// a with those vertices of b put into its outline that its edges pass by a lattice unit or two.
Polygon bentAround(const Polygon& a, const Polygon& b);

struct Line {
  Point at;
  Point direction;
};

/// Both sides of a polygon that was cut along a line. All pieces are counter-clockwise and tidy.
struct Halves {
  std::vector<Polygon> left;
  std::vector<Polygon> right;
};

/// The polygons that a cut should not push a piece into.
using Obstacles = std::span<const Polygon>;

/// Cuts a simple counter-clockwise polygon. The new vertices are rounded to a lattice point beside the exact place: to
/// an obstacle's vertex if one is that near, else to the nearest that is in no obstacle and not on the line's left.
/// Along a horizontal or vertical line, without obstacles, only the place on the line is rounded. Rounding can make a
/// piece touch itself: check isSimple(). The same edge, cut from either of its sides, is cut in the same point.
/// Limits: any line inside one cell; horizontal and vertical lines of direction ±1 within kMaxReach cells.
Halves split(const Polygon& ring, const Line& line, Obstacles obstacles = {});

struct Difference {
  std::vector<Polygon> parts;  ///< simple, counter-clockwise; none overlaps b
  bool lost = false;  ///< whether a part worth mentioning had to be given up (intricate, or spoilt by rounding)
};

/// a without b; both simple and counter-clockwise, inside one cell. Cuts keep clear of the obstacles, b among them, so
/// that as a rule the parts overlap none that a did not overlap; check it.
Difference subtract(const Polygon& a, const Polygon& b, Obstacles obstacles);

}  // namespace lgs::tiled
