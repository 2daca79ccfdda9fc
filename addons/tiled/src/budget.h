// What an import may cost. Each file that is read allows for more, in proportion to its bytes; what could cost more
// than that is taken from the budget before it is done. So a map of n bytes takes work and memory in proportion to n,
// beyond the limits of Options, whatever is in it.
#pragma once

#include "pixel_grid.h"
#include "tileset.h"

#include <lgs/tiled/import.h>

namespace lgs::tiled {

class Budget {
 public:
  explicit Budget(const Options& options)
      : bytes_(options.maxBytes), steps_(options.maxWork), cells_(options.maxObjectCells) {
    refill(options);
  }

  /// All the tiles may be read again, and polygons placed: for another pass.
  void refill(const Options& options) { tiles = options.maxTiles, placements = options.maxPlacements; }
  std::size_t tiles = 0, placements = 0;  ///< that are left

  /// Takes the bytes of a file that was read, and allows for what they may cost. False if they are too many.
  [[nodiscard]] bool read(std::size_t bytes);

  /// Takes steps. False from the first time on that there are too few.
  [[nodiscard]] bool work(std::uint64_t steps);

  /// Takes what a shape costs by itself: its outline is made, snapped and compared with itself.
  [[nodiscard]] bool shape(std::size_t vertices);

  /// Takes what it costs to copy a tile of a tileset, with its shapes.
  [[nodiscard]] bool tile(const Tileset& tileset, std::uint32_t id);

  /// Takes what a brush costs that fills an outline, where there is nothing yet.
  [[nodiscard]] bool stroke(const Polygon& ring);

  /// Takes what a brush costs in one cell in which so many vertices meet.
  [[nodiscard]] bool strokeInCell(std::size_t vertices);

  bool isOutOfWork() const { return isOutOfWork_; }
  bool isOutOfCells() const { return isOutOfCells_; }

 private:
  std::uint64_t bytes_, steps_, cells_;
  bool isOutOfWork_ = false, isOutOfCells_ = false;
};

}  // namespace lgs::tiled
