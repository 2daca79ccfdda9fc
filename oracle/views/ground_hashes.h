// Hashes of the ground, worked out anew from all polygons, by the words of <lgs/hashes.h>.
#pragma once

#include <lgs/hashes.h>
#include <lgs/world.h>

#include <optional>
#include <string>
#include <vector>

namespace lgs::oracle {

/// All squares of a level whose hash is not 0, in the order of GroundHashes::hashes().
std::vector<HashedSquare> groundHashes(const World& world, int level);

/// What is wrong with the hashes of chunks, and of the world.
std::optional<std::string> faultOf(const GroundHashes& hashes, const World& world);

/// The same when all chunks lose their ground and get it again, some times over.
std::optional<std::string> faultOfRounds(GroundHashes hashes);

}  // namespace lgs::oracle
