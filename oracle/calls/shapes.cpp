#include "oracle/calls/shapes.h"

#include <algorithm>

namespace lgs::oracle {
namespace {

constexpr std::int32_t U = kUnitsPerCell;

// Vertices in eighths of a cell.
LocalPolygon e(LocalPolygon polygon) {
  for (LocalPoint& p : polygon) p = {p.x * (U / 8), p.y * (U / 8)};
  return polygon;
}

std::vector<NamedShape> makePalette() {
  const LocalPolygon square = e({{0, 0}, {8, 0}, {8, 8}, {0, 8}});
  const LocalPolygon ramp = e({{0, 0}, {8, 0}, {8, 8}});
  const LocalPolygon cup = e({{0, 0}, {8, 0}, {8, 8}, {6, 8}, {6, 2}, {2, 2}, {2, 8}, {0, 8}});
  return {
      {"full", {square}},
      {"half", {e({{0, 0}, {8, 0}, {8, 4}, {0, 4}})}},
      {"two halves", {e({{0, 0}, {8, 0}, {8, 4}, {0, 4}}), e({{0, 4}, {8, 4}, {8, 8}, {0, 8}})}},
      {"quarter", {e({{0, 0}, {4, 0}, {4, 4}, {0, 4}})}},
      {"two quarters", {e({{0, 0}, {4, 0}, {4, 4}, {0, 4}}), e({{4, 4}, {8, 4}, {8, 8}, {4, 8}})}},
      {"inner square", {e({{2, 2}, {6, 2}, {6, 6}, {2, 6}})}},
      // slopes
      {"ramp", {ramp}},
      {"two ramps", {ramp, e({{0, 0}, {8, 8}, {0, 8}})}},
      {"ramp in two parts", {e({{0, 0}, {8, 0}, {4, 4}}), e({{8, 0}, {8, 8}, {4, 4}})}},
      {"gentle, low", {e({{0, 0}, {8, 0}, {8, 4}})}},
      {"gentle, high", {e({{0, 0}, {8, 0}, {8, 8}, {0, 4}})}},
      {"gentler, first", {e({{0, 0}, {8, 0}, {8, 2}})}},
      {"gentler, third", {e({{0, 0}, {8, 0}, {8, 6}, {0, 4}})}},
      {"gentle and its complement", {e({{0, 0}, {8, 0}, {8, 4}}), e({{0, 0}, {8, 4}, {8, 8}, {0, 8}})}},
      {"third", {{{0, 0}, {U, 0}, {U, 21'845}}, {{0, 0}, {U, 21'845}, {U, U}, {0, U}}}},
      // contacts on a slanted edge: two on one, a part of one, one in the middle
      {"two on one slope", {ramp, e({{0, 0}, {4, 4}, {0, 8}}), e({{4, 4}, {8, 8}, {0, 8}})}},
      {"part of a slope", {ramp, e({{2, 2}, {6, 6}, {1, 7}})}},
      {"overhang on a slope", {e({{0, 2}, {8, 2}, {4, 6}}), e({{2, 4}, {4, 6}, {6, 8}, {0, 8}})}},
      {"a corner on a slope", {ramp, e({{4, 4}, {3, 8}, {1, 6}})}},
      // touching a wall in the middle
      {"diamond", {e({{4, 0}, {8, 4}, {4, 8}, {0, 4}})}},
      {"spike", {e({{2, 0}, {6, 0}, {4, 8}})}},
      {"side spike", {e({{0, 0}, {8, 3}, {0, 6}})}},
      {"comb", {e({{0, 0}, {8, 0}, {7, 8}, {6, 1}, {5, 8}, {4, 1}, {3, 8}, {2, 1}, {1, 8}})}},
      {"star", {e({{0, 0}, {4, 3}, {8, 0}, {5, 4}, {8, 8}, {4, 5}, {0, 8}, {3, 4}})}},
      {"corner touch", {e({{0, 0}, {3, 1}, {1, 3}})}},
      {"two corner touches", {e({{0, 0}, {2, 0}, {1, 2}}), e({{8, 8}, {6, 7}, {7, 6}})}},
      // holes, and what fills them
      {"L", {e({{0, 0}, {8, 0}, {8, 4}, {4, 4}, {4, 8}, {0, 8}})}},
      {"cup", {cup}},
      {"plugged cup", {cup, e({{2, 2}, {6, 2}, {6, 8}, {2, 8}})}},
      {"cup with island", {cup, e({{3, 4}, {5, 4}, {5, 6}, {3, 6}})}},
      {"ring",
       {e({{0, 0}, {8, 0}, {8, 2}, {2, 2}, {2, 8}, {0, 8}}), e({{8, 2}, {8, 8}, {2, 8}, {2, 6}, {6, 6}, {6, 2}})}},
      // two that share an edge and touch once more, with a vertex on an edge: so their outline touches itself
      {"gap with a corner",
       {e({{0, 0}, {4, 0}, {4, 4}, {0, 4}}), e({{4, 0}, {8, 0}, {8, 8}, {2, 8}, {2, 4}, {3, 6}, {4, 4}})}},
      // many at one point
      {"four around the middle",
       {e({{0, 0}, {8, 0}, {4, 4}}), e({{8, 0}, {8, 8}, {4, 4}}), e({{8, 8}, {0, 8}, {4, 4}}),
        e({{0, 8}, {0, 0}, {4, 4}})}},
      {"hourglass", {e({{0, 0}, {8, 0}, {4, 4}}), e({{8, 8}, {0, 8}, {4, 4}})}},
      {"fan", {e({{0, 0}, {8, 0}, {8, 2}}), e({{0, 0}, {8, 4}, {8, 6}}), e({{0, 0}, {6, 8}, {2, 8}})}},
      // one lattice unit thin
      {"floor sliver", {{{0, 0}, {U, 0}, {U, 1}, {0, 1}}}},
      {"wedge sliver", {{{0, 0}, {U, 0}, {U, 1}}, {{0, 0}, {U, U - 1}, {U, U}}}},
      {"dots", {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{U / 2, 0}, {U / 2 + 1, 0}, {U / 2 + 1, 1}, {U / 2, 1}}}},
      // redundant vertices, on the rim and on a slope
      {"square of eight", {e({{0, 0}, {4, 0}, {8, 0}, {8, 4}, {8, 8}, {4, 8}, {0, 8}, {0, 4}})}},
      {"ramp of five", {e({{0, 0}, {1, 0}, {8, 0}, {8, 8}, {4, 4}})}},
  };
}

}  // namespace

const std::vector<NamedShape>& degenerateShapes() {
  static const std::vector<NamedShape> shapes = makePalette();
  return shapes;
}

LocalPolygon turned(const LocalPolygon& polygon, int symmetry) {
  LocalPolygon result = polygon;
  for (LocalPoint& p : result) {
    if (symmetry & 1) p.x = U - p.x;
    if (symmetry & 2) p.y = U - p.y;
    if (symmetry & 4) std::swap(p.x, p.y);
  }
  const bool mirrored = ((symmetry & 1) + (symmetry >> 1 & 1) + (symmetry >> 2 & 1)) % 2 != 0;
  if (mirrored) std::reverse(result.begin(), result.end());
  return result;
}

}  // namespace lgs::oracle
