// What a world answers about places: what lies at a point, which segment is nearest, what a ray meets. World's members
// `at`, `nearest` and `rayCast` give these values.
//
// Points are lattice points: latticePoint() makes one of a position in cells. All comparisons are exact. Only what is
// handed out as `double` is rounded, at the very end.
#pragma once

#include <lgs/ids.h>
#include <lgs/lattice.h>

namespace lgs {

/// The lattice point nearest to a position of the world in cells, halves away from zero. If the position is beyond the
/// last cell, or no number, the result is not inRange().
Point latticePoint(DoublePoint position);

/// How far nearest() looks at most, in cells.
inline constexpr std::int32_t kMaxRadius = 4'096;

/// How long a ray may be on each axis, in cells.
inline constexpr std::int32_t kMaxRay = 16'384;

/// What lies at a point.
struct Spot {
  /// Where a point lies.
  enum class Where {
    outside,  ///< no polygon
    edge,     ///< on the outline of a polygon, or of several
    inside,   ///< in the interior of one polygon
    unloaded  ///< not known: one of the cells that the point is in is unloaded
  };
  Where where = Where::outside;  ///< whether there is ground
  PolygonHandle
      polygon{};  ///< null outside, and if it is not known; on an edge the first that has it, by cell (j, then i) and handle
  Block block = 0;  ///< of that polygon
  Cell cell{};      ///< of that polygon; outside the cell of the point, see cellAt(Point); or the unloaded one
};

/// The segment nearest to a point.
struct Nearest {
  SegmentId segment{};  ///< null: no segment within the radius
  DoublePoint point{};  ///< the nearest point of that segment, in cells
  double distance = 0;  ///< to it, in cells
};

/// What a ray meets first.
struct RayHit {
  SegmentId segment{};   ///< null: nothing was hit
  double fraction = 1;   ///< of the way from the start to the end of the ray
  DoublePoint point{};   ///< where, in cells
  DoublePoint normal{};  ///< outward unit normal of the segment
};

}  // namespace lgs
