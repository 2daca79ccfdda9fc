// What a world answers when it is asked, against the slow way: all polygons, all segments.
#pragma once

#include "oracle/calls/random.h"

#include <lgs/world.h>
#include <string>

namespace lgs::fuzz {

/// Asks where a few points lie, which segment is nearest to them and what rays between them meet. Says what is wrong;
/// nothing, if all is right. The world has all of its chunks in memory.
std::string wrongAnswers(const World& world, oracle::Random& random);

/// The same for all that can be read: segments in reals, shapes, bounds, counts, the trace that a world is written as.
std::string wrongReads(const World& world);

}  // namespace lgs::fuzz
