// The naive reference: the laws of linking and exposure, word for word, on 64-bit integers.
//
//   1. Cut every polygon edge at every vertex of any polygon that lies on it: atomic edges.
//   2. The atomic edge u→v of p is exposed unless some polygon q owns v→u and preserve(block p, block q) is false.
//   3. At a vertex, an outgoing segment's predecessor is the exposed incoming one met first when turning clockwise from
//      it, an incoming segment's successor the outgoing one met first when turning counter-clockwise; a coincident
//      direction is skipped.
//
// It recomputes everything, and takes any preserve relation. Of the grid it uses only that a polygon lies inside its
// cell. Cost: O(n log n) for n polygons of bounded size spread over the cells.
#pragma once

#include "oracle/reference/outline.h"
#include "oracle/reference/scene.h"

#include <cstdint>
#include <span>
#include <vector>

namespace lgs::oracle {

/// Keeps its buffers from one scene to the next, so use one object for many scenes. Scenes must be valid (scene.h).
class NaiveReference {
 public:
  /// The result belongs to the object and stays valid until the next call.
  const OwnedOutline& operator()(const Scene& scene);

 private:
  using Index = std::uint32_t;  // of a vertex in vertices_, of an edge in edges_, of a polygon in the scene
  struct AtomicEdge {
    Index from;
    Index to;
    Index owner;
    bool exposed;
  };

  void collectVertices(const Scene& scene);
  void cutEdges(const Scene& scene);
  void cutEdge(Point a, Point b, Index owner);
  void expose(const Scene& scene);
  void linkAndSort(const Scene& scene);

  std::vector<Point> vertices_;  // distinct; by column of cells, then y, then x
  std::vector<AtomicEdge> edges_;

  // The edges that leave a vertex v, or those that arrive there, are list[starts[v]] to list[starts[v + 1] - 1].
  struct EdgesByVertex {
    std::vector<Index> starts;
    std::vector<Index> list;
    std::span<const Index> operator[](Index v) const {
      return std::span(list).subspan(starts[v], starts[v + 1] - starts[v]);
    }
    void group(const std::vector<AtomicEdge>& edges, Index AtomicEdge::*vertex, std::size_t vertexCount);
  };
  EdgesByVertex leaving_;
  EdgesByVertex arriving_;

  struct Cut {
    std::int64_t along;  // how far on the edge that is being cut
    Index vertex;
  };
  std::vector<Index> nearby_;  // vertices in the closed cell of the polygon that is being cut
  std::vector<Cut> cuts_;
  std::vector<Index> order_;  // exposed edges by start, end
  OwnedOutline result_;
};

/// An outline with the ghosts that law 2 gives to its segments, whatever they were. Segments are shorter than 16,384
/// cells.
Outline linked(Outline outline);

/// The same for a single scene.
Outline naiveOutline(const Scene& scene);

}  // namespace lgs::oracle
