#include "by_block.h"

#include <lgs/falling.h>
#include <lgs/pieces.h>

#include <algorithm>
#include <utility>

namespace lgs {
namespace {

constexpr std::int32_t kSquare = 32;  // as a chunk of the ground

constexpr std::int32_t floorTo(std::int32_t a) { return a - (a % kSquare + kSquare) % kSquare; }

/// Cells that hold polygons, each once, by squares.
std::vector<Cell> cellsBySquares(const World& world) {
  std::vector<Cell> cells;
  world.forEachPolygon([&](Cell cell, const PlacedPolygon&) { cells.push_back(cell); });
  const auto key = [](Cell c) { return std::pair(Cell{floorTo(c.i), floorTo(c.j)}, c); };
  std::ranges::sort(cells, {}, key);
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

std::vector<Point> cornersOf(const CellRect& cells) {
  const Point min = toWorld(cells.min, {}), max = toWorld({cells.max.i + 1, cells.max.j + 1}, {});
  return {min, {max.x, min.y}, max, {min.x, max.y}};
}

void addParts(const World& world, Block block, std::size_t maxVertices, std::vector<ConvexPart>& out) {
  const Pieces pieces(world, {maxVertices});
  const std::vector<Cell> cells = cellsBySquares(world);
  for (auto cell = cells.begin(); cell != cells.end();) {
    const Cell corner{floorTo(cell->i), floorTo(cell->j)};
    const CellRect square{corner, {corner.i + kSquare - 1, corner.j + kSquare - 1}};
    std::vector<CellRect> whole;
    if (maxVertices >= 4) whole = pieces.wholeCells(square, Part::solid);
    for (const CellRect& rect : whole) out.push_back({block, cornersOf(rect)});
    for (; cell != cells.end() && contains(square, *cell); ++cell) {
      if (std::ranges::any_of(whole, [&](const CellRect& rect) { return contains(rect, *cell); })) continue;
      for (const Piece& piece : pieces.solidPieces(*cell)) {
        ConvexPart part{block, {}};
        for (const LocalPoint v : piece.vertices) part.vertices.push_back(toWorld(*cell, v));
        out.push_back(std::move(part));
      }
    }
  }
}

}  // namespace

Expected<std::vector<ConvexPart>> convexParts(const Body& body, std::size_t maxVertices) noexcept {
  std::vector<ConvexPart> parts;
  for (const Block block : detail::blocksOf(body)) {
    const auto world = detail::worldOf(body, block);
    if (!world) return tl::unexpected(world.error());
    addParts(*world, block, maxVertices, parts);
  }
  return parts;
}

}  // namespace lgs
