// Compares everything that a world can be asked with what must be there. That is the polygons that were placed, and the
// segments of a mirror, which were compared with the references.
#pragma once

#include "oracle/reference/outline.h"
#include "oracle/trace/mirror.h"
#include "oracle/trace/player.h"

#include <optional>
#include <string>

namespace lgs::oracle {

struct WrongRead {
  std::string text;
  Outline about = {};  ///< the segments that are read wrongly, for a picture
};

/// The polygons of a cell, asked for by cell and by handle.
std::optional<WrongRead> readCell(const World& world, const Standing& standing, Cell cell);

/// The polygons of all cells, and how many there are.
std::optional<WrongRead> readPolygons(const Player& player);

/// Segments by id, dead ids too; and by rectangle, for a few rectangles. Some may be unloaded, or were: `isAway`.
std::optional<WrongRead> readSegments(const World& world, std::span<const Segment> segments, bool isAway = false);

/// The loops, with and without collinear vertices. Where chunks are unloaded `whole` is the outline of all there is: a
/// passage there keeps a vertex, too.
std::optional<WrongRead> readLoops(const World& world, std::span<const Segment> segments,
                                   const Outline* whole = nullptr);

}  // namespace lgs::oracle
