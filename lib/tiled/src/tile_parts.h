// What a tile, flipped one way, puts into its own cell and its neighbours.
#pragma once

#include "grid.h"
#include "outline.h"

namespace lgs::tiled {

struct TilePart {
  CellPart part;
  std::uint32_t object = 0;  ///< id
  std::string className;     ///< the object's own, or the tile's
};

struct TileParts {
  std::vector<TilePart> parts;
  std::vector<Note> notes;
};

/// Outlines, snaps, checks and cuts every object of a tile.
TileParts tileParts(const Tile& tile, const Frame& frame, const PixelGrid& grid, const Options& options);

/// The notes' numbers: pixels with two decimals at most.
std::string pixels(double value);

}  // namespace lgs::tiled
