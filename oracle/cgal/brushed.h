// The oracle of brushes: CGAL's Boolean set operations, with exact numbers, and how far a world is from their result.
#pragma once

#include "oracle/reference/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace lgs::oracle {

/// One edit by a brush: the region's vertices are lattice points.
struct BrushEdit {
  enum class Deed { carve, fill, replace };
  Deed deed = Deed::carve;
  Block block = 0;
  std::vector<std::vector<Point>> rings;
  /// Inside is where the rings run around an odd number of times. Otherwise all rings must be simple and
  /// counter-clockwise, and are united.
  bool isEvenOdd = true;
};

/// Law 8: says where the polygons after an edit differ from the exact result in a point that is farther than one
/// lattice unit from every edge of that result. Each block is compared by itself, with the edges of all blocks; and
/// the solid as a whole, with the edges of the solid alone: a seam between two blocks would be far from those (law 10).
std::optional<std::string> farFromExact(const Scene& before, const BrushEdit& edit, const Scene& after);

}  // namespace lgs::oracle
