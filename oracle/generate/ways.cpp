#include "oracle/generate/ways.h"

#include <algorithm>
#include <vector>

namespace lgs::oracle {
namespace {

constexpr std::size_t kLongest = 300;  // edits of one call: enough to fill a cell

template <class Goes>
std::size_t lengthOf(std::span<const Edit> edits, Goes goesOn) {
  return static_cast<std::size_t>(std::ranges::find_if_not(edits, goesOn) - edits.begin());
}

std::size_t removesAt(std::span<const Edit> edits) {
  return lengthOf(edits, [](const Edit& edit) { return edit.kind == Edit::Kind::remove; });
}

std::size_t addsAt(std::span<const Edit> edits, bool toOneCell) {
  return lengthOf(edits, [&](const Edit& edit) {
    if (edit.kind != Edit::Kind::add) return false;
    const ScenePolygon& first = edits.front().polygon;
    return !toOneCell || (edit.polygon.cell == first.cell && edit.polygon.block == first.block);
  });
}

// How many of the next edits one call is to make.
std::size_t lengthOfRow(std::span<const Edit> edits, Random& random) {
  if (!random.chance(75)) return 1;
  const std::size_t removes = removesAt(edits);
  const std::size_t adds = addsAt(edits.subspan(removes), removes > 0 || random.chance(50));
  const std::size_t length = removes == 0 ? adds : removes + (random.chance(60) ? adds : 0);
  return std::clamp<std::size_t>(random.chance(20) ? std::min<std::size_t>(length, 3) : length, 1, kLongest);
}

// The doors that may be able to make a row; the plain one first, where there is one.
std::vector<Door> doorsFor(std::size_t removes, std::size_t adds, bool isOneCell) {
  using enum Door;
  if (removes == 1 && adds == 1) return {setBlock, setBlock, setBlock, replace, exchange};
  if (removes > 0 && adds > 0) return {replace, exchange};
  if (removes > 1) return {clear, removeMany, exchange};
  if (removes == 1) return {remove, remove, remove, clear, removeMany, exchange};
  if (adds > 1 && isOneCell) return {several, several, replace, many, exchange, fill};
  if (adds > 1) return {fill, fill, many};
  return {points, points, list, floats, doubles, shape, handles, fill, replace, many, exchange};
}

Detour anyDetour(Random& random) {
  using enum Detour;
  if (!random.chance(45)) return none;
  const std::vector<Detour> all{grouped, marked, repainted, repainted, saved, saved, undone, unloaded, worn};
  return random.pick(all);
}

void choose(std::span<Edit> row, Random& random) {
  const std::size_t removes = removesAt(row), adds = row.size() - removes;
  const bool isOneCell = adds > 0 && addsAt(row.subspan(removes), true) == adds;
  Way way;
  way.door = random.pick(doorsFor(removes, adds, isOneCell));
  way.detour = anyDetour(random);
  const bool isPlain =
      way.detour != Detour::undone && way.detour != Detour::unloaded &&
      (way.door == Door::points || way.door == Door::list || way.door == Door::floats || way.door == Door::remove);
  if (!isPlain) way.number = random.below(1U << 8);
  for (Edit& edit : row) {
    edit.way = way;
    way = {way.door, Detour::none, true, 0};
  }
}

}  // namespace

void chooseWays(std::span<Edit> edits, Random& random) {
  while (!edits.empty()) {
    std::size_t length = 1;
    if (edits.front().kind == Edit::Kind::commit) {
      edits.front().way.number = random.below(4U);
    } else if (edits.front().kind != Edit::Kind::brush) {
      length = lengthOfRow(edits, random);
      choose(edits.first(length), random);
    }
    edits = edits.subspan(length);
  }
}

}  // namespace lgs::oracle
