// From collision objects to polygons in cells: an outline is put on the lattice, and cut along the grid.
#pragma once

#include "budget.h"
#include "collision_object.h"
#include "map_source.h"
#include "pixel_grid.h"

#include <functional>

namespace lgs::tiled {

/// Puts an object on the lattice and cuts it along the grid. Its outlines are in pixels from the lower left corner of its
/// home cell, y up; `most` is how many cells away a vertex may be. Each part goes to the sink. What happens becomes a
/// note. What it costs is taken from the budget; if that is spent, nothing comes.
void cutObject(const CollisionObject& object, const std::vector<Outline>& outlines, const PixelGrid& grid, double most,
               Budget& budget, std::vector<Note>& notes, const PartSink& sink);

/// A number of pixels as the notes write it, with at most two decimals: "1.25 px".
std::string pixels(double value);

/// Receives what lies of an object of a tile in one cell: how far this is from the tile's cell.
using TilePartSink = std::function<void(Cell shift, const Polygon& ring, const CollisionObject& object)>;

/// Gives the polygons that a tile, flipped in one way, puts into its own cell and into the neighbouring cells.
void cutTile(const Tile& tile, const ImageFrame& frame, const PixelGrid& grid, const Options& options, Budget& budget,
             std::vector<Note>& notes, const TilePartSink& sink);

/// Receives a shape of an object of an object layer, with the id and class of the object and the outlines in pixels from
/// the map's upper left corner, y up. A tile object can have several shapes, and Kind::unsupported has no outlines.
using ShapeSink = std::function<void(const CollisionObject& object, const std::vector<Outline>& outlines)>;

/// Gives the shapes of an object layer one by one, in the file's order; those for which the budget is enough.
void readObjects(MapSource& source, const Layer& layer, const Options& options, Budget& budget, const ShapeSink& sink);

}  // namespace lgs::tiled
