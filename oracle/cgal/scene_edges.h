// Finds out what CGAL's union does not carry: the owner of a segment, and where an edge is cut. It uses exact
// arithmetic on the scene's polygons alone.
#pragma once

#include "oracle/reference/scene.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace lgs::oracle {

class SceneEdges {
 public:
  explicit SceneEdges(const Scene& scene);  ///< keeps a reference to the scene

  /// The polygon with an edge that covers start→end, in this direction: an index into Scene::polygons. Throws
  /// std::invalid_argument if there is none.
  std::uint32_t owner(Point start, Point end) const;

  /// A polygon's vertices in the world, together with the vertices of all other polygons that lie on its edges.
  std::vector<Point> cutOutline(const ScenePolygon& polygon) const;

 private:
  template <class Visit>
  void forPolygonsNear(Point point, Visit visit) const;  // those of the closed cells that contain the point

  const Scene& scene_;
  std::vector<std::pair<Cell, std::uint32_t>> byCell_;  // sorted
};

}  // namespace lgs::oracle
