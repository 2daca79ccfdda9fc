// The language: a call that changes a World, or moves it in time or memory, as a value: its own, of brushes, of views.
//
// Whatever tries the engine makes calls of this one kind, in one way (caller.h): those of a trace, which is their text
// (oracle/trace/trace.h), those that are drawn at random (draw.h), a fuzzer's. A call means something in any world: it
// names polygons, marks and chunks so that there need not be any, and brings its shapes along. So calls can be left out
// of a list, or be made in another world, and what is left can still be made. What must be refused is a call like any
// other. The headers of lib/ and the standard library are all that is needed, for programs that run on many platforms.
#pragma once

#include "oracle/calls/notation.h"
#include "oracle/reference/brush_edit.h"
#include "oracle/reference/scene.h"
#include "oracle/reference/validity.h"

#include <lgs/ids.h>
#include <lgs/lattice.h>
#include <array>
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
    handle,    ///< that of this handle
    name       ///< that of this name, which another call gave it
  };
  How how{};
  Cell cell{};
  std::uint32_t nth = 0;  ///< modulo how many there are
  PolygonHandle handle{};
  std::string name = {};
  friend bool operator==(const Named&, const Named&) = default;
};

/// What a call places.
struct Coming {
  Cell cell{};
  Shape shape = {};
  Block block = 0;
  std::uint32_t id = 0;  ///< of the shape, where it goes by an id that need not be one; 0: `shape` is made first
  std::vector<std::string> names = {};  ///< of the polygons; none: no call can name them so
  friend bool operator==(const Coming&, const Coming&) = default;
};

/// How a body comes back.
struct Lies {
  Cell by{};                   ///< how far from where it was
  std::uint32_t symmetry = 0;  ///< of the cell (shapes.h), about its origin
  friend bool operator==(const Lies&, const Lies&) = default;
};

struct Call {
  enum class Kind : std::uint8_t {
    shape,        ///< shape(); a single polygon in any notation
    add,          ///< add() by the vertices, in any notation
    addShape,     ///< shape(), then add() by its id
    addMany,      ///< shape() for each, then addMany()
    remove,       ///< remove()
    removeMany,   ///< removeMany()
    replace,      ///< shape(), then replace()
    exchange,     ///< exchange(); each that comes is one polygon, in the cell of the call
    setBlock,     ///< setBlock()
    fill,         ///< shape(), then fill()
    clear,        ///< clear(), of a cell or of a rectangle
    group,        ///< edits in a transaction
    commit,       ///< commit(), with an executor or without
    mark,         ///< mark()
    rollBack,     ///< rollBack() to one of the marks
    forget,       ///< forget() one of the marks
    leave,        ///< forgetChunks() in a rectangle
    copy,         ///< the world is replaced by its copy
    load,         ///< commit(), then the world is replaced by the one that it is saved as
    redo,         ///< redo() to one of the marks that are ahead
    unload,       ///< unload() the chunks in a rectangle
    reload,       ///< reload() what was unloaded in a rectangle
    reloadEmpty,  ///< reloadEmpty()
    brush,        ///< paint() or carve()
    repeat,       ///< calls that are made some hundred times
    follow,       ///< followCells(), or no longer
    take,         ///< take() or takeApart() of the island that a polygon is of, by a view that begins now
    put,          ///< put() of a body that was taken; of an empty one if there is none
    foresee       ///< commit(), then foresee() of edits, by a view that begins now
  };
  static constexpr std::size_t kKinds = 29;

  Kind kind = Kind::commit;
  std::vector<Coming> comes = {};  ///< one, but for addMany() and exchange(); none where nothing is placed
  std::vector<Named> goes = {};    ///< of remove, removeMany, exchange, setBlock and take
  CellRect cells = {};             ///< of all that take a rectangle; its lower left one for exchange
  Notation notation{};             ///< of a single polygon
  unsigned offset = 0;             ///< how far off the lattice reals are; kSpoiltOffset and more: one is no place
  unsigned room = 0;  ///< for handles: 0: none is asked for; 1, 2, 3: one too few, just enough, one too many
  enum class Keeps : std::uint8_t { never, always, ifAll };
  std::vector<Call> group = {};  ///< the parts of a group, of what is repeated, and of what is foreseen
  Keeps keeps{};                 ///< the group; ifAll: unless a part is refused, and then that is the last one.
                                 ///< Of rollBack: whether what is undone is kept
  std::uint32_t nth = 0;         ///< of the marks, modulo how many there are; of an executor; in which order chunks
                                 ///< come back; how often something is repeated; whether to follow, if it is odd;
                                 ///< of the bodies; how an island is taken (kApart, kOpen)
  Lies lies = {};                ///< of put
  BrushEdit brush = {};
  std::size_t line = 0;  ///< where it was read; 0 if it was not read from text

