// An outline: the boundary segments of a scene, with their ghost vertices. The engine, the naive reference and CGAL are
// all read into this form, so that they can be compared.
#pragma once

#include <lgs/ids.h>
#include <lgs/lattice.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace lgs::oracle {

struct OutlineSegment {
  Point start;
  Point end;
  Block block = 0;
  std::optional<Point> ghost1;
  std::optional<Point> ghost2;
  friend auto operator<=>(const OutlineSegment&, const OutlineSegment&) = default;
};

/// Sorted by start, end, block.
using Outline = std::vector<OutlineSegment>;

/// An outline, and the owner of each segment.
struct OwnedOutline {
  Outline outline;
  std::vector<std::uint32_t> owner;  ///< owner[k]: the polygon of outline[k], an index into Scene::polygons
};

}  // namespace lgs::oracle
