// What an import may cost (docs/maps.md, "What a map may cost"): it is taken from the budget before it is done.
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
  [[nodiscard]] bool shape(std::uint64_t vertices) { return work(1'000 + 64 * vertices + vertices * vertices); }

  /// Takes what it costs to copy a tile of a tileset, with its shapes.
  [[nodiscard]] bool tile(const Tileset& tileset, std::uint32_t id);

  /// Takes what a brush costs that fills an outline, where there is nothing yet.
  [[nodiscard]] bool stroke(const Polygon& ring);

  /// Takes what a brush costs in one cell in which so many vertices meet.
  [[nodiscard]] bool strokeInCell(std::uint64_t vertices) { return work(4'500 + 32 * vertices * vertices); }

  bool isOutOfWork() const { return isOutOfWork_; }
  bool isOutOfCells() const { return isOutOfCells_; }

 private:
  std::uint64_t bytes_, steps_, cells_;
  bool isOutOfWork_ = false, isOutOfCells_ = false;
};

}  // namespace lgs::tiled
