// The views of a world, recomputed as a whole from its polygons, the slow and obvious way. Nothing of a view's own code
// is used: the outline is the naive reference's, without any preserve relation.
#pragma once

#include "oracle/reference/scene.h"

#include <lgs/lattice.h>
#include <lgs/world.h>

#include <string>
#include <utility>
#include <vector>

namespace lgs::oracle {

__extension__ using Wide = __int128;

/// In decimal digits.
std::string inWords(Wide number);

/// All polygons of a world; nothing is preserved.
Scene bareScene(const World& world);

using Edge = std::pair<Point, Point>;

/// A loop, found by walking all links.
struct WalkedLoop {
  std::vector<Point> vertices;
  Wide doubleArea = 0;
  Point min, max, west;

  std::vector<Edge> edges() const;  ///< in the order of the loop
};

/// All loops of a scene.
std::vector<WalkedLoop> walkedLoops(const Scene& scene);

}  // namespace lgs::oracle
