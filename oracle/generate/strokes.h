// Random edits by brushes, among other edits.
#pragma once

#include "oracle/calls/call.h"
#include "oracle/calls/random.h"

#include <optional>
#include <span>
#include <vector>

namespace lgs::oracle {

/// All rings of a case have their vertices near one point, on a lattice with a step of its own: so each stroke meets what
/// the others have left.
struct Tight {
  Point centre;
  std::int64_t step = 1;  ///< units
};
Tight tightAt(Point centre, Random& random);

/// A stroke at a cell, of one of these blocks, and around another one now and then: circles, stars, rectangles, thick
/// lines and rings that cross themselves, over several cells down to a few units; or as long as a region may be. A thick
/// line is one call, or one for each of its parts; what is carved may be filled again.
std::vector<Call> strokeAt(Cell cell, std::span<const Block> blocks, const std::optional<Tight>& tight, Random& random);

}  // namespace lgs::oracle
