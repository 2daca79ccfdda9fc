// A region's edges, cut at the lines between cells.
#pragma once

#include "scratch.h"

#include <lgs/brush.h>

#include <array>
#include <optional>
#include <span>

namespace lgs::brush {

/// A part of an edge of the region, or a part of a line between cells that closes a ring which was cut there.
struct Piece {
  Point a, b;        ///< the whole edge: it says where the piece runs
  Point start, end;  ///< lattice points, where the piece is cut: rounded along the line that cuts it
  bool isOfRegion = true;
};

using Pieces = List<Piece>;
using PieceSpan = std::span<const Piece>;

/// A ring, or any points.
using Points = List<Point>;

/// Those of a cell, counter-clockwise.
inline constexpr std::array<Point, 4> kCorners{
    {{0, 0}, {kUnitsPerCell, 0}, {kUnitsPerCell, kUnitsPerCell}, {0, kUnitsPerCell}}};

/// Whether pieces are one convex ring, counter-clockwise, of at most kMostConvexPieces, and no edges cross in it. Vertices
/// may be in the middle of straight lines.
bool isConvexRing(PieceSpan pieces);
inline constexpr std::size_t kMostConvexPieces = 16;

/// x = at, or y = at.
struct Line {
  bool isVertical = true;
  std::int64_t at = 0;
};

/// The ring as pieces. Equal neighbours are one vertex.
Pieces piecesOf(std::span<const Point> ring);

/// The parts of a closed ring on the two sides of a line: closed rings again, which may run along the line to and fro.
struct Halves {
  Pieces less, greater;
};
Halves halves(PieceSpan ring, Line line);

/// Pieces of several rings without those that have no area beside them: the same piece the other way around, or, in
/// even-odd regions, the same piece again. All must lie in one cell. Nothing, nearly always, if there are none.
std::optional<Pieces> withoutSpikes(PieceSpan pieces, FillRule rule);

/// How often the pieces run around the place just to the left of a point, or just to its right. Where a piece runs
/// level there, it is the place above, or the one below. Both coordinates are doubled.
std::int64_t windingLeftOf(Point doubled, PieceSpan pieces);
std::int64_t windingRightOf(Point doubled, PieceSpan pieces);

constexpr bool isFilled(std::int64_t winding, FillRule rule) {
  return rule == FillRule::evenOdd ? winding % 2 != 0 : winding != 0;
}

}  // namespace lgs::brush
