// Hashes of the ground, worked out anew from all polygons, by the words of <lgs/hashes.h>.
#pragma once

#include <lgs/hashes.h>
#include <lgs/world.h>

#include <cstdint>
#include <vector>

namespace lgs::oracle {

/// All squares of a level whose hash is not 0, in the order of GroundHashes::hashes().
std::vector<HashedSquare> groundHashes(const World& world, int level);

}  // namespace lgs::oracle
