// A case of a suite as strokes of a brush.
#pragma once

#include "oracle/suites/suite.h"
#include "oracle/trace/trace.h"

#include <string>
#include <tl/expected.hpp>

namespace lgs::oracle {

struct Strokes {
  Trace trace;             ///< a commit after each operand
  bool isRounded = false;  ///< a coordinate is on no lattice on which the case is small enough
  bool isEvenOdd = false;  ///< its rule can not be said by strokes: they play its rings by the even-odd rule
};

/// A union paints each operand; a difference paints the first and carves the others; an intersection with B carves what
/// the rings of A and B together enclose an odd number of times, A xor B; and xor paints all rings at once. The case is
/// moved, and magnified by a power of two: it is four to eight cells wide, or up to 64 if it is on a lattice only then.
/// Why not, in words, if it has no area, or more vertices or crossings than may be.
tl::expected<Strokes, std::string> strokesOf(const SuiteCase& of);

}  // namespace lgs::oracle
