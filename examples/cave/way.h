// A way through what is free, by A* over the free pieces, and pulled straight in its portals:
//
//   lgs::Pieces pieces(world);
//   const auto way = examples::findWay(pieces, {.from = …, .to = …, .cells = {{0, 0}, {31, 15}}});
//
// The pieces are what takes long to find out, and they are kept up to date. So after each commit that changed some of
// them the search simply runs again.
#pragma once

#include <lgs/pieces.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace examples {

/// Points are in lattice units of the world.
struct Journey {
  lgs::Point from;
  lgs::Point to;
  /// No way leaves these, nor begins or ends on their lower and left rim. At most 16,384 wide and high, so that
  /// products are exact.
  lgs::CellRect cells;
  std::int64_t narrowest = 1;  ///< portals that are narrower, in lattice units, are no way
};

struct Way {
  std::vector<lgs::PieceId> pieces;  ///< that it goes through, one after the other
  std::vector<lgs::Point> corners;   ///< where it begins, turns and ends
  double length = 0;                 ///< in cells
};

/// The way whose portals' middles are the shortest row of lines, pulled straight; nothing if there is none. Cost: of
/// each piece that A* looks at, its portals.
std::optional<Way> findWay(const lgs::Pieces& pieces, const Journey& journey);

}  // namespace examples
