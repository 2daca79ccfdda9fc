// Worlds of any size that look the same around one place, and edits there.
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

inline constexpr std::int32_t kSmall = 100;  ///< cells along a side: 10,000 in all
inline constexpr std::int32_t kLarge = 316;  ///< 100,000

class Ground {
 public:
  /// A square of so many cells on a side, with blocks, slopes, cells of several polygons, and gaps.
  explicit Ground(std::int32_t side);

  World world;

  static constexpr Cell kPlace{47, 50};
  static constexpr CellRect kField{{40, 44}, {45, 49}};  ///< where the tests fill and clear

  void put(Cell cell);  ///< what belongs into a cell

 private:
  std::vector<ShapeId> shapes_;  // the null id: a gap
};

/// Makes the same edits again and again, and says what they cost the third time, when no list grows any more. `sync` is
/// called after each commit, and counts as well.
Costs costsOf(Ground& ground, const std::function<void(const Changes&)>& sync);

/// Not about the same: equal.
void expectSame(const Costs& small, const Costs& large);

}  // namespace lgs::cost_test
