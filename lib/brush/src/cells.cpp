#include "cells.h"

#include <algorithm>
#include <utility>

namespace lgs::brush {
namespace {

using Rings = List<Pieces>;

std::int64_t units(std::int32_t cells) { return std::int64_t{cells} * kUnitsPerCell; }

/// Whether a piece runs along a side of the box of cells. Rounded ends alone do not tell: the edge can run beside it.
bool isOnRim(const Piece& p, const CellRect& box) {
  const auto isSide = [](std::int64_t at, std::int32_t min, std::int32_t max) {
    return at == units(min) || at == units(max + 1);
  };
  return (p.a.x == p.b.x && isSide(p.start.x, box.min.i, box.max.i)) ||
         (p.a.y == p.b.y && isSide(p.start.y, box.min.j, box.max.j));
}

Pieces all(const Rings& rings) {
  if (rings.size() == 1) return rings[0];
  Pieces pieces;
  for (const Pieces& ring : rings) pieces.insert(pieces.end(), ring.begin(), ring.end());
  return pieces;
}

Point shifted(Point p, Cell cell) { return {p.x - units(cell.i), p.y - units(cell.j)}; }

CutCell cutCell(Cell cell, Pieces pieces, FillRule rule) {
  for (Piece& p : pieces)
    for (Point* const point : {&p.a, &p.b, &p.start, &p.end}) *point = shifted(*point, cell);
  pieces = withoutSpikes(std::move(pieces), rule);
  return {cell, {pieces.begin(), pieces.end()}};
}

Rings half(const Rings& rings, Line line, bool keepsGreater) {
  Rings kept;
  kept.reserve(rings.size());
  for (const Pieces& ring : rings)
    if (Pieces part = cut(ring, line, keepsGreater); !part.empty()) kept.push_back(std::move(part));
  return kept;
}

/// Halves the box until no edge runs through its inside. The rings are cut to it.
void divide(const Rings& rings, const CellRect& box, FillRule rule, Coverage& result) {
  if (rings.empty() || result.crowded) return;
  const Frame frame;
  const bool isPlain = std::all_of(rings.begin(), rings.end(), [&](const Pieces& ring) {
    return std::all_of(ring.begin(), ring.end(), [&](const Piece& p) { return isOnRim(p, box); });
  });
  if (isPlain) {
    const Point inside{2 * units(box.min.i) + 1, 2 * units(box.min.j) + 1};
    if (isFilled(windingLeftOf(inside, all(rings)), rule)) result.whole.push_back(box);
  } else if (box.min == box.max) {
    Pieces pieces = all(rings);
    const auto isOfRegion = [](const Piece& p) { return p.isOfRegion; };
    if (std::ranges::count_if(pieces, isOfRegion) > std::int64_t{kMaxRegionEdgesPerCell}) {
      result.crowded = box.min;
    } else {
      result.cut.push_back(cutCell(box.min, std::move(pieces), rule));
    }
  } else {
    const bool isWide = box.max.i - box.min.i >= box.max.j - box.min.j;
    CellRect lower = box, upper = box;
    if (isWide) {
      lower.max.i = box.min.i + (box.max.i - box.min.i) / 2;
      upper.min.i = lower.max.i + 1;
    } else {
      lower.max.j = box.min.j + (box.max.j - box.min.j) / 2;
      upper.min.j = lower.max.j + 1;
    }
    const Line line{isWide, units(isWide ? upper.min.i : upper.min.j)};
    divide(half(rings, line, false), lower, rule, result);
    divide(half(rings, line, true), upper, rule, result);
  }
}

}  // namespace

Coverage coverage(const Region& region) {
  const Frame frame;
  Rings rings;
  for (const Ring& ring : region.rings)
    if (ring.size() >= 3) rings.push_back(piecesOf(ring));
  Coverage result;
  const Pieces pieces = all(rings);
  if (pieces.empty()) return result;
  Point min = pieces[0].a, max = min;
  for (const Piece& p : pieces) {
    min = {std::min(min.x, p.a.x), std::min(min.y, p.a.y)};
    max = {std::max(max.x, p.a.x), std::max(max.y, p.a.y)};
  }
  if (min.x == max.x || min.y == max.y) return result;
  divide(rings, {cellAt(min), cellAt({max.x - 1, max.y - 1})}, region.rule, result);
  return result;
}

Pieces wholeCell() { return piecesOf(kCorners); }

}  // namespace lgs::brush
