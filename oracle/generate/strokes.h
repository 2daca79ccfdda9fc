// Random edits by brushes, among other edits.
#pragma once

#include "oracle/trace/trace.h"

#include <cstdint>

namespace lgs::oracle {

/// The trace with edits by brushes before some of its commits: circles, rectangles, thick lines and rings that cross
/// themselves, over several cells down to a few units, where the trace has its cells. Edits that come later may have to
/// be refused then. The same seed gives the same ones everywhere.
Trace withBrushes(Trace trace, std::uint64_t seed);

}  // namespace lgs::oracle
