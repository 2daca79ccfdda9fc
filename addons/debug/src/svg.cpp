#include <lgs/debug.h>

#include <algorithm>
#include <cstdint>
#include <optional>

namespace lgs {
namespace {

constexpr std::int64_t kPixelsPerCell = 64, kMargin = 8;
constexpr double kMinCellsPerUnit = 1e-6, kMaxCellsPerUnit = 1e6;

/// With three decimals: about a lattice unit; or in other parts of 1. No locale has a say in it.
std::string decimal(double value, std::int64_t one = 1'000) {
  const auto parts = static_cast<std::int64_t>(value * static_cast<double>(one) + (value < 0 ? -0.5 : 0.5));
  const std::int64_t magnitude = parts < 0 ? -parts : parts;
  return (parts < 0 ? "-" : "") + std::to_string(magnitude / one) + "." +
         std::to_string(one + magnitude % one).substr(1);
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
    const std::string scale = decimal(overlay.cellsPerUnit * kPixelsPerCell, 1'000'000'000);
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

/// Of polygons, and of segments, whose polygons may be gone since the last commit.
CellRect boundsOf(const World& world) {
  std::optional<CellRect> all = world.bounds();
  for (const SegmentId id : world.segments()) {
    const Cell cell = world.segment(id)->cell;
    if (!all) all = CellRect{cell, cell};
    all->min = {std::min(all->min.i, cell.i), std::min(all->min.j, cell.j)};
    all->max = {std::max(all->max.i, cell.i), std::max(all->max.j, cell.j)};
  }
  return all.value_or(CellRect{});
}

}  // namespace

std::string writeSvg(const World& world, const SvgOverlay& overlay) {
  const CellRect cells = boundsOf(world);
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
  const bool hasScale =
      overlay.cellsPerUnit >= kMinCellsPerUnit && overlay.cellsPerUnit <= kMaxCellsPerUnit;  // and so a number
  if (!overlay.over.empty() && hasScale) svg += page.group(overlay);
  return svg + "</svg>\n";
}

}  // namespace lgs
