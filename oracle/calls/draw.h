// Draws calls. What is done most, and on which cells, is up to habits.
#pragma once

#include "oracle/calls/call.h"
#include "oracle/calls/random.h"

#include <array>

namespace lgs::oracle {

struct Habits {
  std::int32_t width = 4;  ///< cells, from (0, 0) on: few, so that calls meet
  std::int32_t height = 4;
  Block blocks = 4;     ///< 0 and more
  int badPercent = 10;  ///< of the polygons
  /// Of the cells, rectangles, blocks, names and polygons: the ends of their numbers, and what means something inside.
  int hostilePercent = 0;
  /// Of the kinds, in their order: marks and loads are for those who ask for them.
  std::array<int, Call::kKinds> weights{3, 14, 16, 4, 16, 3, 6, 7, 5, 4, 3, 2, 14,
                                        0, 0,  0,  0, 1,  0, 0, 0, 0, 0, 0, 0, 0};
};

Habits withMarks(Habits habits);
Habits withLoads(Habits habits);

Call drawCall(Random& choices, const Habits& habits);

/// A polygon: of a degenerate shape as a rule, or a box or a triangle.
LocalPolygon drawPolygon(Random& choices);

/// With something wrong with it, as a rule.
LocalPolygon spoilt(Random& choices, LocalPolygon polygon);

}  // namespace lgs::oracle
