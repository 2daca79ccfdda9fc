#include "cutting.h"

namespace regions {

std::optional<int> ownerOf(const Cutting& cutting, lgs::Cell cell) {
  for (std::size_t rank = 0; rank < cutting.size(); ++rank)
    if (lgs::contains(cutting[rank], cell)) return static_cast<int>(rank);
  return {};
}

Cutting cutInto(const lgs::CellRect& cells, int ranks) {
  if (ranks == 1) return {cells};
  const auto share = [&](std::int32_t first, std::int32_t last) {
    return static_cast<std::int32_t>((std::int64_t{last} - first + 1) * (ranks / 2) / ranks);
  };
  lgs::CellRect one = cells;
  lgs::CellRect other = cells;
  if (cells.max.i - cells.min.i >= cells.max.j - cells.min.j) {
    other.min.i = cells.min.i + share(cells.min.i, cells.max.i);
    one.max.i = other.min.i - 1;
  } else {
    other.min.j = cells.min.j + share(cells.min.j, cells.max.j);
    one.max.j = other.min.j - 1;
  }
  Cutting cutting = cutInto(one, ranks / 2);
  for (const lgs::CellRect& piece : cutInto(other, ranks - ranks / 2)) cutting.push_back(piece);
  return cutting;
}

}  // namespace regions
