// Pictures of worlds and of mismatches, as SVG: self-contained (no external fonts, scripts or style sheets), on a
// background of their own, and the same bytes for the same input.
//
// What is drawn depends on how large a cell comes out on the picture:
//   up to 28 across   every segment with its direction, its outward normal and its links; vertices; tooltips;
//   up to 125 across  segments with direction and normal where there is room, vertices;
//   more              fine lines.
// (The picture of a mismatch has three panels, so a third of that fits.) All solids of a block are one path, so that
// the file stays small. Numbers at the axes are world coordinates in cells; y is up. Long stretches without content are
// folded away, so two cells at opposite ends of the world still make a readable picture.
#pragma once

#include "oracle/reference/outline.h"
#include "oracle/reference/scene.h"

#include <lgs/lattice.h>

#include <optional>
#include <string>
#include <vector>

namespace lgs::oracle {

struct DrawOptions {
  std::string title;             ///< any text, UTF-8; empty: a plain default
  std::vector<Cell> edited;      ///< cells to highlight, e.g. those edited last; any order, may be empty
  std::optional<CellRect> view;  ///< the cells to show; by default everything, or what surrounds the differences
  Outline marked;                ///< segments to point out; drawWorld() only
};

/// Draws the solids of a scene, and an outline with its normals and links. The outline is drawn as it is given, right
/// or wrong.
std::string drawWorld(const Scene& scene, const Outline& outline, const DrawOptions& options = {});

struct MismatchOptions : DrawOptions {
  std::string expectedName = "expected";  ///< heading of the first panel, e.g. "CGAL"
  std::string actualName = "actual";      ///< heading of the second panel, e.g. "engine"
};

/// Draws two outlines of one scene and what differs (compare.h): three panels (expected, actual, the difference), and
/// the first few differences in words. Of a large world the panels show the cells around the differences. In the third
/// panel
///   a segment that is missing from `actual` is blue and dashed, one that only `actual` has is orange;
///   a vertex where links differ has a ring, with the expected link (blue, dashed) and the actual one (orange).
std::string drawMismatch(const Scene& scene, const Outline& expected, const Outline& actual,
                         const MismatchOptions& options = {});
std::string drawMismatch(const Scene& scene, const OwnedOutline& expected, const OwnedOutline& actual,
                         const MismatchOptions& options = {});

}  // namespace lgs::oracle
