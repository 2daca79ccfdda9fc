#include "game.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace mpi {
namespace {

constexpr std::int32_t kUnit = lgs::kUnitsPerCell;
constexpr std::array<std::array<lgs::LocalPoint, 3>, 4> kRamps{{{{{0, 0}, {kUnit, 0}, {kUnit, kUnit}}},
                                                                {{{kUnit, 0}, {kUnit, kUnit}, {0, kUnit}}},
                                                                {{{kUnit, kUnit}, {0, kUnit}, {0, 0}}},
                                                                {{{0, kUnit}, {0, 0}, {kUnit, 0}}}}};

/// A number that looks random and is the same everywhere.
std::uint64_t mixed(std::uint64_t a, std::uint64_t b, std::uint64_t c) {
  std::uint64_t z = a * 0x9e37'79b9'7f4a'7c15U + b * 0xc2b2'ae3d'27d4'eb4fU + c * 0x1656'67b1'9e37'79f9U;
  z = (z ^ (z >> 30)) * 0xbf58'476d'1ce4'e5b9U;
  z = (z ^ (z >> 27)) * 0x94d0'49bb'1331'11ebU;
  return z ^ (z >> 31);
}

std::size_t rampOf(const Game& game, lgs::Cell cell, std::int64_t round) {
  const auto where = static_cast<std::uint64_t>(std::int64_t{cell.i} * game.side + cell.j);
  return mixed(game.seed, where, static_cast<std::uint64_t>(round)) % kRamps.size();
}

}  // namespace

void load(lgs::World& world, const Game& game, const lgs::CellRect& cells) {
  std::array<lgs::ShapeId, kRamps.size()> ramps;
  for (std::size_t k = 0; k < ramps.size(); ++k) ramps[k] = world.shape(kRamps[k]).value();
  const lgs::CellRect& all = game.cells();
  for (lgs::Cell c{0, std::max(cells.min.j, all.min.j)}; c.j <= std::min(cells.max.j, all.max.j); ++c.j)
    for (c.i = std::max(cells.min.i, all.min.i); c.i <= std::min(cells.max.i, all.max.i); ++c.i)
      if (!world.add(c, ramps[rampOf(game, c, -1)], 1)) std::abort();  // the square is empty
}

std::vector<regions::Edit> editsOf(const Game& game, std::int64_t round, int rank, int ranks) {
  std::vector<regions::Edit> edits;
  const bool digs = round % 2 == 0;
  for (std::int64_t k = rank; k < game.edits; k += ranks) {
    const std::uint64_t chance = mixed(game.seed, static_cast<std::uint64_t>(round - (digs ? 0 : 1)),
                                       static_cast<std::uint64_t>(k) + (std::uint64_t{1} << 40));
    const auto side = static_cast<std::uint64_t>(game.side);
    const lgs::Cell cell{static_cast<std::int32_t>(chance % side), static_cast<std::int32_t>((chance >> 32) % side)};
    regions::Edit& edit = edits.emplace_back();
    edit.cell = cell;
    if (digs) continue;
    const auto& ramp = kRamps[rampOf(game, cell, round)];
    edit = {regions::Edit::Kind::add, cell, 2, {ramp.begin(), ramp.end()}};
  }
  return edits;
}

}  // namespace mpi
