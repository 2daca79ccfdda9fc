// Squares of ground as both ends name them: those of <lgs/hashes.h>, and quarters of the side of a chunk.
#pragma once

#include "bytes.h"

#include <lgs/hashes.h>

#include <compare>
#include <map>

namespace in_step {

/// Level −1 has squares of 8×8 cells, sixteen in a chunk: small enough to be sent as a whole.
inline constexpr int kLeaf = -1;
inline constexpr std::int32_t kLeafSide = lgs::GroundHashes::kChunkSide / 4;

struct Square {
  int level = 0;
  lgs::Cell corner;  ///< the lower-left one
  friend auto operator<=>(const Square&, const Square&) = default;
};

lgs::CellRect cellsOf(const Square& square);

/// The least square that has two others.
Square around(const Square& a, const Square& b);

/// The parts of a square above kLeaf, and their hashes: those that hold something.
using Parts = std::map<Square, std::uint64_t>;
Parts partsOf(const lgs::World& world, const lgs::GroundHashes& hashes, const Square& square);

void put(Bytes& out, const Square& square);
/// Fails the reader, if there is no such square.
Square readSquare(Reader& in);

void put(Bytes& out, const Square& square, const Parts& parts);
/// Fails the reader, if these are not parts of this square.
Parts readParts(Reader& in, const Square& square);

}  // namespace in_step
