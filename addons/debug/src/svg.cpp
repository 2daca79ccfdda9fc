#include <lgs/debug.h>

#include <cstdint>

namespace lgs {
namespace {

constexpr std::int64_t kPixelsPerCell = 64, kMargin = 8;
constexpr double kMaxCellsPerUnit = 1e6;

/// With three decimals: about a lattice unit. No locale has a say in it.
std::string decimal(double value) {
  const auto thousandths = static_cast<std::int64_t>(value * 1000 + (value < 0 ? -0.5 : 0.5));
  const std::int64_t magnitude = thousandths < 0 ? -thousandths : thousandths;
  const std::string rest = std::to_string(magnitude % 1000);
  return (thousandths < 0 ? "-" : "") + std::to_string(magnitude / 1000) + "." + std::string(3 - rest.size(), '0') +
         rest;
}

/// Neighbouring numbers get hues that are far apart.
std::string colourOf(Block block) { return "hsl(" + std::to_string(std::uint64_t{block} * 137 % 360) + ",45%,78%)"; }

/// Puts the origin at the upper left of the picture, and y down.
class Page {
 public:
  explicit Page(const CellRect& cells) : left_(cells.min.i), top_(std::int64_t{cells.max.j} + 1) {}
  std::string operator()(DoublePoint cells) const {
    return decimal((cells.x - static_cast<double>(left_)) * kPixelsPerCell) + "," +
           decimal((static_cast<double>(top_) - cells.y) * kPixelsPerCell);
  }
  std::string operator()(Point p) const { return (*this)(inCells(p)); }
  std::string group(const SvgOverlay& overlay) const {
    const std::string scale = decimal(overlay.cellsPerUnit * kPixelsPerCell);
    const DoublePoint corner{static_cast<double>(overlay.origin.i), static_cast<double>(overlay.origin.j)};
    return "<g transform=\"matrix(" + scale + ",0,0,-" + scale + "," + (*this)(corner) + ")\">\n" + overlay.over +
           "</g>\n";
  }
  static DoublePoint inCells(Point p) {
    return {static_cast<double>(p.x) / kUnitsPerCell, static_cast<double>(p.y) / kUnitsPerCell};
  }

 private:
  std::int64_t left_, top_;
};

}  // namespace

std::string writeSvg(const World& world, const SvgOverlay& overlay) {
  const CellRect cells = world.bounds().value_or(CellRect{});
  const auto pixels = [](std::int32_t min, std::int32_t max) {
    return std::to_string((std::int64_t{max} - min + 1) * kPixelsPerCell + 2 * kMargin);
  };
  const std::string width = pixels(cells.min.i, cells.max.i), height = pixels(cells.min.j, cells.max.j);
  const std::string corner = std::to_string(-kMargin);
  const Page page(cells);
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height +
                    "\" viewBox=\"" + corner + " " + corner + " " + width + " " + height + "\">\n";
  world.forEachPolygon([&](Cell cell, const PlacedPolygon& polygon) {
    svg += "<polygon fill=\"" + colourOf(polygon.block) + "\" points=\"";
    for (const LocalPoint v : polygon.vertices) svg += page(toWorld(cell, v)) + " ";
    svg += "\"/>\n";
  });
  svg += "<g stroke=\"black\" fill=\"none\">\n";
  for (const SegmentId id : world.segments()) {
    const Segment s = *world.segment(id);
    const DoublePoint start = Page::inCells(s.start), end = Page::inCells(s.end), normal = s.normal();
    const DoublePoint middle{(start.x + end.x) / 2, (start.y + end.y) / 2};
    svg += "<path d=\"M" + page(s.start) + " " + page(s.end) + " M" + page(middle) + " " +
           page(DoublePoint{middle.x + normal.x / 12, middle.y + normal.y / 12}) + "\"/>\n";
  }
  svg += "</g>\n";
  const bool hasScale = overlay.cellsPerUnit > 0 && overlay.cellsPerUnit <= kMaxCellsPerUnit;  // and so a number
  if (!overlay.over.empty() && hasScale) svg += page.group(overlay);
  return svg + "</svg>\n";
}

}  // namespace lgs
