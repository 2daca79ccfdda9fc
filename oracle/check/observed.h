// All that can be seen of a world, and what differs between two.
#pragma once

#include "oracle/trace/player.h"

#include <lgs/world.h>
#include <string>
#include <vector>

namespace lgs::oracle {

/// The bytes of a world; none, if it can not be saved.
std::vector<std::byte> saved(const World& world);

/// What differs in what the laws fix: polygons by handle, segments by id with all their fields, counts, bytes. Nothing,
/// if all is equal.
std::string differenceOf(const World& a, const World& b);

/// Laws 7 and 12. A new world in which what was undone or refused is left out, but for the shapes that it made, must
/// answer and report what this one did, and look like it. What is wrong, if anything is.
std::string wrongPast(const Player& player);

}  // namespace lgs::oracle
