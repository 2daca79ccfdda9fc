// The islands of a scene as the protocol of engines tells them, found by trying all pairs of polygons.
#pragma once

#include "oracle/reference/island.h"
#include "oracle/reference/scene.h"

#include <string>

namespace lgs::oracle {

NamedIslands namedIslands(const Scene& scene);

/// What differs, in words; empty if nothing does. Both are sorted.
std::string describeIslands(const NamedIslands& expected, const NamedIslands& actual);

}  // namespace lgs::oracle
