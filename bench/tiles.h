// The worlds that are measured: a rectangle of cells, each with one of a few contents, as in a tile map. This form is
// small even for 10 million cells, and every subject turns it into its own.
#pragma once

#include "oracle/reference/scene.h"

#include <lgs/lattice.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace lgs::bench {

/// What can stand in a cell. Without polygons it is an empty cell.
struct Kind {
  std::vector<std::vector<LocalPoint>> polygons;
  Block block = 1;
  friend auto operator<=>(const Kind&, const Kind&) = default;
};

struct Tiles {
  std::string name;
  std::int32_t width = 0;  ///< cells
  std::int32_t height = 0;
  std::vector<Kind> kinds;        ///< all that occur
  std::vector<std::uint16_t> at;  ///< the kind in each cell, by rows

  std::size_t size() const { return at.size(); }
  Cell cell(std::size_t k) const {
    return {static_cast<std::int32_t>(k % static_cast<std::size_t>(width)),
            static_cast<std::int32_t>(k / static_cast<std::size_t>(width))};
  }
  const Kind& kind(std::size_t k) const { return kinds[at[k]]; }
  bool isEmpty(std::size_t k) const { return kind(k).polygons.empty(); }
  std::size_t occupied() const;
  oracle::Scene scene() const;
};

struct Size {
  std::int32_t width;
  std::int32_t height;
};

/// The article's FullBlock: a full square in every cell.
Tiles fullTiles(Size size);

/// The article's RAMP: a randomly turned right triangle in every cell.
Tiles rampTiles(Size size);

/// The project's map, repeated as often as it takes.
Tiles mapTiles(Size size);

/// The generator's degenerate shapes, turned at random. One cell in eight is empty.
Tiles mixTiles(Size size);

/// One of the four, by its name: "full", "ramp", "map" or "mix".
Tiles makeTiles(const std::string& name, Size size);

/// The size of a world of this many cells. It is a square, except for 10 million cells.
Size sizeOf(std::int64_t cells);

}  // namespace lgs::bench
