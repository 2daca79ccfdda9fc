// The dump: a world's output as text, one line a segment, in world lattice integers.
//
//   segment <sx> <sy> <ex> <ey> <g1x> <g1y> <g2x> <g2y> <block>
//
// Sorted by start, end, block as numbers; a missing ghost is `- -`. Equal outlines have equal dumps.
#pragma once

#include "oracle/reference/outline.h"

#include <lgs/world.h>
#include <string>

namespace lgs::oracle {

/// What the engine put out at its last commit, read through its public interface.
Outline outlineOf(const World& world);

/// One segment of that.
OutlineSegment outlineSegment(const Segment& segment);

std::string dump(const Outline& outline);

}  // namespace lgs::oracle
