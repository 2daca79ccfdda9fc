// The alphabet: a call of World's that changes something, as a value that says which call with which arguments.
//
// Whatever tries the engine at random draws its calls from here (draw.h) and makes them in one way (caller.h). A call
// means something in any world: it names polygons by their place in it, and brings its shapes along. So calls can be
// left out of a list, or be made in another world, and what is left can still be made. The headers of lib/ and the
// standard library are all that is needed, for programs that run on many platforms.
#pragma once

#include "oracle/calls/notation.h"
#include "oracle/reference/validity.h"

#include <lgs/ids.h>
#include <lgs/lattice.h>
#include <cstdint>
#include <string>
#include <vector>

namespace lgs::oracle {

using Shape = std::vector<LocalPolygon>;

/// Polygons that a call names; there need not be any.
struct Named {
  enum class How : std::uint8_t {
    standing,  ///< one of those that stand in a cell; the null handle, if none does
    all,       ///< all of these
    given,     ///< one of all that the caller was ever given
    beside,    ///< what comes some places after it: as a rule no handle of this world, or one that it gives out later
    handle     ///< that of this handle
  };
  How how{};
  Cell cell;
  std::uint32_t nth = 0;  ///< modulo how many there are
  PolygonHandle handle{};
};

/// What a call places.
struct Coming {
  Cell cell;
  Shape shape;
  Block block = 0;
  std::uint32_t id = 0;  ///< of the shape, where it goes by an id that need not be one; 0: `shape` is made first
};

struct Call {
  enum class Kind : std::uint8_t {
    shape,       ///< shape(); a single polygon in any notation
    add,         ///< add() by the vertices, in any notation
    addShape,    ///< shape(), then add() by its id
    addMany,     ///< shape() for each, then addMany()
    remove,      ///< remove()
    removeMany,  ///< removeMany()
    replace,     ///< shape(), then replace()
    exchange,    ///< exchange(); each that comes is one polygon, in the cell of the call
    setBlock,    ///< setBlock()
    fill,        ///< shape(), then fill()
    clear,       ///< clear(), of a cell or of a rectangle
    group,       ///< edits in a transaction
    commit,      ///< commit()
    mark,        ///< checkpoint()
    goBack,      ///< rollBack() to one of the marks
    forget,      ///< forget() one of the marks
    leave,       ///< forget() the chunks in a rectangle
    copy,        ///< the world is replaced by its copy
    load         ///< commit(), then the world is replaced by the one that it is saved as
  };
  static constexpr std::size_t kKinds = 19;

  Kind kind = Kind::commit;
  std::vector<Coming> comes;  ///< one, but for addMany() and exchange(); none where nothing is placed
  std::vector<Named> goes;    ///< of remove, removeMany, exchange and setBlock
  CellRect cells;             ///< of fill, clear and leave; its lower left one for exchange
  Notation notation{};        ///< of a single polygon
  unsigned offset = 0;        ///< how far off the lattice reals are; kSpoiltOffset and more: one of them is no place
  unsigned room = 0;          ///< for handles: 0: none is asked for; 1, 2, 3: one too few, just enough, one too many
  enum class Keeps : std::uint8_t { never, always, ifAll };
  std::vector<Call> group;  ///< its parts
  Keeps keeps{};            ///< the group; ifAll: unless a part is refused, and then that is the last one
  std::uint32_t nth = 0;    ///< of the marks, modulo how many there are
};

/// Whether what comes is shapes, which are made first.
constexpr bool isByShape(Call::Kind kind) {
  using enum Call::Kind;
  return kind == addShape || kind == addMany || kind == replace || kind == fill;
}

/// A line, in words; a group has one for each of its calls.
std::string inWords(const Call& call);

/// Calls that are a little simpler than this one, the simplest first.
std::vector<Call> simpler(const Call& call);

/// What a call comes to if it is made in parts, all or none of them: a group of single removes and adds. Its handles
/// must be known (Caller::resolved()).
Call inParts(const Call& call);

}  // namespace lgs::oracle
