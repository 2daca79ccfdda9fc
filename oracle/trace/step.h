// A step: the edits of a trace that one call of the engine makes. There are several doors into a world that mean the same
// edit, and a game uses all of them, so the harness does too.
//
// The name of an edit decides which door it takes: the letters after the last digit do, and without any the door is a plain
// one. So a trace means the same calls wherever it is played. It can be made shorter, and its polygons can be numbered
// anew, without changing the doors of what is left.
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
  points,   ///< add() by lattice points
  floats,   ///< add() by floats, which are exact
  doubles,  ///< add() by doubles, off the lattice by less than half a unit
  shape,    ///< shape(), then add() by its id
  handles,  ///< the same with a span for the handles
  several,  ///< polygons of one cell and one block as one shape
  fill,     ///< a rectangle of equal cells
  remove,   ///< remove()
  clear,    ///< clear() of a rectangle that holds nothing else
};
inline constexpr std::size_t kDoors = 9;

/// In a word, that of its constant.
const char* describe(Door door);

/// What a name decides: a number as good as random, the same everywhere. 0 without letters after the last digit.
std::uint64_t chanceOf(std::string_view name);

/// These letters of a name.
std::string_view lettersOf(std::string_view name);

/// Letters for a name: three, of a random number.
std::string randomLetters(std::uint64_t number);

/// The door that an edit takes by itself.
Door doorOf(const Edit& edit);

/// What an edit, or a step, must be refused for; nothing if it must be accepted.
struct Verdict {
  bool accepted = true;
  std::optional<ErrorCode> code = {};  ///< none where the name is to blame
  Cell cell = Error::kNoCell;          ///< the one that the refusal must name
};

struct Step {
  Door door{};
  std::span<const Edit> edits;  ///< of one kind; a commit stands alone. Of several and fill: cell by cell
  CellRect cells;               ///< of fill and clear
  std::size_t inCell = 1;       ///< of several and fill: how many polygons a cell gets
  std::uint64_t chance = 0;     ///< of the first name, for what else is open
  unsigned worn = 0;            ///< so many polygons come and go in the first cell beforehand
  std::size_t end = 0;          ///< how many edits of the trace there are up to the last one of the step
  Verdict verdict = {};
  bool isTrial = false;  ///< must be refused as a whole; its edits come again, one by one

  bool isCommit() const { return edits.front().kind == Edit::Kind::commit; }
};

}  // namespace lgs::oracle
