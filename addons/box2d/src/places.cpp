#include "places.h"

#include <lgs/lattice.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace lgs::box2d {

namespace {

/// A cell with lower left corners of boxes.
struct CornerCell {
  std::int64_t row, column;
  std::uint32_t number = 0;  // in the order in which the cells were met
  auto key() const { return std::pair(row, column); }
};

/// Sets of cells that are joined one by one: a union-find.
class Joined {
 public:
  explicit Joined(std::size_t count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), 0U); }
  std::uint32_t setOf(std::uint32_t cell) {
    while (parents_[cell] != cell) cell = parents_[cell] = parents_[parents_[cell]];
    return cell;
  }
  void join(std::uint32_t a, std::uint32_t b) { parents_[setOf(b)] = setOf(a); }

 private:
  std::vector<std::uint32_t> parents_;
};

std::int64_t indexOf(double units) { return static_cast<std::int64_t>(std::floor(units / kUnitsPerCell)); }

}  // namespace

std::vector<ChangedPlace> placesOf(std::span<const Box> boxes) {
  std::vector<CornerCell> cells;
  std::vector<std::uint32_t> cellOf;  // of each box; changes come cell by cell, so most are in that of the one before
  for (const Box& box : boxes) {
    const CornerCell cell{indexOf(box.min.y), indexOf(box.min.x), static_cast<std::uint32_t>(cells.size())};
    if (cells.empty() || cells.back().key() != cell.key()) cells.push_back(cell);
    cellOf.push_back(cells.back().number);
  }
  std::ranges::sort(cells, {}, [](const CornerCell& cell) { return std::tuple(cell.row, cell.column, cell.number); });

  Joined joined(cells.size());
  for (std::size_t k = 1; k < cells.size(); ++k) {
    const CornerCell& cell = cells[k];
    if (cells[k - 1].row == cell.row && cells[k - 1].column + 1 >= cell.column)
      joined.join(cells[k - 1].number, cell.number);
    if (cells[k - 1].key() == cell.key()) continue;  // what is below that one is below this one
    const auto below = std::pair(cell.row - 1, cell.column - 1);
    for (auto other = std::ranges::lower_bound(cells, below, {}, &CornerCell::key);
         other->row == below.first && other->column <= cell.column + 1; ++other)
      joined.join(other->number, cell.number);
  }

  std::vector<ChangedPlace> places;
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> placeOf(cells.size(), kNone);  // of each set
  for (std::uint32_t k = 0; k < boxes.size(); ++k) {
    std::uint32_t& number = placeOf[joined.setOf(cellOf[k])];
    if (number == kNone) {
      number = static_cast<std::uint32_t>(places.size());
      places.push_back({boxes[k], {}});
    }
    ChangedPlace& place = places[number];
    place.box = around(place.box, boxes[k]);
    place.boxes.push_back(k);
  }
  return places;
}

}  // namespace lgs::box2d
