// One content worked out: its pieces, and where its free pieces meet each other and the sides of the cell.
#pragma once

#include "convex.h"
#include "geometry/edge.h"

#include <lgs/pieces.h>

#include <array>
#include <cstddef>
#include <vector>

namespace lgs::pieces {

/// A free piece on a side of the cell: the part of the side that it has, by the coordinate along the side.
struct Opening {
  std::int32_t low = 0;
  std::int32_t high = 0;
  Index piece = 0;
};

struct Content {
  Content(std::span<const Ring> polygons, std::size_t maxVertices);
  Content(const Content&) = delete;
  Content& operator=(const Content&) = delete;
  ~Content() = default;

  ConvexParts parts;                                          ///< what the pieces' spans are of
  std::vector<Piece> solid;                                   ///< by polygon
  std::vector<Piece> free;                                    ///< contacts count in these
  std::vector<Contact> contacts;                              ///< of free pieces
  std::array<std::vector<Opening>, detail::kSides> openings;  ///< by side, and their low ends
};

bool samePieces(const Content& a, const Content& b);

}  // namespace lgs::pieces
