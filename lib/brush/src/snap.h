// Snap rounding in one cell: segments become chains between lattice points, and never cross: docs/internals/brushes.md.
//
// Units: lattice units from the cell's corner. Ends of edges of polygons are in the cell; those of the region's edges
// are at most 2^29 units away.
#pragma once

#include "pieces.h"

#include <optional>

namespace lgs::brush {

/// What changes from the right of an edge to its left.
struct Sum {
  std::int64_t winding = 0;  ///< of the region
  std::int64_t group = 0;    ///< group k of the cell's polygons counts as k + 1: 0 is none
  Sum& operator+=(const Sum& other) {
    winding += other.winding;
    group += other.group;
    return *this;
  }
  friend Sum operator-(const Sum& s) { return {-s.winding, -s.group}; }
  friend bool operator==(const Sum&, const Sum&) = default;
};

struct Segment {
  Point a, b;        ///< it runs along the line through these points,
  Point start, end;  ///< from here to there: its own ends, or where the rim cuts it
  Sum sum;
  bool bends = true;  ///< false: it stays straight, and is only cut at hot points on it
};

/// Whether a point is in the closed box of two others.
bool isInBox(Point p, Point a, Point b);

/// Whether the edge a→b passes the pixel of a lattice point, left and lower side included.
bool passes(Point a, Point b, Point pixel);

/// The pixel in which two segments cross between their starts and ends, or nothing. An end on the other segment is no
/// crossing: it is hot anyway.
std::optional<Point> crossingPixel(const Segment& p, const Segment& q);

/// Sorts, and leaves out what comes twice.
void normalize(Points& points);

/// Adds crossings of segments that bend. False if they are too many for a cell; then some are missing.
[[nodiscard]] bool addCrossings(const List<Segment>& segments, Points& hot);

/// Those of some points, sorted, that lie between two others by x.
std::span<const Point> between(const Points& sorted, Point a, Point b);

/// The hot points that a segment goes through, in order, with both ends. `hot` is normalized.
void route(const Segment& segment, const Points& hot, Points& chain);

}  // namespace lgs::brush
