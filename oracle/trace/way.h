// How an edit is made. The engine has several *doors*: calls that mean the same edit. Games use all of them, so the
// harness does too. A line of a trace says which door its edit takes, and whether one call makes it together with the
// edit before. It may name a *detour*, too: what the player does beside, and nobody may notice.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace lgs::oracle {

enum class Door : std::uint8_t {
  points,      ///< add() by lattice points
  list,        ///< add() by an initializer list of them
  floats,      ///< add() by floats, which are exact
  doubles,     ///< add() by doubles, off the lattice by less than half a unit
  shape,       ///< shape(), then add() by its id
  handles,     ///< the same with a span for the handles
  several,     ///< polygons of one cell and one block as one shape
  many,        ///< addMany()
  fill,        ///< the same polygons in each cell of a rectangle
  remove,      ///< remove()
  removeMany,  ///< removeMany()
  clear,       ///< clear() of a rectangle that holds nothing else
  replace,     ///< polygons of one cell and one block as one shape, in the place of all that stands there
  exchange,    ///< exchange(): some polygons of a cell go, others come
  setBlock,    ///< a polygon goes and comes back at once, perhaps with another block
  brush,       ///< paint() or carve(); what that does comes to light afterwards
  commit       ///< no door: of a commit
};
inline constexpr std::size_t kDoors = 16;
inline constexpr std::array kDoorNames{"points",  "list",     "floats",   "doubles", "shape",      "handles",
                                       "several", "many",     "fill",     "remove",  "removeMany", "clear",
                                       "replace", "exchange", "setBlock", "brush"};
static_assert(kDoorNames.size() == kDoors);

constexpr const char* describe(Door door) {
  return door == Door::commit ? "commit" : kDoorNames[static_cast<std::size_t>(door)];
}

enum class Detour : std::uint8_t {
  none,
  saved,      ///< the world is saved before, and the one that is loaded takes its place
  undone,     ///< the world is edited wrongly before, and goes back
  marked,     ///< a mark is made before, to which the world never goes back
  grouped,    ///< the call is a group
  repainted,  ///< what comes has another block at first
  unloaded,   ///< chunks with uncommitted edits leave memory before, and come back
  worn        ///< hundreds of polygons come and go in the cell before
};
inline constexpr std::array kDetourNames{"plain",   "saved",     "undone",   "marked",
                                         "grouped", "repainted", "unloaded", "worn"};
inline constexpr std::size_t kDetours = kDetourNames.size();

struct Way {
  Door door{};
  Detour detour{};
  bool joins = false;        ///< the call of the edit before makes this one too; both have one door
  std::uint32_t number = 0;  ///< all else that a call can be told, in bits (row.cpp); 0: as plain as it can be
  friend bool operator==(const Way&, const Way&) = default;
};

/// What stands at the end of a line: " by fill 3 undone too". Nothing, if the way is the plain one.
std::string print(const Way& way, const Way& plain);

/// Takes one of its words, except for the number. Returns whether there is such a word.
bool readWay(std::string_view word, Way& way);

/// Some bits of a way's number.
constexpr unsigned bitsOf(std::uint32_t number, unsigned first, unsigned count) {
  return number >> first & ((1U << count) - 1);
}

}  // namespace lgs::oracle
