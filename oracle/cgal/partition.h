// The oracle of convex pieces: CGAL says whether they make up what they should.
#pragma once

#include "oracle/reference/validity.h"

#include <optional>
#include <string>
#include <vector>

namespace lgs::oracle {

/// The pieces of one polygon, or the free pieces of a cell.
using PieceList = std::vector<LocalPolygon>;

/// Says what is wrong with the pieces of a cell, if anything is: each must be a simple convex polygon that runs
/// counter-clockwise; their interiors must be disjoint; those of each polygon must make up that polygon, and the free
/// ones the closed cell without the polygons. `solid` has as many lists as there are polygons.
std::optional<std::string> notAPartition(const std::vector<LocalPolygon>& polygons, const std::vector<PieceList>& solid,
                                         const PieceList& free);

}  // namespace lgs::oracle
