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

Piece shifted(Piece p, Cell cell) {
  for (Point* const point : {&p.a, &p.b, &p.start, &p.end})
    *point = {point->x - units(cell.i), point->y - units(cell.j)};
  return p;
}

void addCutCell(Cell cell, const Rings& rings, FillRule rule, Coverage& result) {
  std::vector<Piece>& all = result.pieces;
  const std::size_t first = all.size();
  std::size_t ofRegion = 0;
  for (const Pieces& ring : rings) {
    for (const Piece& p : ring) {
      all.push_back(shifted(p, cell));
      ofRegion += p.isOfRegion ? 1 : 0;
    }
  }
  if (ofRegion > kMaxRegionEdgesPerCell) {
    result.crowded = cell;
    return;
  }
  if (const auto kept = withoutSpikes(std::span(all).subspan(first), rule)) {
    all.resize(first);
    all.insert(all.end(), kept->begin(), kept->end());
  }
  result.cut.push_back({cell, std::span(all).subspan(first)});  // coverage() says where they are in the end
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
    addCutCell(box.min, rings, rule, result);
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
    Rings less, greater;
    less.reserve(rings.size());
    greater.reserve(rings.size());
    for (const Pieces& ring : rings) {
      Halves parts = halves(ring, line);
      if (!parts.less.empty()) less.push_back(std::move(parts.less));
      if (!parts.greater.empty()) greater.push_back(std::move(parts.greater));
    }
    divide(less, lower, rule, result);
    divide(greater, upper, rule, result);
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
  result.pieces.reserve(4 * pieces.size());
  divide(rings, {cellAt(min), cellAt({max.x - 1, max.y - 1})}, region.rule, result);
  const Piece* at = result.pieces.data();
  for (CutCell& cell : result.cut) {
    cell.pieces = {at, cell.pieces.size()};
    at += cell.pieces.size();
  }
  return result;
}

Pieces wholeCell() { return piecesOf(kCorners); }

}  // namespace lgs::brush
