// A step is one call of the engine: it makes one edit of a trace, or several.
//
// The engine has several *doors*: calls that mean the same edit. Games use all of them, so the harness does too. The
// name of an edit decides which door it takes: the letters after its last digit do. Without such letters the door is a
// plain one. So a trace means the same calls wherever it is played, and keeps them when it is made shorter and its
// polygons get other numbers.
#pragma once

#include "oracle/trace/trace.h"

#include <lgs/error.h>
#include <lgs/lattice.h>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace lgs::oracle {

enum class Door : std::uint8_t {
  points,    ///< add() by lattice points
  floats,    ///< add() by floats, which are exact
  doubles,   ///< add() by doubles, off the lattice by less than half a unit
  shape,     ///< shape(), then add() by its id
  handles,   ///< the same with a span for the handles
  several,   ///< polygons of one cell and one block as one shape
  fill,      ///< a rectangle of equal cells
  remove,    ///< remove()
  clear,     ///< clear() of a rectangle that holds nothing else
  replace,   ///< polygons of one cell and one block as one shape, in the place of all that stands there
  setBlock,  ///< a polygon goes and comes back at once, perhaps with another block
  brush      ///< paint() or carve(); what that does comes to light afterwards
};
inline constexpr std::size_t kDoors = 12;

/// In a word, that of its constant.
const char* describe(Door door);

/// What a name decides: a number that looks random and is the same everywhere. It is 0 without letters after the last
/// digit.
std::uint64_t chanceOf(std::string_view name);

/// Some bits of it.
inline unsigned bitsOf(std::uint64_t chance, unsigned first, unsigned count) {
  return static_cast<unsigned>(chance >> first) & ((1U << count) - 1);
}

/// These letters of a name.
std::string_view lettersOf(std::string_view name);

/// Letters for a name: three, of a random number.
std::string randomLetters(std::uint64_t number);

/// The door that an edit takes by itself.
Door doorOf(const Edit& edit);

/// What an edit, or a step, must be refused for; nothing if it must be accepted.
struct Verdict {
  bool accepted = true;
  std::optional<ErrorCode> code = {};  ///< none if the name is to blame
  Cell cell = Error::kNoCell;          ///< the one that the refusal must name
  int index = -1;                      ///< the entry to blame, of a call that takes many
};

struct Step {
  Door door{};
  std::span<const Edit> edits;  ///< removes, then adds, cell by cell; a commit or a brush stands alone
  CellRect cells;               ///< for fill and clear
  std::size_t inCell = 1;       ///< for several, fill and replace: how many polygons a cell gets
  std::uint64_t chance = 0;     ///< chanceOf() the first name
  unsigned worn = 0;            ///< so many polygons come and go in the first cell before the call
  std::size_t end = 0;          ///< where the step ends: the number of edits up to its last one
  Verdict verdict = {};
  bool isTrial = false;  ///< the call must be refused; then its edits come again, one by one

  bool isCommit() const { return edits.front().kind == Edit::Kind::commit; }
  std::span<const Edit> removes() const;
  std::span<const Edit> adds() const { return edits.subspan(removes().size()); }
};

}  // namespace lgs::oracle
