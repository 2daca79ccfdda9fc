// Which polygons have a point, or a part of an edge, in common, found by trying all pairs.
#pragma once

#include "oracle/reference/scene.h"

#include <cstddef>
#include <vector>

namespace lgs::oracle {

/// Whether two closed polygons have a point in common.
bool haveCommonPoint(const ScenePolygon& one, const ScenePolygon& other);

/// Whether a part of an edge of one, longer than a point, lies on an edge of the other, which runs the other way.
bool haveCommonEdge(const ScenePolygon& one, const ScenePolygon& other);

/// For each polygon the number of the set that it hangs together with: the index of the first one of them.
std::vector<std::size_t> setsOf(const std::vector<ScenePolygon>& polygons);

}  // namespace lgs::oracle
