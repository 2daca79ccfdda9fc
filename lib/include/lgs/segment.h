// What a commit makes: segments of the outline with their ghost vertices, the lists of what changed, and whole loops.
#pragma once

#include <lgs/ids.h>
#include <lgs/lattice.h>

#include <cstdint>
#include <vector>

namespace lgs {

/// One boundary segment. The solid is on the left of start→end, the outward normal on the right.
struct Segment {
  SegmentId id;           ///< its name, until a commit removes it
  Point start;            ///< in lattice units
  Point end;              ///< in lattice units
  SegmentId predecessor;  ///< null if nothing that could precede arrives at `start`: only under a preserve relation
  SegmentId successor;    ///< null if nothing that could follow leaves `end`: only under a preserve relation
  Point ghost1;           ///< the predecessor's start; means nothing if `predecessor` is null
  Point ghost2;           ///< the successor's end; means nothing if `successor` is null
  Block block = 0;        ///< that of `polygon`
  PolygonHandle polygon;  ///< the polygon hit when this segment is hit
  Cell cell;              ///< the cell hit

  double length() const;       ///< in cells
  DoublePoint normal() const;  ///< outward, of length 1
};

/// The same in cells, from an origin of your choice: World::segments() writes it. Ghosts are those of Segment.
template <class Real>
struct RealSegment {
  SegmentId id;            ///< its name, until a commit removes it
  RealPoint<Real> start;   ///< from the origin
  RealPoint<Real> end;     ///< from the origin
  SegmentId predecessor;   ///< as in Segment
  SegmentId successor;     ///< as in Segment
  RealPoint<Real> ghost1;  ///< from the origin; means nothing if `predecessor` is null
  RealPoint<Real> ghost2;  ///< from the origin; means nothing if `successor` is null
  Block block = 0;         ///< that of `polygon`
  PolygonHandle polygon;   ///< the polygon hit when this segment is hit
  Cell cell;               ///< the cell hit
};
using FloatSegment = RealSegment<float>;    ///< in cells, as `float`
using DoubleSegment = RealSegment<double>;  ///< in cells, as `double`

/// What a commit did to the segments. No id is in two lists. A segment whose ends, owner and ghosts are as before is in
/// none. Ids in `removed` name nothing from now on. The order of each list follows from the edits since the last
/// commit, in their order: the same edits in another order may give the same segments other ids and places. Sort
/// them where another order matters.
///
/// The lists lead from one World::version() to another. Keep the version with a copy of the segments.
/// The lists fit the copy if `before` is that version; then `after` is the new one. So it shows when lists were left
/// out, applied twice, or are those of another world. Both are the same if the commit found nothing to do. Where they
/// are not, the lists may be empty: inside the ground polygons come and go without a segment.
struct Changes {
  std::vector<SegmentId> removed;   ///< alive before, and not any more
  std::vector<SegmentId> added;     ///< alive now, and not before
  std::vector<SegmentId> relinked;  ///< alive before and after, with another ghost1 or ghost2
  std::uint64_t before = 0;         ///< the version from which the lists lead
  std::uint64_t after = 0;          ///< the version to which they lead
};

/// One closed chain, in the direction of its segments (solid on the left).
struct Loop {
  std::vector<Point> vertices;      ///< from the least one on, by x, then y; the last edge leads back to it
  std::vector<SegmentId> segments;  ///< segments[k] starts at vertices[k]; empty if collinear ones were merged
};

/// What loops() does with a vertex where the outline goes straight on. merge drops it, but for a vertex that another
/// passage of the outline shares, of the same loop or of another one: two solids touch there, and a drawing or an
/// export that lost the vertex would lose the contact.
enum class Collinear : bool { keep, merge };

}  // namespace lgs
