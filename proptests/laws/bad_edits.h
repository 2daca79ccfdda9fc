// Every kind of edit that must be refused, on one small stage, with the error that each must give. law7_errors_test.cpp
// checks what the errors say, law7_refusal_test.cpp that nothing else happens.
#pragma once

#include "proptests/support/worlds.h"

#include <functional>
#include <string>

namespace lgs::test {

/// A world for bad edits: cell (0, 0) is full; in (1, 0) stands a ramp, and another polygon was removed; (2, 0) has two
/// polygons. Everything else is empty.
struct Stage {
  World world;
  ShapeId square, twoRamps;
  PolygonHandle full, ramp, removed, lower, upper;
  static const std::vector<Cell>& cells();  ///< all that the bad edits are about
};
Stage makeStage();

struct BadEdit {
  std::string name;
  std::function<Error(Stage&)> attempt;  ///< tries it; code {} if it was accepted
  std::string text;                      ///< the message, which tells each field that has a value
};
const std::vector<BadEdit>& badEdits();

}  // namespace lgs::test
