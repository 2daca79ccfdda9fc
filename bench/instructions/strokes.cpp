#include "strokes.h"

#include "cells.h"
#include "oracle/calls/shapes.h"

#include <lgs/brush.h>

#include <cstdlib>
#include <optional>
#include <random>
#include <vector>

namespace lgs::bench {
namespace {

constexpr std::int32_t kGroundSide = 100;
constexpr std::int32_t kRoom = 8;  // cells for a hole, on either axis
constexpr std::size_t kHolesInARow = kGroundSide / kRoom;

/// A full block in each cell; or one of the generator's degenerate shapes, turned at random, and one cell in eight
/// empty, as in bench/tiles.cpp.
World worldOf(StrokeGround ground) {
  const auto& shapes = oracle::degenerateShapes();
  std::mt19937 random(1);
  World world;
  for (std::int32_t j = 0; j < kGroundSide; ++j) {
    for (std::int32_t i = 0; i < kGroundSide; ++i) {
      if (ground == StrokeGround::mixed && random() % 8 == 0) continue;
      const auto& shape = ground == StrokeGround::full ? shapes[0] : shapes[random() % shapes.size()];
      const int symmetry = ground == StrokeGround::full ? 0 : static_cast<int>(random() % 8);
      for (const oracle::LocalPolygon& polygon : shape.polygons)
        if (!world.add({i, j}, oracle::turned(polygon, symmetry), 1)) std::abort();
    }
  }
  world.commit();
  return world;
}

/// A 32-gon of radius 3 around any lattice point, so that no hole meets another.
Region hole(std::size_t k, std::mt19937& random) {
  const auto coordinate = [&](std::size_t place) {
    const auto inCell = static_cast<std::int64_t>(random() % kUnitsPerCell);
    return static_cast<std::int64_t>(place * kRoom + kRoom / 2) * kUnitsPerCell + inCell;
  };
  const std::int64_t x = coordinate(k % kHolesInARow), y = coordinate(k / kHolesInARow);
  return circle({x, y}, 3 * kUnitsPerCell, 32);
}

}  // namespace

void carveHoles(StrokeGround ground, std::size_t count, bool isUndone) {
  World world = worldOf(ground);
  if (count > kHolesInARow * kHolesInARow) std::abort();
  std::mt19937 random(2);
  for (std::size_t k = 0; k < count; ++k) {
    const std::optional<Mark> before = isUndone ? std::optional(world.mark()) : std::nullopt;
    if (!carve(world, hole(k, random))) std::abort();
    world.commit();
    if (before && !world.rollBack(*before)) std::abort();
  }
}

std::size_t cellsCut(std::size_t count) {
  std::mt19937 random(2);
  std::size_t cells = 0;
  for (std::size_t k = 0; k < count; ++k) cells += brush::coverage(hole(k, random)).cut.size();
  return cells;
}

}  // namespace lgs::bench
