// What must come of a world's polygons, worked out the slow way.
#pragma once

#include "oracle/reference/outline.h"
#include "oracle/reference/scene.h"

#include <lgs/world.h>

namespace lgs::test {

/// What the laws make of a world's polygons, by the naive reference.
oracle::Outline outlineByLaws(const World& world, const oracle::PreservePairs& preserve);

}  // namespace lgs::test
