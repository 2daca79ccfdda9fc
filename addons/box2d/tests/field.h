// A world and its scene, which are made side by side, for rides.
#pragma once

#include "oracle/reference/scene.h"

#include <gtest/gtest.h>
#include <lgs/world.h>
#include <vector>

namespace lgs::box2d_test {

using Polygon = std::vector<LocalPoint>;
inline constexpr std::int32_t U = kUnitsPerCell;

inline const Polygon kSquare{{0, 0}, {U, 0}, {U, U}, {0, U}};

/// Solid below a straight line. The heights at the left and at the right side are in eighths of a cell.
inline Polygon below(std::int32_t left, std::int32_t right) {
  Polygon polygon{{0, 0}, {U, 0}};
  if (right > 0) polygon.push_back({U, right * U / 8});
  if (left > 0) polygon.push_back({0, left * U / 8});
  return polygon;
}

/// Solid above such a line.
inline Polygon above(std::int32_t left, std::int32_t right) {
  Polygon polygon{{U, U}, {0, U}};
  if (left < 8) polygon.push_back({0, left * U / 8});
  if (right < 8) polygon.push_back({U, right * U / 8});
  return polygon;
}

struct Field {
  World world;
  oracle::Scene scene;

  PolygonHandle add(Cell cell, const Polygon& polygon, Block block = 1) {
    const auto handle = world.add(cell, std::span<const LocalPoint>(polygon), block);
    EXPECT_TRUE(handle.has_value());
    scene.polygons.push_back({cell, block, polygon});
    return *handle;
  }

  /// Squares from one column to another, in the row below y = 0.
  void addFloor(std::int32_t from, std::int32_t to) {
    for (std::int32_t i = from; i <= to; ++i) add({i, -1}, kSquare);
  }
};

}  // namespace lgs::box2d_test
