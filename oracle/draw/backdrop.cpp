#include "oracle/draw/colours.h"
#include "oracle/draw/panel.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace lgs::oracle::drawing {

namespace {

constexpr double kAxisGap = 7;      // between the paper and its labels
constexpr double kAxisHeight = 22;  // below the paper

// The room between the outermost cells and the rim of the paper. Arrows and links of the outermost segments go there.
double padding(Detail detail) { return detail == Detail::full ? 22 : 8; }

double axisLabelWidth(const Axis& axis) {
  double width = 0;
  for (const auto& s : axis.stretches()) {
    for (const std::int64_t cell : {s.first, s.last + 1}) {
      width = std::max(width, textWidth(std::to_string(cell), kLabelSize));
    }
  }
  return std::ceil(width);  // whole pixels keep the grid crisp
}

// The least of 1, 2, 5, 10, 20, … cells that leaves this many pixels.
std::int64_t labelStep(double cellSize, double pixels) {
  for (std::int64_t ten = 1;; ten *= 10) {
    for (const std::int64_t step : {ten, 2 * ten, 5 * ten}) {
      if (static_cast<double>(step) * cellSize >= pixels) return step;
    }
  }
}

// The grid lines at multiples of the step, at least one in each stretch.
std::vector<std::int64_t> linesOf(const Axis& axis, std::int64_t step) {
  std::vector<std::int64_t> lines;
  for (const auto& s : axis.stretches()) {
    const std::int64_t rest = ((s.first % step) + step) % step;
    const std::int64_t multiple = rest == 0 ? s.first : s.first - rest + step;
    if (multiple > s.last + 1) lines.push_back(s.first);
    for (std::int64_t line = multiple; line <= s.last + 1; line += step) lines.push_back(line);
  }
  return lines;
}

struct Paper {
  explicit Paper(const Plot& plot)
      : pad(padding(plot.detail())),
        corner(plot.corner() - Vec{pad, pad}),
        width(plot.width() + 2 * pad),
        height(plot.height() + 2 * pad) {}
  double pad;
  Vec corner;
  double width;
  double height;
};

void drawSolids(Svg& svg, const Plot& plot, const Scene& scene, double strength) {
  std::map<Block, Path> solids;
  for (const ScenePolygon& p : scene.polygons) {
    if (!plot.shows(cellsOf(p.cell)) || p.vertices.empty()) continue;
    Path& path = solids[p.block];
    path.moveTo(plot.at(toWorld(p.cell, p.vertices[0])));
    for (std::size_t k = 1; k < p.vertices.size(); ++k) path.lineTo(plot.at(toWorld(p.cell, p.vertices[k])));
    path.close();
  }
  // Seams between polygons are drawn where there is room for them. Elsewhere they would be noise.
  const double seams = plot.detail() == Detail::lines ? 0 : 0.16 * strength;
  const auto fills = fillsOf(scene);
  svg.open("g", {{"fill-opacity", strength}, {"stroke", kInk}, {"stroke-opacity", seams}});
  for (const auto& [block, path] : solids) svg.path(path, {{"fill", fills.at(block)}});
  svg.close();
}

void drawGrid(Svg& svg, const Plot& plot) {
  const double cell = plot.cellSize();
  const std::int64_t step = cell >= 4 ? 1 : labelStep(cell, 40);
  const Axis& columns = plot.extent().columns;
  const Axis& rows = plot.extent().rows;
  Path grid;
  for (const std::int64_t line : linesOf(columns, step)) {
    const double x = plot.column(line * kUnitsPerCell);
    for (const auto& s : rows.stretches()) {
      grid.line({x, plot.row(s.first * kUnitsPerCell)}, {x, plot.row((s.last + 1) * kUnitsPerCell)});
    }
  }
  for (const std::int64_t line : linesOf(rows, step)) {
    const double y = plot.row(line * kUnitsPerCell);
    for (const auto& s : columns.stretches()) {
      grid.line({plot.column(s.first * kUnitsPerCell), y}, {plot.column((s.last + 1) * kUnitsPerCell), y});
    }
  }
  const double opacity = plot.detail() == Detail::lines ? 0.25 : 0.5;
  svg.path(grid, {{"stroke", kGrid}, {"stroke-width", 0.75}, {"stroke-opacity", opacity}});
}

// The folded stretches, as if the paper were in several pieces.
void drawFolds(Svg& svg, const Plot& plot, const Paper& paper) {
  constexpr double kShare = 0.4;  // of the fold; the rest is paper on both sides
  Path folds;
  const Axis& columns = plot.extent().columns;
  const double width = columns.fold() * plot.cellSize();
  for (std::size_t k = 1; k < columns.stretches().size(); ++k) {
    const double middle = plot.corner().x + columns.stretches()[k].position * plot.cellSize() - width / 2;
    folds.rect({middle - width * kShare / 2, paper.corner.y - 1}, width * kShare, paper.height + 2);
  }
  const Axis& rows = plot.extent().rows;
  const double height = rows.fold() * plot.cellSize();
  for (std::size_t k = 1; k < rows.stretches().size(); ++k) {
    const double middle = plot.bottom() - rows.stretches()[k].position * plot.cellSize() + height / 2;
    folds.rect({paper.corner.x - 1, middle - height * kShare / 2}, paper.width + 2, height * kShare);
  }
  svg.path(folds, {{"fill", kPage}});
}

void drawAxes(Svg& svg, const Plot& plot, const Paper& paper) {
  const Axis& columns = plot.extent().columns;
  const double width = axisLabelWidth(columns);
  const double below = paper.corner.y + paper.height + kAxisGap + kLabelSize * 0.8;
  double free = 0;  // where the next label may begin; labels on both sides of a fold can come too close
  svg.open("g", {{"font-size", kLabelSize}, {"fill", kMuted}, {"text-anchor", "middle"}});
  for (const std::int64_t line : linesOf(columns, labelStep(plot.cellSize(), width + 14))) {
    const double x = plot.column(line * kUnitsPerCell);
    if (x - width / 2 < free) continue;
    svg.text({x, below}, std::to_string(line), {});
    free = x + width / 2 + 4;
  }
  svg.close();

  const Axis& rows = plot.extent().rows;
  free = paper.corner.y + paper.height + kLabelSize;  // upwards
  svg.open("g", {{"font-size", kLabelSize}, {"fill", kMuted}, {"text-anchor", "end"}});
  for (const std::int64_t line : linesOf(rows, labelStep(plot.cellSize(), 2 * kLabelSize))) {
    const double y = plot.row(line * kUnitsPerCell) + kLabelSize * 0.36;
    if (y > free) continue;
    svg.text({paper.corner.x - kAxisGap, y}, std::to_string(line), {});
    free = y - kLabelSize - 2;
  }
  svg.close();
}

Vec plotOffset(const Extent& extent, Detail detail) {
  return {axisLabelWidth(extent.rows) + kAxisGap + padding(detail), padding(detail)};
}

}  // namespace

