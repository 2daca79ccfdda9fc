// Random ways to make edits.
#pragma once

#include "oracle/calls/random.h"
#include "oracle/trace/trace.h"

#include <span>

namespace lgs::oracle {

/// Chooses which of these edits one call makes, by which door, and with what detour. Where nothing is left to chance,
/// each edit is made by itself, in the plain way.
void chooseWays(std::span<Edit> edits, Random& random);

}  // namespace lgs::oracle
