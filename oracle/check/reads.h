// Everything that a world can be asked, against what must be there: the polygons that were placed, and the segments that a
// mirror holds, which the references have compared.
#pragma once

#include "oracle/reference/outline.h"
#include "oracle/trace/mirror.h"
#include "oracle/trace/model.h"
#include "oracle/trace/player.h"

#include <optional>
#include <string>

namespace lgs::oracle {

struct WrongRead {
  std::string text;
  Outline about = {};  ///< the segments that are read wrongly, for a picture
};

/// The polygons of a cell: by cell, by handle, by name.
std::optional<WrongRead> readCell(const Player& player, const Model& model, Cell cell);

/// All cells, and counts.
std::optional<WrongRead> readPolygons(const Player& player, const Model& model);

/// Segments by id, those that are not alive too; and by rectangle, for a few that depend on what there is.
std::optional<WrongRead> readSegments(const World& world, std::span<const Segment> segments);

/// The chains, with and without collinear vertices.
std::optional<WrongRead> readLoops(const World& world, std::span<const Segment> segments);

}  // namespace lgs::oracle
