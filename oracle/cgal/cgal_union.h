// The oracle: CGAL unites the whole world, with exact arithmetic and without the grid. The boundaries and their
// adjacency are read from the union's arrangement.
#pragma once

#include "oracle/reference/canonical.h"
#include "oracle/reference/compare.h"
#include "oracle/reference/outline.h"
#include "oracle/reference/scene.h"

#include <optional>
#include <vector>

namespace lgs::oracle {

struct CgalUnion : OwnedOutline {
  /// Which links the union knows. With one material it knows all of them. Of several materials each is united by
  /// itself, but law 2 links among all segments at a vertex, whatever their material. So a link is known only where all
  /// segments at its vertex are of one material. `withUnknownLinksOf` (compare.h) leaves the others out of a
  /// comparison.
  std::vector<KnownLinks> known;

  /// The boundary cycles of the free faces, with the solid on the left, of each material by itself. With one material
  /// their canonical form equals that of the outline's links.
  Loops loops;
};

/// Returns nothing if the preserve relation does not partition the scene's blocks (materials(), scene.h). The scene
/// must be valid. Throws std::invalid_argument if it finds that polygons cross.
std::optional<CgalUnion> cgalUnion(const Scene& scene);

}  // namespace lgs::oracle
