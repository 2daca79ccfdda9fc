// Simpler polygons, and simpler regions of brushes, in the place of one: for shrinking.
#pragma once

#include "oracle/reference/brush_edit.h"
#include "oracle/reference/validity.h"

#include <cstddef>
#include <optional>

namespace lgs::oracle {

/// How many variants of a polygon there are to try, the simplest ones first.
std::size_t variantsOf(const LocalPolygon& polygon);

/// The variant with this number; nothing if it is not simpler. It is made only here, as a polygon of thousands of
/// vertices has too many variants to keep. A variant is simpler if it has fewer vertices or, with as many, rounder
/// coordinates.
std::optional<LocalPolygon> simplerPolygon(const LocalPolygon& polygon, std::size_t variant);

/// The same of an edit by a brush: without a ring, then with fewer vertices, then on rounder coordinates.
std::size_t variantsOf(const BrushEdit& brush);
std::optional<BrushEdit> simplerBrush(const BrushEdit& brush, std::size_t variant);

}  // namespace lgs::oracle
