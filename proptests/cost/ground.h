// Worlds of any size that look the same around one place, and what edits there cost.
#pragma once

#include "visits.h"

#include <lgs/world.h>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace lgs::cost_test {

/// Basic blocks by what was done.
using Costs = std::map<std::string, std::uint64_t>;

inline constexpr std::int32_t kSmall = 80;   ///< cells along a side
inline constexpr std::int32_t kLarge = 250;  ///< ten times as many cells

/// A comb of long teeth that lie above each other: all of them cross each upright line.
std::vector<LocalPoint> comb(std::int32_t teeth);

class Ground {
 public:
  /// A square of so many cells on a side, with blocks, slopes, cells of several polygons, gaps, and cells unlike all
  /// others.
  explicit Ground(std::int32_t side);

  World world;

  static constexpr Cell kPlace{47, 50};
  static constexpr CellRect kField{{40, 44}, {45, 49}};  ///< where the tests fill and clear

 private:
  void put(Cell cell);  // what belongs into a cell

  std::vector<ShapeId> shapes_;  // the null id is a gap
};

/// Makes the same edits again and again, and says what they cost the last time, when no list grows any more. `sync` is
/// called after each commit, and counts as well.
Costs costsOf(Ground& ground, const std::function<void(const Changes&)>& sync);

/// Expects that nothing costs more in the larger one of two worlds with these sides. A few blocks more are allowed: chunks
/// of the small world have fewer neighbours. Hash tables have seeds of their own, so a search may take some steps more in
/// one world than in another like it: what costs more is counted again, in new worlds, and the least counts.
void expectNoMore(const std::function<Costs(std::int32_t side)>& costs, std::int32_t small, std::int32_t large);

}  // namespace lgs::cost_test
