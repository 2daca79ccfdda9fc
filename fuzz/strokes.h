// Strokes of any form: circles, rectangles, thick lines, and rings that cross; by either rule, with blocks that stay.
#pragma once

#include "oracle/calls/random.h"

#include <lgs/brush.h>
#include <string>

namespace lgs::fuzz {

struct Stroke {
  Region region;
  enum class Deed { carve, fill, replace } deed{};
  Block block = 0;
  StayingBlocks staying = {};

  Expected<BrushResult> make(World& world) const;
};

/// One near the ground of a world.
Stroke drawStroke(const World& world, oracle::Random& random);

/// Makes a stroke, commits it, and rolls back and redoes it. Says what breaks a law, if anything does. Afterwards
/// the world is as before; or, if it is told to, as after the stroke.
std::string strokeAndGoBack(World& world, oracle::Random& random, bool stays = false);

}  // namespace lgs::fuzz
