// What engines of regions in C++ read: the coordinates of a stroke.
#pragma once

#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

/// The rest of a line, x y x y … | x y …, in lattice units. A double has what is read exactly.
inline std::vector<std::vector<std::pair<std::int64_t, std::int64_t>>> readRings(std::istringstream& words) {
  constexpr double kUnits = 65'536;  // of the lattice, in a cell
  std::vector<std::vector<std::pair<std::int64_t, std::int64_t>>> rings(1);
  for (std::string x, y; words >> x;) {
    if (x == "|") {
      rings.emplace_back();
    } else if (words >> y) {
      rings.back().emplace_back(std::llround(std::stod(x) * kUnits), std::llround(std::stod(y) * kUnits));
    }
  }
  return rings;
}
