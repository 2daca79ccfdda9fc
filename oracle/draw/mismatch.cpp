#include "oracle/draw/colours.h"
#include "oracle/draw/difference.h"
#include "oracle/draw/draw.h"
#include "oracle/draw/panel.h"
#include "oracle/reference/words.h"

#include <algorithm>
#include <array>

namespace lgs::oracle {

using namespace drawing;

namespace {

constexpr double kGap = 26;  // between panels
constexpr double kPanelHeading = 24;
constexpr double kLineHeight = 19;  // of the list of differences
constexpr std::size_t kMostLines = 10;

std::vector<std::string> linesOf(const std::vector<Difference>& differences) {
  std::vector<std::string> lines;
  std::string text = describe(differences, kMostLines);
  for (std::size_t begin = 0, end = 0; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1) {
    lines.push_back(text.substr(begin, end - begin));
  }
  return lines;
}

// Where the three panels go: side by side, or one below the other if they are wide.
struct Layout {
  explicit Layout(const Extent& extent)
      : sideBySide(extent.columns.length() <= 2 * extent.rows.length()),
        cellSize(sideBySide ? fittingCellSize(extent, 1600.0 / 3, 760) : fittingCellSize(extent, 1400, 1100.0 / 3)) {}
  Vec topLeft(int index, const Panel& panel) const {
    const Vec step = sideBySide ? Vec{panel.width + kGap, 0} : Vec{0, panel.height + kPanelHeading + kGap / 2};
    return Vec{kMargin, kMargin + kHeadingHeight} + step * index;
  }
  bool sideBySide;
  double cellSize;
};

std::string draw(const Scene& scene, const Outline& expected, const Outline& actual,
                 const std::vector<Difference>& differences, const MismatchOptions& options) {
  const std::array outlines{&expected, &actual};
  const Extent whole = extentOf(scene, outlines, options.edited, {});
  constexpr double kSmall = 8;  // a world that is shown whole
  const bool small = whole.columns.length() <= kSmall && whole.rows.length() <= kSmall;
  const auto around = small ? std::nullopt : viewOf(differences);
  const Extent extent = extentOf(scene, outlines, options.edited, options.view ? options.view : around);
  const Layout layout(extent);
  const Panel first(extent, layout.cellSize, {});

  std::vector<Difference> inView;
  std::copy_if(differences.begin(), differences.end(), std::back_inserter(inView),
               [&](const Difference& d) { return first.plot.shows(cellsOf(d.segment())); });
  const std::string title = shortened(options.title.empty() ? "Mismatch" : options.title);
  std::string subtitle = differences.empty() ? "no difference" : counted(differences.size(), "difference");
  if (inView.size() < differences.size()) subtitle += ", " + std::to_string(inView.size()) + " in this view";

  std::vector<LegendEntry> entries;
  addSigns(entries, inView);
  addOutlines(entries, first.plot, outlines);
  addBackdrop(entries, first.plot, scene, options.edited);

  const std::vector<std::string> lines = linesOf(differences);
  const Vec last = layout.topLeft(2, first);
  double width = std::max(last.x + first.width - kMargin, headingWidth(title, subtitle));
  for (const std::string& line : lines) width = std::max(width, textWidth(line, 12.5));
  const Legend legend(std::move(entries), width);
  const double legendTop = last.y + kPanelHeading + first.height + 12;
  const double listTop = legendTop + legend.height() + 14;
  const double height = listTop + static_cast<double>(lines.size()) * kLineHeight + kMargin - 8;

  Svg svg(width + 2 * kMargin, height, title, subtitle, kPage);
  drawHeading(svg, title, subtitle);
  const auto panel = [&](int index, const std::string& name, std::string_view colour, double strength) {
    const Vec topLeft = layout.topLeft(index, first);
    const Panel placed(extent, layout.cellSize, topLeft + Vec{0, kPanelHeading});
    svg.text(topLeft + Vec{0, 13}, name, {{"font-size", 14}, {"font-weight", "600"}, {"fill", colour}});
    drawBackdrop(svg, placed.plot, scene, options.edited, strength);
    return placed.plot;
  };
  drawOutline(svg, panel(0, options.expectedName, kExpected, 1), expected);
  drawOutline(svg, panel(1, options.actualName, kActual, 1), actual);
  drawDifference(svg, panel(2, "difference", kInk, 0.4), actual, inView);
  legend.draw(svg, {kMargin, legendTop});
  svg.open("g", {{"font-size", 12.5}, {"fill", kInk}});
  for (std::size_t k = 0; k < lines.size(); ++k) {
    svg.text({kMargin, listTop + static_cast<double>(k + 1) * kLineHeight - 6}, lines[k], {});
  }
  svg.close();
  return std::move(svg).finish();
}

}  // namespace

std::string drawMismatch(const Scene& scene, const Outline& expected, const Outline& actual,
                         const MismatchOptions& options) {
  return draw(scene, expected, actual, compare(expected, actual), options);
}

std::string drawMismatch(const Scene& scene, const OwnedOutline& expected, const OwnedOutline& actual,
                         const MismatchOptions& options) {
  return draw(scene, expected.outline, actual.outline, compare(expected, actual), options);
}

}  // namespace lgs::oracle
