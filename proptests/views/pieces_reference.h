// What the pieces of a world must be, checked the slow way and with none of the view's code: CGAL says whether they
// make up the cells (oracle/cgal/partition.h), portals are what any two pieces have in common.
#pragma once

#include "oracle/reference/validity.h"

#include <lgs/pieces.h>
#include <lgs/world.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace lgs::test {

/// The pieces of a cell as values.
struct CellPieces {
  std::vector<std::pair<std::uint32_t, oracle::LocalPolygon>> solid;
  std::vector<oracle::LocalPolygon> free;
  friend bool operator==(const CellPieces&, const CellPieces&) = default;
};
CellPieces piecesIn(const Pieces& pieces, Cell cell);

/// All cells of a rectangle.
using PiecesByCell = std::map<Cell, CellPieces>;
PiecesByCell piecesIn(const Pieces& pieces, const CellRect& cells);

/// What is wrong with the pieces of a cell that holds these polygons, if anything is.
std::optional<std::string> faultOfPieces(std::vector<oracle::LocalPolygon> polygons, const CellPieces& pieces,
                                         std::size_t maxVertices);

/// What is wrong with the pieces of a world in a rectangle, and with the portals between them.
std::optional<std::string> faultOfPieces(const World& world, const Pieces& pieces, const CellRect& cells);

/// What is wrong with the portals of all free pieces in a rectangle, if anything is.
std::optional<std::string> faultOfPortals(const Pieces& pieces, const CellRect& cells);

}  // namespace lgs::test
