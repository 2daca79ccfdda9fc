// One edit by a brush, as a plain value: of a trace, and for the oracle of brushes.
#pragma once

#include <lgs/ids.h>
#include <lgs/lattice.h>

#include <vector>

namespace lgs::oracle {

/// One edit by a brush: the region's vertices are lattice points.
struct BrushEdit {
  enum class Deed { carve, fill, replace };
  Deed deed = Deed::carve;
  Block block = 0;
  std::vector<std::vector<Point>> rings;
  /// Inside is where the rings run around an odd number of times. Otherwise it is wherever they run around: simple rings
  /// that run the same way are united.
  bool isEvenOdd = true;
  std::vector<Block> staying = {};  ///< blocks that the brush goes around
  friend bool operator==(const BrushEdit&, const BrushEdit&) = default;
};

}  // namespace lgs::oracle
