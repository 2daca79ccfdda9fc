// What the pieces of a world must be, checked the slow way and with none of the view's code: CGAL says whether they
// make up the cells (oracle/cgal/partition.h), portals are what any two pieces have in common.
#pragma once

#include "oracle/reference/validity.h"

#include <lgs/pieces.h>
#include <lgs/world.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace lgs::oracle {

/// The pieces of a cell as values.
struct CellPieces {
  std::vector<std::pair<std::uint32_t, LocalPolygon>> solid;
  std::vector<LocalPolygon> free;
  friend bool operator==(const CellPieces&, const CellPieces&) = default;
};
CellPieces piecesIn(const Pieces& pieces, Cell cell);

using PiecesByCell = std::map<Cell, CellPieces>;
PiecesByCell piecesIn(const Pieces& pieces, const std::vector<Cell>& cells);

/// What is wrong with the pieces of a cell that holds these polygons, if anything is.
std::optional<std::string> faultOfPieces(std::vector<LocalPolygon> polygons, const CellPieces& pieces,
                                         std::size_t maxVertices);

/// What is wrong with the portals of all free pieces in some cells, if anything is.
std::optional<std::string> faultOfPortals(const Pieces& pieces, const std::vector<Cell>& cells);

/// What is wrong with the pieces of a world in some cells, and with the portals between them.
std::optional<std::string> faultOfPieces(const World& world, const Pieces& pieces, const std::vector<Cell>& cells);

/// Holds a view of pieces against all of that, and what it says of an update against what is different: in all cells
/// that hold polygons, or did, and in those around them.
class PieceCheck {
 public:
  /// What is wrong with a view that begins.
  std::optional<std::string> begin(const World& world, const Pieces& pieces);
  /// What is wrong with it, or with the cells that it told, after an update.
  std::optional<std::string> update(const World& world, const Pieces& pieces, std::vector<Cell> told);
  /// The latter alone: for a world with edits that are pending, since it rolled back to when there were some.
  std::optional<std::string> updateOfPending(const World& world, const Pieces& pieces, std::vector<Cell> told);

 private:
  std::vector<Cell> look(const World& world, const Pieces& pieces);
  std::optional<std::string> faultOf(const World& world, const Pieces& pieces) const;

  PiecesByCell known_;  ///< of cells that hold polygons, or did
};

}  // namespace lgs::oracle
