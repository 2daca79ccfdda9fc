// Reads the outline: its segments, its loops, and what it answers about places. Nothing here changes it.
#pragma once

#include "outline/outline.h"

#include <lgs/world.h>

#include <span>
#include <vector>

namespace lgs::detail {

/// A segment that is alive.
Segment segmentOf(const Grid& grid, const Outline& outline, std::uint32_t id);
/// By id.
std::vector<SegmentId> liveSegments(const Outline& outline);
std::vector<SegmentId> segmentsIn(const Grid& grid, const Outline& outline, const CellRect& cells);
std::vector<Loop> loopsOf(const Grid& grid, const Outline& outline, Collinear collinear);

// questions.cpp
Expected<Nearest> nearest(const Grid& grid, const Outline& outline, Point p, double radius);
Expected<RayHit> rayCast(const Grid& grid, const Outline& outline, Point from, Point to);

}  // namespace lgs::detail
