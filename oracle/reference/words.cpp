#include "oracle/reference/words.h"

#include "oracle/reference/vector.h"

#include <fmt/format.h>

namespace lgs::oracle {
namespace {

constexpr std::int64_t kDecimals = 10'000;

bool isOnLine(std::int64_t coordinate) { return coordinate % kUnitsPerCell == 0; }

}  // namespace

std::string coordinateInWords(std::int64_t coordinate) {
  const std::int64_t cell = cellIndex(coordinate);
  const std::int64_t units = coordinate - cell * kUnitsPerCell;
  if (units == 0) return fmt::format("{}", cell);
  if (units * kDecimals % kUnitsPerCell != 0) return fmt::format("{}+{}/{}", cell, units, kUnitsPerCell);

  const std::int64_t magnitude = coordinate < 0 ? -coordinate : coordinate;
  std::string text = fmt::format("{}{}.{:04}", coordinate < 0 ? "-" : "", magnitude / kUnitsPerCell,
                                 magnitude % kUnitsPerCell * kDecimals / kUnitsPerCell);
  text.erase(text.find_last_not_of('0') + 1);
  return text;
}

std::string inWords(Point point) {
  return fmt::format("({}, {})", coordinateInWords(point.x), coordinateInWords(point.y));
}

std::string inWords(Point start, Point end) { return fmt::format("{} → {}", inWords(start), inWords(end)); }

std::string placeInWords(Point start, Point end) {
  // The cell of the middle; coordinates are far below the limits of 64 bits, so the sum is exact.
  std::int64_t i = cellIndex((start.x + end.x) >> 1);
  std::int64_t j = cellIndex((start.y + end.y) >> 1);
  const char* where = "inside";
  if (start.y == end.y && isOnLine(start.y)) {
    const bool solidIsAbove = end.x > start.x;
    where = solidIsAbove ? "the bottom of" : "the top of";
    if (!solidIsAbove) --j;
  } else if (start.x == end.x && isOnLine(start.x)) {
    const bool solidIsRight = end.y < start.y;
    where = solidIsRight ? "the left side of" : "the right side of";
    if (!solidIsRight) --i;
  }
  return fmt::format("{} cell ({}, {})", where, i, j);
}

std::string ghostInWords(const std::optional<Point>& ghost) { return ghost ? inWords(*ghost) : "none"; }

std::string counted(std::uint64_t n, std::string_view noun) {
  std::string text = std::to_string(n);
  for (std::size_t at = text.size(); at > 3;) text.insert(at -= 3, ",");
  return text.append(" ").append(noun).append(n == 1 ? "" : "s");
}

}  // namespace lgs::oracle
