// Random edits by brushes, among other edits.
#pragma once

#include "oracle/calls/call.h"
#include "oracle/calls/random.h"

#include <span>
#include <vector>

namespace lgs::oracle {

/// A stroke at a cell, of one of these blocks, and around another one now and then: circles, stars, rectangles, thick
/// lines and rings that cross themselves, over several cells down to a few units; or as long as a region may be. A thick
/// line is one call, or one for each of its parts.
std::vector<Call> strokeAt(Cell cell, std::span<const Block> blocks, Random& random);

}  // namespace lgs::oracle
