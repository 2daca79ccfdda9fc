// Ground that falls: what a physics engine needs of a body (body.h), and how a body that lies anywhere, at any angle,
// comes back into the ground. No physics engine is known here; lgs/box2d/falling.h is for Box2D.
//
//   const auto body = lgs::take(world, islands, island);              // islands.h
//   const auto parts = lgs::convexParts(*body);                       // a shape each
//   …
//   const auto done = lgs::putAsItLies(world, *body, {.origin = {12.3, 4.5}, .cosine = 0.8, .sine = 0.6});
//
// Every function is noexcept: when memory runs out the program ends.
#pragma once

#include <lgs/body.h>
#include <lgs/brush.h>

#include <cstddef>
#include <span>
#include <vector>

namespace lgs {

/// A convex part of a body.
struct ConvexPart {
  Block block = 0;              ///< what it is of
  std::vector<Point> vertices;  ///< counter-clockwise from the least one, in lattice units from the body's origin
  friend bool operator==(const ConvexPart&, const ConvexPart&) = default;
};

/// Convex parts of a body: by block, then by squares of 32×32 cells. The parts of a block make up its polygons exactly,
/// with no common interior, on vertices that are there already; a part has at most `maxVertices` of them (3 to
/// kMaxVerticesPerCell, asserted). Cells that one block fills as a whole are merged to rectangles, inside those
/// squares. All other parts are what `Pieces` makes of a cell. Refused: as by put(), for a body that fits nowhere;
/// index is of the polygon. Cost: as of Pieces, for each block; and the squares that have a part of it.
[[nodiscard]] Expected<std::vector<ConvexPart>> convexParts(const Body& body, std::size_t maxVertices = 8) noexcept;

/// How a body lies: turned about its origin, then moved. The angle is given by its cosine and sine, of which the
/// squares have the sum 1.
struct Placing {
  DoublePoint origin{};  ///< where the body's origin lies now: in cells of the world
  double cosine = 1;     ///< of the angle
  double sine = 0;       ///< of the angle: more than 0 is counter-clockwise
};

/// Sets a body into the ground as it lies. Its vertices are rounded to the lattice, its polygons are cut along the
/// cells, and what is solid already stays as it is: what the body has beyond that is painted with its blocks, by a
/// brush (law 8 with one more unit of rounding). Edges that two blocks of the body share stay shared. All of it is one
/// edit, or nothing. Refused: as by paint(), for a block of it; or as by put(), for a body that fits nowhere. Cost: as of
/// paint(), for each block.
[[nodiscard]] Expected<void> putAsItLies(World& world, const Body& body, const Placing& placing) noexcept;

/// What a block of a body covers, as it lies.
struct LyingBlock {
  Block block = 0;  ///< what it is of
  Region region;    ///< in lattice units of the world
};

/// The same in parts, to be put one after the other in several frames, as a body of hundreds of polygons takes
/// milliseconds: so many polygons each (0 counts as 1), in the order of the body. All of them make up what putAsItLies()
/// paints; edges between two parts stay shared. Refused: as by put(), for a body that fits nowhere. Cost: O(n log n) for
/// its vertices.
[[nodiscard]] Expected<std::vector<std::vector<LyingBlock>>> partsAsTheyLie(const Body& body, const Placing& placing,
                                                                            std::size_t polygonsAtOnce) noexcept;

/// Paints a part, as one edit, or nothing. Refused: as by paint(). Cost: as of paint(), for each block.
[[nodiscard]] Expected<void> putPart(World& world, std::span<const LyingBlock> part) noexcept;

}  // namespace lgs
