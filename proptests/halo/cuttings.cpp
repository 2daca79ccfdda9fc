#include "proptests/halo/cuttings.h"

namespace lgs::test {
namespace {

using oracle::Random;
using regions::Cutting;

constexpr CellRect kPlane{{-kMaxCell, -kMaxCell}, {kMaxCell, kMaxCell}};

/// Cuts a piece before this column or row, if it is within the piece.
void cut(Cutting& pieces, std::size_t which, bool isColumn, std::int32_t at) {
  CellRect& piece = pieces[which];
  CellRect other = piece;
  const auto index = [isColumn](Cell& c) -> std::int32_t& { return isColumn ? c.i : c.j; };
  if (at <= index(piece.min) || at > index(piece.max)) return;
  index(piece.max) = at - 1;
  index(other.min) = at;
  pieces.push_back(other);
}

std::int32_t between(std::int32_t first, std::int32_t last, Random& random) {
  return static_cast<std::int32_t>(first + random.below(std::int64_t{last} - first + 1));
}

Cutting pinwheel(const CellRect& near, Random& random) {
  const auto [i, j] = near.min;
  const Cell a{between(i, near.max.i, random), between(j, near.max.j, random)};
  const Cell b{between(a.i, near.max.i, random), between(a.j, near.max.j, random)};
  const auto& [low, high] = kPlane;
  return {{a, b},
          {low, {a.i - 1, b.j}},
          {{low.i, b.j + 1}, {b.i, high.j}},
          {{b.i + 1, a.j}, high},
          {{a.i, low.j}, {high.i, a.j - 1}}};
}

}  // namespace

Cutting randomCutting(const CellRect& near, Random& random) {
  if (random.chance(20)) return pinwheel(near, random);
  Cutting pieces{kPlane};
  const auto cutAll = [&](bool isColumn, std::int32_t at) {
    for (std::size_t which = pieces.size(); which-- > 0;) cut(pieces, which, isColumn, at);
  };
  if (random.chance(20)) {
    constexpr std::int32_t kMost = 4;
    const Cell last{std::min(near.max.i, near.min.i + kMost), std::min(near.max.j, near.min.j + kMost)};
    for (std::int32_t i = near.min.i; i <= last.i + 1; ++i) cutAll(true, i);
    for (std::int32_t j = near.min.j; j <= last.j + 1; ++j) cutAll(false, j);
    return pieces;
  }
  for (int cuts = random.below(12); cuts > 0; --cuts) {
    const std::size_t which = random.below(pieces.size());
    if (random.chance(50))
      cut(pieces, which, true, between(near.min.i, near.max.i + 1, random));
    else
      cut(pieces, which, false, between(near.min.j, near.max.j + 1, random));
  }
  return pieces;
}

}  // namespace lgs::test
