// The polygons of a world as edits that make them.
#pragma once

#include "oracle/trace/trace.h"

#include <lgs/world.h>

namespace lgs::oracle {

/// An `add` for each polygon, by rows, and a commit. A world does not know the names that it was made with: they are p1, p2 …
Trace traceOf(const World& world);

}  // namespace lgs::oracle
