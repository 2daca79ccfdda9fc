#include "squares.h"

#include <algorithm>

namespace in_step {

using lgs::Cell;
using lgs::CellRect;
using lgs::GroundHashes;

namespace {

/// Of a cell that is the corner of a leaf.
Square squareOf(Cell cell, int level) {
  if (level == kLeaf) return {kLeaf, cell};
  return {level, GroundHashes::square(cell, level).cells.min};
}

}  // namespace

CellRect cellsOf(const Square& square) {
  if (square.level != kLeaf) return GroundHashes::square(square.corner, square.level).cells;
  const Cell c = square.corner;
  return {c, {std::min(c.i + kLeafSide - 1, lgs::kMaxCell), std::min(c.j + kLeafSide - 1, lgs::kMaxCell)}};
}

Square around(const Square& a, const Square& b) {
  int level = std::max(a.level, b.level);
  while (squareOf(a.corner, level) != squareOf(b.corner, level)) ++level;  // on kTopLevel there is but one
  return squareOf(a.corner, level);
}

Parts partsOf(const lgs::World& world, const GroundHashes& hashes, const Square& square) {
  Parts parts;
  const CellRect cells = cellsOf(square);
  if (square.level > 0) {
    for (const lgs::HashedSquare& part : hashes.hashes(cells, square.level - 1))
      parts[{part.level, part.cells.min}] = part.hash;
    return parts;
  }
  for (std::int64_t j = cells.min.j; j <= cells.max.j; j += kLeafSide)
    for (std::int64_t i = cells.min.i; i <= cells.max.i; i += kLeafSide) {
      const Square leaf{kLeaf, {static_cast<std::int32_t>(i), static_cast<std::int32_t>(j)}};
      if (const std::uint64_t hash = groundHash(world, cellsOf(leaf)); hash != 0) parts[leaf] = hash;
    }
  return parts;
}

// Corners of squares are corners of leaves, of which there are as many as fit 28 bits.
void put(Bytes& out, const Square& square) {
  put(out, static_cast<std::uint64_t>(square.level - kLeaf));
  putSigned(out, square.corner.i / kLeafSide);
  putSigned(out, square.corner.j / kLeafSide);
}

Square readSquare(Reader& in) {
  Square square;
  square.level = static_cast<int>(in.number(GroundHashes::kTopLevel - kLeaf)) + kLeaf;
  square.corner.i = in.signedNumber(lgs::kMaxCell / kLeafSide) * kLeafSide;
  square.corner.j = in.signedNumber(lgs::kMaxCell / kLeafSide) * kLeafSide;
  if (squareOf(square.corner, square.level) != square) in.fail();
  return square;
}

void put(Bytes& out, const Square& square, const Parts& parts) {
  put(out, parts.size());
  for (const auto& [part, hash] : parts) {
    put(out, static_cast<std::uint64_t>(part.corner.i - square.corner.i) / kLeafSide);
    put(out, static_cast<std::uint64_t>(part.corner.j - square.corner.j) / kLeafSide);
    putHash(out, hash);
  }
}

Parts readParts(Reader& in, const Square& square) {
  Parts parts;
  const CellRect cells = cellsOf(square);
  for (std::uint64_t count = in.number(16); count > 0; --count) {
    const std::int64_t i = cells.min.i + static_cast<std::int64_t>(in.number(lgs::kMaxCell / 4)) * kLeafSide;
    const std::int64_t j = cells.min.j + static_cast<std::int64_t>(in.number(lgs::kMaxCell / 4)) * kLeafSide;
    const std::uint64_t hash = in.hash();
    if (i > cells.max.i || j > cells.max.j) in.fail();
    if (!in.isGood()) break;
    const Square part{square.level - 1, {static_cast<std::int32_t>(i), static_cast<std::int32_t>(j)}};
    if (squareOf(part.corner, part.level) != part || hash == 0)
      in.fail();
    else
      parts[part] = hash;
  }
  return parts;
}

}  // namespace in_step
