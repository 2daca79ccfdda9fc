// Convex pieces from triangles: diagonals are removed while what is left stays convex and has few enough corners.
//
// Hertel and Mehlhorn, as in triangulation.h: without a limit of corners a polygon falls into at most four times as
// many pieces as are needed. Which diagonal goes first is a matter of order alone, so the pieces are the same
// everywhere.
#pragma once

#include "triangulation.h"

#include <cstddef>
#include <vector>

namespace lgs::pieces {

/// Two pieces of one label and the edge that they share: from→to runs counter-clockwise along `piece`.
struct Contact {
  Index piece = 0;
  Index other = 0;
  LocalPoint from;
  LocalPoint to;
};

struct ConvexParts {
  struct Part {
    Label label = kFree;
    Ring vertices;  ///< counter-clockwise from the least one, no three on a line
  };
  std::vector<Part> parts;        ///< by label, free ones last; then by their vertices
  std::vector<Contact> contacts;  ///< each from both sides, by piece
};

ConvexParts convexParts(const Triangulation& triangulation, std::size_t maxVertices);

}  // namespace lgs::pieces
