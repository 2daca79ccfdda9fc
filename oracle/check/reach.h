// Law 9: whether a brush reaches a polygon.
#pragma once

#include "oracle/reference/brush_edit.h"
#include "oracle/reference/scene.h"
#include "oracle/trace/player.h"

#include <string>

namespace lgs::oracle {

/// Whether the region, with its outline, may have a point in common with a polygon. Rings that enclose nothing count as
/// well. The polygon must be in a cell of the region's box.
bool mayMeet(const BrushEdit& brush, const ScenePolygon& polygon);

/// Which polygon a brush has changed without reaching it, and without telling that it is bent, or tells of that though it
/// reaches it; empty if there is none.
std::string wrongReach(const BrushEdit& brush, const Brushed& done);

}  // namespace lgs::oracle
