// The difference of two outlines, drawn on top of a plot.
#pragma once

#include "oracle/draw/legend.h"
#include "oracle/draw/plot.h"
#include "oracle/reference/compare.h"

#include <optional>
#include <span>
#include <vector>

namespace lgs::oracle::drawing {

/// The neighbourhood of the differences: all of them, or those around the first if they are too far apart for one
/// picture. Nothing (show everything) without differences.
std::optional<CellRect> viewOf(std::span<const Difference> differences);

void drawDifference(Svg& svg, const Plot& plot, const Outline& actual, std::span<const Difference> differences);

/// The signs that occur in these differences.
void addSigns(std::vector<LegendEntry>& entries, std::span<const Difference> differences);

}  // namespace lgs::oracle::drawing
