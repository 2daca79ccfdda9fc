// Law 2 for any directed edges: which edge comes before each one, and which after it.
//
//   const lgs::Point points[] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
//   const lgs::DirectedEdge edges[] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
//   const auto links = lgs::radialMatch(points, edges);
//   if (!links) return refused(links.error());
//   (*links)[0].successor;            // 1
//   lgs::loopsOf(*links);             // {{0, 1, 2, 3}}
//
// This is phase 2 of the engine without the grid. The solid lies on the left of each edge. Where two solids touch in a
// point, a loop turns through the free wedge, from one solid to the other. Uses:
//
// - Contours: marching squares, or the sides between solid and free pixels, give loose edges; the loops are outlines.
// - Meshes: of all directed sides of counter-clockwise triangles leave out each whose reverse is there too.
// - Faces of a planar graph: give each edge in both directions, without dangling edges; each loop has its face on the
//   right.
// - Ghost vertices for levels drawn as lines.
//
// Crossings are not found: that is an overlay, and lgs/brush.h makes one for regions.
// oracle/check/laws/edges.cpp holds it to law 2, and its loops to those of outlines.
#pragma once

#include <lgs/error.h>
#include <lgs/lattice.h>

#include <cstdint>
#include <span>
#include <vector>

namespace lgs {

/// An edge from one point to another one, by their indices.
struct DirectedEdge {
  std::uint32_t from = 0;  ///< index of the point where it starts
  std::uint32_t to = 0;    ///< index of the point where it ends
  friend constexpr bool operator==(const DirectedEdge&, const DirectedEdge&) = default;
};

/// No edge.
inline constexpr std::uint32_t kNoEdge = 0xffff'ffff;

/// No edge is longer than this, along either axis: 2^30 lattice units. It keeps the predicates exact in 64 bits.
inline constexpr std::int64_t kMaxEdgeLength = std::int64_t{1} << 30;

/// The neighbours of an edge, by index, or kNoEdge.
struct EdgeLinks {
  std::uint32_t predecessor = kNoEdge;  ///< the edge that leads to its start
  std::uint32_t successor = kNoEdge;    ///< the edge that goes on from its end
  friend constexpr bool operator==(const EdgeLinks&, const EdgeLinks&) = default;
};

/// Links each edge at its ends. At a point, the predecessor of an outgoing edge is the incoming edge met first when
/// turning clockwise from it, by an angle in (0, 2π); the successor of an incoming edge is the outgoing one met first
/// when turning counter-clockwise. A direction that coincides exactly is skipped. Of candidates that coincide, it is
/// the one with the greatest index for a predecessor, with the least one for a successor. If there is no candidate,
/// there is no link.
///
/// Two indices are two points, even if they are in the same place. Edges may cross: that makes no vertex. Where
/// incoming and outgoing edges alternate around each point, as on the outline of any area, links are mutual.
///
/// Refused: outOfReach, if an edge has an index beyond the points, a point beyond the last cell (inRange()), no length,
/// or a length beyond kMaxEdgeLength: Error::index is the edge; capacity, if there are 2^31 edges or more.
///
/// Cost: O(n log d) for n edges, at most d of them at a point, and O(p) for p points.
[[nodiscard]] Expected<std::vector<EdgeLinks>> radialMatch(std::span<const Point> points,
                                                           std::span<const DirectedEdge> edges);

/// The loops of links that are mutual: each is a list of edges, its least one first, each followed by its successor.
/// They are sorted by their first edges. What is in no loop is left out. `links` are as radialMatch() makes them;
/// others do no harm, and a link to an edge that is not there is none. Cost: O(n).
[[nodiscard]] std::vector<std::vector<std::uint32_t>> loopsOf(std::span<const EdgeLinks> links);

}  // namespace lgs
