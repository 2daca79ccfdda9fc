// Shows a world, to look for a bug: as a trace for the `lgs` command, and as a picture.
#pragma once

#include <lgs/world.h>

#include <string>

namespace lgs {

/// Returns the polygons of a world as a trace, the `lgs` command's format, without those of unloaded chunks: after all edits, committed or not, by cell (j, then
/// i) and handle. With it come the `preserve` lines of all blocks that are there. Coordinates are exact. What a trace
/// can not say is lost: handles, ids, shapes, edits that are not committed. Cost: in proportion to the polygons; under
/// a preserve relation also to the square of the number of blocks.
std::string writeTrace(const World& world);

/// Something to lay over a picture of a world: bodies, paths, names.
struct SvgOverlay {
  std::string over;         ///< SVG elements, whose x runs to the right and y up
  double cellsPerUnit = 1;  ///< of their coordinates: for metres 1 / TerrainOptions::cellSize. 10^-6 to 10^6: with
                            ///< another number nothing is laid over
  Cell origin = {};         ///< its lower left corner is their (0, 0)
};

/// Returns the polygons of a world, and its segments as of the last commit with their outward normals, as an SVG
/// picture, without unloaded chunks, and what is laid over it. A cell is 64 pixels wide. Each block has a colour. Cost: in proportion to the polygons and
/// segments.
std::string writeSvg(const World& world, const SvgOverlay& overlay = {});

}  // namespace lgs
