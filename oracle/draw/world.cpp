#include "oracle/draw/colours.h"
#include "oracle/draw/draw.h"
#include "oracle/draw/legend.h"
#include "oracle/draw/panel.h"
#include "oracle/reference/words.h"

#include <algorithm>
#include <array>

namespace lgs::oracle {

using namespace drawing;

std::string drawWorld(const Scene& scene, const Outline& outline, const DrawOptions& options) {
  constexpr double kWidest = 1500;
  constexpr double kHighest = 960;
  const Extent extent = extentOf(scene, std::array{&outline, &options.marked}, options.edited, options.view);
  const Panel panel(extent, fittingCellSize(extent, kWidest, kHighest), {kMargin, kMargin + kHeadingHeight});

  const std::string title = shortened(options.title.empty() ? "World" : options.title);
  const std::string subtitle =
      scene.polygons.empty() && outline.empty()
          ? "empty world"
          : counted(scene.polygons.size(), "polygon") + ", " + counted(outline.size(), "boundary segment");
  std::vector<LegendEntry> entries;
  addBackdrop(entries, panel.plot, scene, options.edited);
  addOutlines(entries, panel.plot, std::array{&outline});
  if (!options.marked.empty()) entries.push_back(lineEntry("what is wrong", kActual, 5));

  constexpr double kNarrowest = 460;
  const double width = std::max({panel.width, headingWidth(title, subtitle), kNarrowest});
  const Legend legend(std::move(entries), width);
  const double legendTop = kMargin + kHeadingHeight + panel.height + 12;

  Svg svg(width + 2 * kMargin, legendTop + legend.height() + kMargin - 8, title, subtitle, kPage);
  drawHeading(svg, title, subtitle);
  drawBackdrop(svg, panel.plot, scene, options.edited, 1);
  drawOutline(svg, panel.plot, outline);
  if (!options.marked.empty()) {
    beginClip(svg, panel.plot);
    svg.path(segmentPath(panel.plot, options.marked), {{"stroke", kActual}, {"stroke-width", 5}});
    endClip(svg);
  }
  legend.draw(svg, {kMargin, legendTop});
  return std::move(svg).finish();
}

}  // namespace lgs::oracle
