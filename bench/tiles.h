// Worlds to measure: a rectangle of cells, each with one of a few contents, as a tile map has them. Small enough to be
// held at 10 million cells, and turned into whatever a subject takes.
#pragma once

#include "oracle/reference/scene.h"

#include <lgs/lattice.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace lgs::bench {

/// What can stand in a cell. No polygons: nothing.
struct Kind {
  std::vector<std::vector<LocalPoint>> polygons;
  Block block = 1;
  friend auto operator<=>(const Kind&, const Kind&) = default;
};

struct Tiles {
  std::string name;
  std::int32_t width = 0;  ///< cells
  std::int32_t height = 0;
  std::vector<Kind> kinds;        ///< all that occur, and perhaps one more to put in their place
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

/// Degenerate shapes of the generator, turned at random; one cell in eight is empty.
Tiles mixTiles(Size size);

/// All four, by name: "full", "ramp", "map", "mix".
Tiles makeTiles(const std::string& name, Size size);

/// The size of a world of this many cells: a square, but for 10 million.
Size sizeOf(std::int64_t cells);

}  // namespace lgs::bench
