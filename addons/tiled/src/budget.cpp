// The weights were measured: a step takes some nanoseconds.
#include "budget.h"

#include <algorithm>

namespace lgs::tiled {
namespace {

/// The cells that an edge runs through, row by row.
template <class Visit>
bool alongEdge(Point a, Point b, const Visit& visit) {
  if (b.y < a.y) std::swap(a, b);
  const auto xAt = [&](std::int64_t y) { return a.y == b.y ? b.x : a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y); };
  for (std::int64_t j = a.y >> kCellBits; j <= b.y >> kCellBits; ++j) {
    const std::int64_t low = xAt(std::max(a.y, j * kUnitsPerCell));
    const std::int64_t high = a.y == b.y ? a.x : xAt(std::min(b.y, (j + 1) * kUnitsPerCell));
    for (std::int64_t i = std::min(low, high) >> kCellBits; i <= std::max(low, high) >> kCellBits; ++i) {
      if (!visit(Cell{static_cast<std::int32_t>(i), static_cast<std::int32_t>(j)})) return false;
    }
  }
  return true;
}

}  // namespace

bool Budget::read(std::size_t bytes) {
  if (bytes > bytes_) return false;
  bytes_ -= bytes;
  // Limits may be huge.
  const auto allow = [](std::uint64_t& left, std::uint64_t more) { left += std::min(more, ~left); };
  allow(steps_, kWorkPerByte * bytes);
  allow(cells_, kObjectCellsPerByte * bytes);
  return true;
}

bool Budget::work(std::uint64_t steps) {
  isOutOfWork_ = isOutOfWork_ || steps > steps_;
  if (!isOutOfWork_) steps_ -= steps;
  return !isOutOfWork_;
}

bool Budget::tile(const Tileset& tileset, std::uint32_t id) {
  std::uint64_t steps = 1'000;
  for (const CollisionObject& object : tileset.tile(id).objects) steps += 200 + object.points.size();
  return work(steps);
}

bool Budget::stroke(const Polygon& ring) {
  const Box box = boundingBox(ring);
  const auto along = [](std::int64_t min, std::int64_t max) {
    return static_cast<std::uint64_t>((std::max(min, max - 1) >> kCellBits) - (min >> kCellBits) + 1);
  };
  const std::uint64_t cells = along(box.min.x, box.max.x) * along(box.min.y, box.max.y);
  isOutOfCells_ = isOutOfCells_ || cells > cells_;
  if (isOutOfCells_) return false;
  cells_ -= cells;
  std::vector<Cell> through;  // one for each edge that runs through it
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const bool isFine = alongEdge(ring[k], nextVertex(ring, k), [&](Cell cell) {
      through.push_back(cell);
      return work(100);
    });
    if (!isFine) return false;
  }
  std::sort(through.begin(), through.end());
  for (auto from = through.begin(); from != through.end();) {
    const auto to = std::upper_bound(from, through.end(), *from);
    if (!strokeInCell(static_cast<std::uint64_t>(to - from))) return false;
    from = to;
  }
  return true;
}

}  // namespace lgs::tiled
