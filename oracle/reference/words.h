// Coordinates, points, segments and numbers of things in words, for messages that a person reads.
#pragma once

#include <lgs/lattice.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace lgs::oracle {

/// A world coordinate in cells, exactly: "3", "-0.25", "2.0625", or "3+21845/65536" (cell + lattice units) where the
/// decimal would need more than four digits.
std::string coordinateInWords(std::int64_t coordinate);

/// "(3, -0.25)"
std::string inWords(Point point);

/// "(2, 1) → (1, 1)"
std::string inWords(Point start, Point end);

/// Where a segment is, seen from its solid: "the top of cell (1, 0)", "inside cell (1, 0)".
std::string placeInWords(Point start, Point end);

/// "(3, -0.25)", or "none"
std::string ghostInWords(const std::optional<Point>& ghost);

/// "1 segment", "12,345 segments"
std::string counted(std::uint64_t n, std::string_view noun);

}  // namespace lgs::oracle
