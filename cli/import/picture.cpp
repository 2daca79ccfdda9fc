#include "cli/import/picture.h"

#include "oracle/draw/colours.h"
#include "oracle/draw/svg.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace lgs::cli {
namespace {

using namespace oracle::drawing;
using Ring = std::vector<LocalPoint>;

constexpr double kMargin = 24, kHead = 92, kSide = 640, kLargestCell = 40;  // pixels

/// The cells of both maps.
struct Bounds {
  std::int32_t left = kMaxCell, right = -kMaxCell, bottom = kMaxCell, top = -kMaxCell;

  void add(const tiled::ImportedMap& map) {
    for (const tiled::MapPolygon& p : map.placements) {
      left = std::min(left, p.cell.i);
      right = std::max(right, p.cell.i);
      bottom = std::min(bottom, p.cell.j);
      top = std::max(top, p.cell.j);
    }
  }
  double width() const { return static_cast<double>(right) - left + 1; }
  double height() const { return static_cast<double>(top) - bottom + 1; }
};

std::set<std::pair<Cell, Ring>> polygonsOf(const tiled::ImportedMap& map) {
  std::set<std::pair<Cell, Ring>> all;
  for (const tiled::MapPolygon& p : map.placements) all.emplace(p.cell, map.shapes[p.shape]);
  return all;
}

}  // namespace

std::string drawReadings(const std::string& title, const tiled::ImportedMap& taken, const tiled::ImportedMap& other,
                         const std::string& otherName) {
  Bounds bounds;
  bounds.add(taken);
  bounds.add(other);
  const double scale = std::min({kSide / bounds.width(), kSide / bounds.height(), kLargestCell});
  const double width = std::max(bounds.width() * scale, kSide / 2), height = bounds.height() * scale;
  const std::string names[] = {fmt::format("taken: {} polygons", taken.placements.size()),
                               fmt::format("or: {} ({} polygons)", otherName, other.placements.size())};
  const std::string_view colours[] = {kExpected, kActual};
  Svg svg(2 * width + 3 * kMargin, kHead + height + kMargin, title, names[0] + "; " + names[1], kPage);
  const auto write = [&](double y, std::string_view text, std::string_view colour, const char* weight) {
    svg.text({kMargin, y}, text,
             {{"fill", colour}, {"font-family", "sans-serif"}, {"font-size", 14.0}, {"font-weight", weight}});
  };
  write(24, title, kInk, "bold");
  write(46, names[0] + ", on the left; what it alone has is blue", kExpected, "normal");
  write(68, names[1] + ", on the right; what it alone has is orange", kActual, "normal");
  const std::array all{polygonsOf(taken), polygonsOf(other)};
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Vec corner{kMargin + static_cast<double>(k) * (width + kMargin), kHead};
    Path frame, common, alone;
    frame.rect(corner, width, height);
    for (const auto& polygon : all[k]) {
      const auto& [cell, ring] = polygon;
      Path& path = all[1 - k].contains(polygon) ? common : alone;
      for (std::size_t v = 0; v < ring.size(); ++v) {
        const double x = cell.i - bounds.left + static_cast<double>(ring[v].x) / kUnitsPerCell;
        const double y = bounds.top + 1 - cell.j - static_cast<double>(ring[v].y) / kUnitsPerCell;
        v == 0 ? path.moveTo(corner + Vec{x, y} * scale) : path.lineTo(corner + Vec{x, y} * scale);
      }
      path.close();
    }
    svg.path(frame, {{"fill", kPaper}, {"stroke", kGrid}});
    const double line = std::min(1.0, scale / 16);
    svg.path(common, {{"fill", kGrid}, {"stroke", kPaper}, {"stroke-width", line}});
    svg.path(alone, {{"fill", colours[k]}, {"stroke", colours[k]}, {"stroke-width", line}});  // also if it is thin
  }
  return std::move(svg).finish();
}

}  // namespace lgs::cli
