#include "oracle/check/window.h"

namespace lgs::oracle {
namespace {

std::int64_t floorDivide(std::int64_t a, std::int64_t b) { return a / b - (a % b < 0 ? 1 : 0); }

}  // namespace

CellSet around(const CellSet& cells) {
  CellSet result;
  for (const Cell& cell : cells) {
    for (std::int32_t di = -1; di <= 1; ++di) {
      for (std::int32_t dj = -1; dj <= 1; ++dj) result.insert({cell.i + di, cell.j + dj});
    }
  }
  return result;
}

Scene sceneOf(const Standing& standing, const PreservePairs& preserve, const CellSet& cells) {
  return {standing.part(cells).polygonsOfAll(), preserve};
}

Scene sceneOf(const Standing& standing, const CellRect& cells) {
  Scene scene;
  for (const auto& [cell, there] : standing.cells()) {
    if (!contains(cells, cell)) continue;
    for (const Standing::Placed& placed : there) scene.polygons.push_back({cell, placed.block, placed.vertices});
  }
  return scene;
}

Cell cellOf(const OutlineSegment& segment) {
  // Twice the middle of the segment, moved a little to the left; in a cell, or on a rim with the cell on the left.
  const Point along{segment.end.x - segment.start.x, segment.end.y - segment.start.y};
  const auto sign = [](std::int64_t v) { return (v > 0) - (v < 0); };
  const std::int64_t x = segment.start.x + segment.end.x;
  const std::int64_t y = segment.start.y + segment.end.y;
  constexpr std::int64_t kTwoCells = 2 * std::int64_t{kUnitsPerCell};
  const auto index = [&](std::int64_t v, int left) {
    return static_cast<std::int32_t>(floorDivide(v % kTwoCells == 0 && left < 0 ? v - 1 : v, kTwoCells));
  };
  return {index(x, -sign(along.y)), index(y, sign(along.x))};
}

void keepOnly(Outline& outline, const CellSet& cells) {
  std::erase_if(outline, [&](const OutlineSegment& segment) { return !cells.contains(cellOf(segment)); });
}

}  // namespace lgs::oracle