double textWidth(std::string_view text, double size) {
  double width = 0;
  for (const char c : text) {
    if ((static_cast<unsigned char>(c) & 0xC0) == 0x80) continue;  // not the first byte of a character
    width += std::string_view("fijlrt.,:;'|!()[] ").find(c) != std::string_view::npos ? 0.38 : 0.65;
  }
  return width * size;
}

Panel::Panel(const Extent& extent, double cellSize, Vec topLeft)
    : plot(extent, cellSize, topLeft + plotOffset(extent, Plot(extent, cellSize, {}).detail())),
      width(plot.corner().x - topLeft.x + plot.width() + padding(plot.detail())),
      height(plot.height() + 2 * padding(plot.detail()) + kAxisHeight) {}

void drawBackdrop(Svg& svg, const Plot& plot, const Scene& scene, std::span<const Cell> edited, double strength) {
  const Paper paper(plot);
  svg.leaf("rect", {{"x", paper.corner.x},
                    {"y", paper.corner.y},
                    {"width", paper.width},
                    {"height", paper.height},
                    {"rx", 3},
                    {"fill", kPaper},
                    {"stroke", kGrid},
                    {"stroke-opacity", 0.35}});
  beginClip(svg, plot);
  drawSolids(svg, plot, scene, strength);
  drawGrid(svg, plot);
  const bool fine = plot.detail() == Detail::lines;
  // The mark stays well inside the cell, so that it does not hide walls along the rim.
  const double inset = fine ? 0 : std::min(6.0, plot.cellSize() / 6);
  Path cells;
  for (const Cell& c : edited) {
    if (!plot.shows(cellsOf(c))) continue;
    const Vec upperLeft = plot.at(toWorld(c, {0, kUnitsPerCell}));
    cells.rect(upperLeft + Vec{inset, inset}, plot.cellSize() - 2 * inset, plot.cellSize() - 2 * inset);
  }
  svg.path(cells, {{"fill", kEdited},
                   {"fill-opacity", fine ? 0.6 : 0.07},
                   {"stroke", kEdited},
                   {"stroke-width", 1.75},
                   {"stroke-dasharray", fine ? "none" : "5 3"}});
  endClip(svg);
  drawFolds(svg, plot, paper);
  drawAxes(svg, plot, paper);
}

void beginClip(Svg& svg, const Plot& plot) {
  // A nested picture, not a clip path: that needs an id, and ids clash where pictures share a page.
  const Paper paper(plot);
  svg.open("svg", {{"x", paper.corner.x},
                   {"y", paper.corner.y},
                   {"width", paper.width},
                   {"height", paper.height},
                   {"viewBox", number(paper.corner.x) + " " + number(paper.corner.y) + " " + number(paper.width) + " " +
                                   number(paper.height)}});
}

void endClip(Svg& svg) { svg.close(); }

}  // namespace lgs::oracle::drawing
