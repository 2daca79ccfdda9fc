// One panel: the paper with its axes, the solids, an outline on top.
#pragma once

#include "oracle/draw/links.h"
#include "oracle/draw/plot.h"
#include "oracle/draw/svg.h"

#include <span>
#include <string_view>

namespace lgs::oracle::drawing {

/// Where a plot goes in its panel, and how large the panel is. The extent must outlive it.
struct Panel {
  Panel(const Extent& extent, double cellSize, Vec topLeft);
  Plot plot;
  double width;
  double height;
};

inline constexpr double kLabelSize = 11;
double textWidth(std::string_view text, double size);  ///< a generous guess, because the viewer chooses the font

/// Draws paper, solids, edited cells, grid and axes. `strength` is 1, or less where something more important comes on
/// top.
void drawBackdrop(Svg& svg, const Plot& plot, const Scene& scene, std::span<const Cell> edited, double strength);

/// What is drawn between these two is cut off at the rim of the paper.
void beginClip(Svg& svg, const Plot& plot);
void endClip(Svg& svg);

/// Draws the segments and, where there is room, their directions, normals, links, vertices and tooltips.
void drawOutline(Svg& svg, const Plot& plot, const Outline& outline);

/// A link as an arc around its vertex, with a head at its end.
struct TurnStyle {
  std::string_view colour;
  double width;
  std::string_view dashes = "none";  ///< of the arc; the head is always whole
};
class Turns {
 public:
  void add(Vec at, double fromAngle, double turn, double radius);  ///< radians, counter-clockwise from the east
  void draw(Svg& svg, const TurnStyle& style) const;

 private:
  Path arcs_;
  Path heads_;
};

/// Pieces of the above, for legends and for differences.
Outline segmentsInView(const Plot& plot, const Outline& outline);
Path segmentPath(const Plot& plot, std::span<const OutlineSegment> segments);
void drawLinks(Svg& svg, const Plot& plot, std::span<const Link> links, double radius, const TurnStyle& style);
void addArrowHead(Path& heads, Vec start, Vec end, double size);
void addNormal(Path& normals, Vec start, Vec end, double size);

}  // namespace lgs::oracle::drawing
