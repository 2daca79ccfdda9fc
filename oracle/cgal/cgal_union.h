// The oracle: CGAL unites the whole world, with exact arithmetic and nothing of the grid in it, and the boundaries and
// their adjacency are read from the union's arrangement.
#pragma once

#include "oracle/reference/canonical.h"
#include "oracle/reference/compare.h"
#include "oracle/reference/outline.h"
#include "oracle/reference/scene.h"

#include <optional>
#include <vector>

namespace lgs::oracle {

struct CgalUnion : OwnedOutline {
  /// Which links the union can vouch for; all of them unless the scene has several materials. Each material is united by
  /// itself, but law 2 links among all segments at a vertex, whatever their material. So a link is known where all the
  /// segments at its vertex are of one material. `withUnknownLinksOf` (compare.h) makes a comparison heed it.
  std::vector<KnownLinks> known;

  /// The boundary cycles of the free faces, with the solid on the left, of each material by itself. With one material
  /// their canonical form equals that of the outline's links.
  Loops loops;
};

/// Nothing if the preserve relation does not partition the scene's blocks (materials(), scene.h). The scene must be
/// valid; std::invalid_argument if its polygons are seen to cross.
std::optional<CgalUnion> cgalUnion(const Scene& scene);

}  // namespace lgs::oracle
