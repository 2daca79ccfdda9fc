// Draws the difference of two outlines on top of a plot.
#pragma once

#include "oracle/draw/legend.h"
#include "oracle/draw/plot.h"
#include "oracle/reference/compare.h"

#include <optional>
#include <span>
#include <vector>

namespace lgs::oracle::drawing {

/// The cells around the differences. If these are too far apart for one picture, only those near the first one count.
/// Nothing if there are no differences: show the whole world.
std::optional<CellRect> viewOf(std::span<const Difference> differences);

void drawDifference(Svg& svg, const Plot& plot, const Outline& actual, std::span<const Difference> differences);

/// Adds the signs that drawDifference() uses for these differences.
void addSigns(std::vector<LegendEntry>& entries, std::span<const Difference> differences);

}  // namespace lgs::oracle::drawing
