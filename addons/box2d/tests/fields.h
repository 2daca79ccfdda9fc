// The worlds for the rides, for both generations of Box2D.
#pragma once

#include "field.h"

#include <lgs/tiled/import.h>

namespace lgs::box2d_test {

inline Field floorOf200Cells() {
  Field field;
  field.addFloor(-2, 205);
  field.world.commit();
  return field;
}

struct Profile {
  const char* name;
  std::vector<Polygon> columns;  // repeated; each begins at the height where the last one ends, up to whole cells
  std::vector<std::int32_t> rises;
};

// Heights in eighths; a rise of 1 after a column lifts the next ones by a cell.
inline std::vector<Profile> profiles() {
  return {{"gentle down and flat",
           {below(8, 7), below(7, 6), below(6, 6), below(6, 4), below(4, 4), below(4, 0)},
           {0, 0, 0, 0, 0, -1}},
          {"steep down and flat", {kSquare, below(8, 0), kSquare, kSquare}, {0, -1, 0, 0}},
          {"valleys", {below(8, 4), below(4, 2), below(2, 2), below(2, 4), below(4, 8)}, {0, 0, 0, 0, 0}},
          {"waves with T-contacts", {below(8, 6), below(6, 6), below(6, 8), kSquare}, {0, 0, 0, 0}}};
}

inline Field hilly(const Profile& profile, bool ceiling) {
  Field field;
  std::int32_t j = 0;
  for (std::size_t k = 0; k < 120; ++k) {
    const std::size_t at = k % profile.columns.size();
    Polygon column = profile.columns[at];
    if (ceiling) {  // half a turn about the middle of the cell, and in the other order
      for (LocalPoint& p : column) p = {U - p.x, U - p.y};
    }
    const auto i = static_cast<std::int32_t>(k);
    field.add(ceiling ? Cell{-i, -j} : Cell{i, j}, column);
    if (k == 0) field.add(ceiling ? Cell{1, -j - 1} : Cell{-1, j + 1}, kSquare);  // a wall at the beginning
    field.add(ceiling ? Cell{-i, -j + 1} : Cell{i, j - 1}, kSquare);
    j += profile.rises[at];
  }
  field.world.commit();
  return field;
}

inline Field landscape() {
  const auto map = tiled::importMap(LGS_SOURCE_DIR "/examples/maps/landscape.tmx");
  EXPECT_TRUE(map);
  Field field;
  for (const tiled::MapPolygon& p : map->placements) field.add(p.cell, map->shapes[p.shape], p.block);
  field.world.commit();
  return field;
}

}  // namespace lgs::box2d_test
