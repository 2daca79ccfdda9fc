// Which polygons have a point in common, found by trying all pairs.
#pragma once

#include "oracle/reference/scene.h"

#include <cstddef>
#include <vector>

namespace lgs::oracle {

/// Whether two closed polygons have a point in common.
bool haveCommonPoint(const ScenePolygon& one, const ScenePolygon& other);

/// For each polygon the number of the set that it hangs together with: the index of the first one of them.
std::vector<std::size_t> setsOf(const std::vector<ScenePolygon>& polygons);

}  // namespace lgs::oracle
