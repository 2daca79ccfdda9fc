// Strokes of brushes as arguments of laws, on ground of 3×3 cells.
#pragma once

#include "oracle/calls/caller.h"
#include "oracle/cgal/brushed.h"
#include "oracle/trace/trace.h"
#include "oracle/views/recompute.h"
#include "proptests/support/arbitrary.h"

#include <lgs/brush.h>
#include <map>
#include <vector>

namespace lgs::test {

using oracle::bareScene;
using oracle::stroke;
using Deed = oracle::BrushEdit::Deed;
using Strokes = std::vector<oracle::BrushEdit>;

/// What the cells (0, 0) … (2, 2) hold at first: one polygon, or two with an edge between them. `slanted` has
/// three blocks, the others have one.
enum class Ground : std::uint8_t { solid, slanted, halved };

/// A stroke around the corner (1, 1) of four cells, most with vertices on a lattice of their own: its region counts.
struct AnyRegion : oracle::Trace {
  Region region() const { return oracle::regionOf(calls.at(0).brush); }
  static rc::Gen<AnyRegion> arbitrary();
};

World worldOf(Ground ground);

/// A polygon as it stands.
struct Standing {
  Cell cell;
  Block block = 0;
  std::vector<LocalPoint> vertices;
  friend bool operator==(const Standing&, const Standing&) = default;
};
std::map<PolygonHandle, Standing> standingIn(const World& world);

}  // namespace lgs::test
