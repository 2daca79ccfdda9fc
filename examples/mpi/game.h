// Ground and edits that every rank can work out by itself, so that nobody has to send a level: a square of ramps, each
// turned by chance, and rounds in which players dig random ones away, and put others there in the next round.
#pragma once

#include "../regions/message.h"

#include <lgs/world.h>

#include <cstdint>
#include <vector>

namespace mpi {

struct Game {
  std::int32_t side = 100;     ///< cells
  std::int64_t rounds = 10;    ///< each with a commit
  std::int64_t edits = 1'000;  ///< in a round, of all ranks together
  std::uint64_t seed = 1;

  lgs::CellRect cells() const { return {{0, 0}, {side - 1, side - 1}}; }
};

/// Places the ramps of some cells.
void load(lgs::World& world, const Game& game, const lgs::CellRect& cells);

/// What the players of a rank do in a round, anywhere in the square.
std::vector<regions::Edit> editsOf(const Game& game, std::int64_t round, int rank, int ranks);

}  // namespace mpi
