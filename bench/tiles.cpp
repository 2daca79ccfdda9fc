#include "bench/tiles.h"

#include "oracle/calls/random.h"
#include "oracle/calls/shapes.h"

#include <lgs/tiled/import.h>
#include <lgs/world.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace lgs::bench {
namespace {

using oracle::Random;

Tiles emptyTiles(std::string name, Size size) {
  Tiles tiles{std::move(name), size.width, size.height, {}, {}};
  tiles.at.resize(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
  return tiles;
}

constexpr std::int32_t U = kUnitsPerCell;
const Kind kRamps[] = {{{{{0, 0}, {U, 0}, {U, U}}}},
                       {{{{0, 0}, {U, 0}, {0, U}}}},
                       {{{{0, 0}, {U, U}, {0, U}}}},
                       {{{{U, 0}, {U, U}, {0, U}}}}};

tiled::ImportedMap importLandscape() {
  tiled::Options options;
  options.blockFrom = tiled::BlockFrom::tileClass;
  auto map = tiled::importMap(LGS_SOURCE_DIR "/examples/maps/landscape.tmx", options);
  if (!map) throw std::runtime_error(tiled::message(map.error()));
  return std::move(*map);
}

// The project's map as it is in the file.
Tiles landscape() {
  const tiled::ImportedMap map = importLandscape();
  std::map<Cell, Kind> cells;
  for (const tiled::MapPolygon& p : map.placements) {
    Kind& kind = cells[p.cell];
    kind.polygons.push_back(map.shapes[p.shape]);
    kind.block = p.block;  // a cell has one block here, even where layers overlap
  }
  Cell min = cells.begin()->first;
  Cell max = min;
  for (const auto& [cell, kind] : cells) {
    min = {std::min(min.i, cell.i), std::min(min.j, cell.j)};
    max = {std::max(max.i, cell.i), std::max(max.j, cell.j)};
  }
  Tiles tiles = emptyTiles("map", {max.i - min.i + 1, max.j - min.j + 1});
  std::map<Kind, std::uint16_t> numbers{{Kind{}, 0}};
  tiles.kinds.emplace_back();
  for (const auto& [cell, kind] : cells) {
    const auto [entry, isNew] = numbers.try_emplace(kind, static_cast<std::uint16_t>(tiles.kinds.size()));
    if (isNew) tiles.kinds.push_back(kind);
    const std::int64_t k = std::int64_t{cell.j - min.j} * tiles.width + (cell.i - min.i);
    tiles.at[static_cast<std::size_t>(k)] = entry->second;
  }
  return tiles;
}

}  // namespace

std::size_t Tiles::occupied() const {
  std::size_t count = 0;
  for (std::size_t k = 0; k < size(); ++k) count += isEmpty(k) ? 0 : 1;
  return count;
}

oracle::Scene Tiles::scene() const {
  oracle::Scene scene;
  for (std::size_t k = 0; k < size(); ++k) {
    for (const auto& polygon : kind(k).polygons) scene.polygons.push_back({cell(k), kind(k).block, polygon});
  }
  return scene;
}

Tiles fullTiles(Size size) {
  Tiles tiles = emptyTiles("full", size);
  tiles.kinds.push_back({{{kUnitSquare.begin(), kUnitSquare.end()}}});
  return tiles;
}

Tiles rampTiles(Size size) {
  Tiles tiles = emptyTiles("ramp", size);
  tiles.kinds.assign(std::begin(kRamps), std::end(kRamps));
  Random random(1);
  for (std::uint16_t& at : tiles.at) at = static_cast<std::uint16_t>(random.below(4));
  return tiles;
}

Tiles mapTiles(Size size) {
  static const Tiles map = landscape();
  Tiles tiles = emptyTiles("map", size);
  tiles.kinds = map.kinds;
  for (std::size_t k = 0; k < tiles.size(); ++k) {
    const Cell cell = tiles.cell(k);
    tiles.at[k] = map.at[static_cast<std::size_t>(std::int64_t{cell.j % map.height} * map.width + cell.i % map.width)];
  }
  return tiles;
}

Tiles mixTiles(Size size) {
  Tiles tiles = emptyTiles("mix", size);
  tiles.kinds.emplace_back();
  for (const oracle::NamedShape& shape : oracle::degenerateShapes()) {
    for (int symmetry = 0; symmetry < 8; ++symmetry) {
      Kind& kind = tiles.kinds.emplace_back();
      for (const auto& polygon : shape.polygons) kind.polygons.push_back(oracle::turned(polygon, symmetry));
    }
  }
  Random random(1);
  for (std::uint16_t& at : tiles.at) {
    at = random.below(8) == 0 ? std::uint16_t{0} : static_cast<std::uint16_t>(1 + random.below(tiles.kinds.size() - 1));
  }
  return tiles;
}

Tiles makeTiles(const std::string& name, Size size) {
  if (name == "full") return fullTiles(size);
  if (name == "ramp") return rampTiles(size);
  if (name == "map") return mapTiles(size);
  return mixTiles(size);
}

Size sizeOf(std::int64_t cells) {
  if (cells == 10'000'000) return {4000, 2500};
  const auto side = static_cast<std::int32_t>(std::llround(std::sqrt(static_cast<double>(cells))));
  return {side, side};
}

}  // namespace lgs::bench
