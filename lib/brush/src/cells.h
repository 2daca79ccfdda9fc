// Which cells a region covers as a whole, and which ones an edge of it runs through.
#pragma once

#include "pieces.h"

#include <optional>
#include <vector>

namespace lgs::brush {

/// A cell that edges of the region run through, with its part of the region's edges, in units from the cell's corner.
struct CutCell {
  Cell cell;
  PieceSpan pieces;
};

struct Coverage {
  Coverage() = default;
  Coverage(const Coverage&) = delete;
  Coverage& operator=(const Coverage&) = delete;
  Coverage(Coverage&&) = default;
  Coverage& operator=(Coverage&&) = default;
  ~Coverage() = default;

  std::vector<CellRect> whole;
  std::vector<CutCell> cut;
  std::vector<Piece> pieces;    ///< of the cut cells, one after the other
  std::optional<Cell> crowded;  ///< more than kMaxRegionEdgesPerCell edges run through it: the rest is not known
};

/// Cost: in proportion to the region's edges and the cells that they run through, times the logarithm of its extent.
Coverage coverage(const Region& region);

/// The rim of a cell: the region that is all of it.
Pieces wholeCell();

}  // namespace lgs::brush
