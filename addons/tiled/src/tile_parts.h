// The polygons that a tile, flipped in one way, puts into its own cell and into the neighbouring cells.
#pragma once

#include "budget.h"
#include "object_outline.h"
#include "pixel_grid.h"
#include "tileset.h"

namespace lgs::tiled {

struct TilePart {
  CellPart part;
  std::uint32_t object = 0;  ///< id of the collision object
  std::string className;     ///< of the object, or of the tile if the object has none
};

struct TileParts {
  std::vector<TilePart> parts;
  std::vector<Note> notes;
};

/// Outlines each object of a tile, snaps the outline to the grid, and cuts it along the grid.
TileParts tileParts(const Tile& tile, const ImageFrame& frame, const PixelGrid& grid, const Options& options,
                    Budget& budget);

}  // namespace lgs::tiled
