// Random edits by brushes, among other edits.
#pragma once

#include "oracle/calls/call.h"
#include "oracle/calls/random.h"

#include <vector>

namespace lgs::oracle {

/// A stroke at a cell: circles, rectangles, thick lines and rings that cross themselves, over several cells down to a few
/// units. A thick line has a call for each of its parts.
std::vector<Call> strokeAt(Cell cell, Block block, Random& random);

}  // namespace lgs::oracle
