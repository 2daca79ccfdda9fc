// A number for each cell. They lie in squares of cells, so that a large map costs little more than its numbers: a hash
// for each square instead of each cell, and no sorting of cells.
#pragma once

#include <lgs/lattice.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace lgs::tiled {

class CellNumbers {
 public:
  /// The number of a cell, 0 at first. Valid until the next call.
  std::uint32_t& operator[](Cell cell) {
    const Cell place{cell.i >> kBits, cell.j >> kBits};
    if (last_ == nullptr || place != lastPlace_) {
      lastPlace_ = place;
      last_ = &squares_[place];
    }
    return (*last_)[indexOf(cell.i & kMask, cell.j & kMask)];
  }

  /// Visits the cells whose numbers are not 0, row by row from the lowest: visit(cell, number).
  template <class Visit>
  void visit(Visit&& visit) const {
    std::vector<std::pair<Cell, const Square*>> order;
    for (const auto& [place, square] : squares_) order.push_back({place, &square});
    std::sort(order.begin(), order.end(), [](const auto& a, const auto& b) {
      return std::tie(a.first.j, a.first.i) < std::tie(b.first.j, b.first.i);
    });
    for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
      while (end < order.size() && order[end].first.j == order[begin].first.j) ++end;
      for (std::int32_t j = 0; j <= kMask; ++j) {
        for (std::size_t k = begin; k < end; ++k) visitRow(*order[k].second, order[k].first, j, visit);
      }
    }
  }

 private:
  static constexpr int kBits = 4;
  static constexpr std::int32_t kMask = (1 << kBits) - 1;
  using Square = std::array<std::uint32_t, std::size_t{1} << 2 * kBits>;

  struct Hash {
    std::size_t operator()(Cell c) const {
      const std::uint64_t both =
          static_cast<std::uint64_t>(static_cast<std::uint32_t>(c.i)) << 32 | static_cast<std::uint32_t>(c.j);
      const std::uint64_t mixed = both * 0x9E37'79B9'7F4A'7C15;
      return static_cast<std::size_t>(mixed ^ mixed >> 32);
    }
  };

  static std::size_t indexOf(std::int32_t i, std::int32_t j) { return static_cast<std::size_t>(j << kBits | i); }

  template <class Visit>
  static void visitRow(const Square& square, Cell place, std::int32_t j, Visit&& visit) {
    for (std::int32_t i = 0; i <= kMask; ++i) {
      const std::uint32_t number = square[indexOf(i, j)];
      if (number != 0) visit(Cell{place.i * (kMask + 1) + i, place.j * (kMask + 1) + j}, number);
    }
  }

  std::unordered_map<Cell, Square, Hash> squares_;
  Cell lastPlace_;
  Square* last_ = nullptr;  // squares stay where they are
};

}  // namespace lgs::tiled