  /// Of take: in as many bodies as edges hold; and what is unloaded counts as empty.
  static constexpr std::uint32_t kApart = 1, kOpen = 2;

  static Call of(Kind kind) {
    Call call;
    call.kind = kind;
    return call;
  }
  static Call commit() { return {}; }
  static Call add(std::string name, ScenePolygon polygon) {
    Call call = of(Kind::add);
    call.comes = {{polygon.cell, {std::move(polygon.vertices)}, polygon.block, 0, {std::move(name)}}};
    return call;
  }
  static Call remove(std::string name) {
    Call call = of(Kind::remove);
    call.goes = {{.how = Named::How::name, .name = std::move(name)}};
    return call;
  }
  static Call byBrush(BrushEdit brush) {
    Call call = of(Kind::brush);
    call.brush = std::move(brush);
    return call;
  }

  /// The name that add() gives, or that remove() goes by; nothing, if there is none.
  const std::string& name() const {
    static const std::string kNone;
    if (!goes.empty()) return goes[0].name;
    return comes.empty() || comes[0].names.empty() ? kNone : comes[0].names[0];
  }
  /// Of add; without vertices, if nothing comes.
  ScenePolygon polygon() const {
    if (comes.empty()) return {};
    return {comes[0].cell, comes[0].block, comes[0].shape.empty() ? LocalPolygon() : comes[0].shape[0]};
  }

  /// Where a call was read is no part of what it is.
  friend bool operator==(const Call& a, const Call& b);
};

/// What is said of all calls of a kind.
struct KindOfCall {
  enum Has : unsigned {
    edit = 1,       ///< it may stand in a group
    time = 2,       ///< a roll-back or redo, or stands for others: it is no edit
    one = 4,        ///< one thing comes
    many = 8,       ///< any number of them
    shapes = 16,    ///< what comes is shapes, which are made first
    cell = 32,      ///< what comes has a cell
    notation = 64,  ///< a single polygon that comes may be in any notation
    room = 128,     ///< for handles
    rect = 256,     ///< Call::cells is a rectangle
    number = 512,   ///< Call::nth
    parts = 1024    ///< Call::group
  };
  const char* word;  ///< its line begins with it; that of a brush may be `carve`
  unsigned has;
};

/// In their order.
inline constexpr auto kKindsOfCalls = [] {
  using enum KindOfCall::Has;
  constexpr unsigned shape = edit | one | shapes | notation;
  return std::array<KindOfCall, Call::kKinds>{{{"shape", edit | one | notation},
                                               {"add", edit | one | cell | notation},
                                               {"place", shape | cell | room},
                                               {"many", edit | many | shapes | cell | notation | room},
                                               {"remove", edit},
                                               {"removeMany", edit},
                                               {"replace", shape | cell | room},
                                               {"exchange", edit | many | room},
                                               {"setBlock", edit | one},
                                               {"fill", shape | rect},
                                               {"clear", edit | rect},
                                               {"group", time | parts},
                                               {"commit", time | number},
                                               {"mark", time},
                                               {"back", time | number},
                                               {"forget", time | number},
                                               {"leave", rect},
                                               {"copy", time},
                                               {"load", time},
                                               {"forward", time | number},
                                               {"unload", rect},
                                               {"reload", rect | number},
                                               {"reloadEmpty", rect},
                                               {"paint", edit},
                                               {"repeat", time | number | parts},
                                               {"follow", time | number},
                                               {"take", edit | number},
                                               {"put", edit | number},
                                               {"foresee", time | parts}}};
}();

constexpr bool has(Call::Kind kind, KindOfCall::Has what) {
  return (kKindsOfCalls[static_cast<std::size_t>(kind)].has & what) != 0;
}
constexpr bool isByShape(Call::Kind kind) { return has(kind, KindOfCall::shapes); }
constexpr bool isEdit(Call::Kind kind) { return has(kind, KindOfCall::edit); }
constexpr bool movesInTime(Call::Kind kind) { return has(kind, KindOfCall::time); }

/// Calls of chunks that come and go: a chunk of a place where none is counts as an edit.
constexpr bool isOfMemory(Call::Kind kind) { return Call::Kind::unload <= kind && kind <= Call::Kind::reloadEmpty; }

/// Calls before which all is committed.
constexpr bool commitsFirst(Call::Kind kind) { return kind == Call::Kind::load || kind == Call::Kind::foresee; }

/// Add, remove and commit in their plain form: all that an engine of others knows.
bool isPlain(const Call& call);

/// The same call without what it does not use: so that it is the one that its text says.
Call tidied(Call call);

/// The same call so many cells further, as far as there are numbers.
Call movedBy(Call call, Cell cells);

/// Calls that are a little simpler than this one, the simplest first.
std::vector<Call> simpler(const Call& call);

}  // namespace lgs::oracle
