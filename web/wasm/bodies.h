// Bodies of ground as numbers, for islands.cpp and ground.cpp. web/package/src/ground-body.ts is the other side.
#pragma once

#include "bridge.h"

#include <lgs/falling.h>

#include <span>

namespace lgs::web {

/// Adds a body to the answer: how many numbers follow, i, j of the origin, area, centroid, second moment, and the
/// polygons, as bodyOf() reads them.
void putBody(const Body& body);

/// The polygons of a body, each as i, j, block, the number of its vertices, and these in cells.
Body bodyOf(std::span<const double> in);

}  // namespace lgs::web
