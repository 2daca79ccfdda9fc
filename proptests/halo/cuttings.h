// Cuttings of the plane into regions, by chance.
#pragma once

#include "examples/regions/cutting.h"
#include "oracle/calls/random.h"

#include <lgs/lattice.h>

namespace lgs::test {

/// All cells that there can be, cut at or near these ones: by a few cuts from rim to rim of a piece, by all of them, so
/// that there are regions of one cell, or like a pinwheel, which no such cuts can make.
regions::Cutting randomCutting(const CellRect& near, oracle::Random& random);

}  // namespace lgs::test
