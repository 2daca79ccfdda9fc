// Views of one world.
#pragma once

#include "oracle/calls/random.h"

#include <lgs/hashes.h>
#include <lgs/islands.h>
#include <lgs/pieces.h>

#include <string>

namespace lgs::fuzz {

struct Followed {
  Islands islands;
  Pieces pieces;
  GroundHashes hashes;
};

/// What is wrong with what they answer, if anything is. The world has no edits that are not committed.
std::string wrongViewReads(const World& world, const Followed& views, oracle::Random& random);

}  // namespace lgs::fuzz
