// The oracle of brushes: what strokes make of regions, exactly, and how far an outline is from that.
#pragma once

#include "oracle/reference/brush_edit.h"
#include "oracle/reference/outline.h"
#include "oracle/reference/scene.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace lgs::oracle {

struct FarOff {
  std::string text;  ///< what is missing, or extra, and where
  Outline exact;     ///< the outline of each block of the exact result, rounded
};

/// Law 8: whether the regions after some strokes differ from the exact result in a point that is farther than `units`
/// from every edge of that result. Each block is compared by itself, with the edges of all blocks; and the solid as a
/// whole, with the edges of the solid alone: a seam between two blocks would be far from those (law 10).
///
/// An outline is closed curves, for each block by itself, in any pieces; the solid is on their left, and they run around
/// it once. Whatever segment is farther than that from the edges is wrong, too: it bounds nothing.
std::optional<FarOff> farFromExact(const Outline& before, std::span<const BrushEdit> strokes, const Outline& after,
                                   std::int64_t units);

/// The same of the polygons before and after a stroke, and of one unit. What is wrong, if anything is.
std::optional<std::string> farFromExact(const Scene& before, const BrushEdit& edit, const Scene& after);

/// Law 10: ground of one block from which a region was carved, and which was then filled with the same region. Says
/// where that has left a seam, farther than two units (one for each stroke) from every edge of the ground of that block.
/// Nothing, if the region is not all in it. The scenes are as before the first stroke and after the second one.
std::optional<std::string> seamIn(const Scene& before, const BrushEdit& filled, const Scene& after);

}  // namespace lgs::oracle
