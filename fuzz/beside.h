// What may be done to a world beside the edits of an input, each time with what must hold then.
#pragma once

#include "oracle/calls/random.h"

#include <lgs/world.h>
#include <string>

namespace lgs::fuzz {

/// Does one of these, by number. Says what is wrong, if anything is. Afterwards the world is as before, as far as
/// anybody may see.
///  0. The world is asked everything.
///  1. Edits, strokes and commits between marks are undone and redone step by step, in any order (law 12).
///  2. Chunks of a copy leave memory, are edited around, and come back (law 14).
///  3. A world with the same polygons is committed at once, with jobs in another order.
///  4. Views follow a copy through edits, commits and roll-backs; bodies leave its ground and come back.
///  5. A stroke of a brush is made and undone (laws 8 to 11).
///  6. What must be refused is refused, in words, and changes nothing (law 7).
///  7. In a copy much comes and goes, a place is left, and all of it is saved, unloaded and brought back.
std::string beside(World& world, unsigned which, oracle::Random& random);
inline constexpr unsigned kBesides = 8;

std::string undoAndRedo(World& world, oracle::Random& random);
std::string unloadSome(const World& world, oracle::Random& random);
std::string commitByExecutor(const World& world);
std::string refuseAll(World& world);
std::string crowdAndLeave(const World& world, oracle::Random& random);
std::string followByViews(const World& world, oracle::Random& random);

/// Some edits about the polygons of a world, and now and then a stroke.
void editSome(World& world, oracle::Random& random);

}  // namespace lgs::fuzz
