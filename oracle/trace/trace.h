// Traces: edits as text. Hand-written, recorded, shrunk, imported and fuzzed edits are all this one format.
//
//   lgs-trace 1
//   # A word that starts with # begins a comment, which runs to the end of the line.
//   preserve <block> <block>                              only before the first edit
//   add <name> <i> <j> <block> <x> <y> <x> <y> <x> <y> …  i j: the cell; x y: in cells from its lower-left corner
//   remove <name>
//   commit
//
// A trace whose first line is `lgs-trace 2` may also hold edits by brushes (<lgs/brush.h>), in coordinates of the
// world:
//
//   paint <block> <fill|replace> <x> <y> <x> <y> … [| <x> <y> …]    x y: in cells; | begins the next ring
//   carve <x> <y> <x> <y> … [| <x> <y> …]
//
// A trace whose first line is `lgs-trace 4` may hold any call of the language (oracle/calls/call.h), a line each:
//
//   add <name|-> <i> <j> <block> <polygon> [in <notation>]     remove <which>        setBlock <which> <block>
//   place <i> <j> <block> <shape> [as <name> …]                clear <rectangle>     removeMany <which> …
//   replace <i> <j> <block> <shape> [as <name> …]              fill <rectangle> <block> <shape>
//   many <i> <j> <block> <shape> [; …]                         shape <shape>
//   exchange <i> <j> <which> … [with <block> <polygon> [; …]]  commit [<executor>]
//   group <keep|drop|all> … end                                repeat <times> … end
//   mark    back <mark> [keep]    forward <mark>    forget <mark>    copy    load    follow <0|1>
//   unload <rectangle>    reload <rectangle> [<order>]    reloadEmpty <rectangle>    leave <rectangle>
//   take <which> [<how>]    put <body> [by <i> <j>] [turned <symmetry>]    foresee … end
//
// A rectangle is i j of its first and i j of its last cell. A shape is one or several polygons, | between them; or
// `id <number>`, which need not be known. <which> polygon is one of a name, or `0:-1#2`, one of those that stand in a
// cell, `0:-1#all`, `given#5`, one of all that were ever placed, `beside#5`, a handle near that, or `handle#7:1`. Marks
// are counted from the oldest, those ahead from the last; all counts go on from the beginning. `take` takes the island
// of a polygon out of the world as a body (<lgs/islands.h>); how: 1 as several bodies, held by edges, 2 with what is
// unloaded as empty ground, 3 both. `put` sets a body into the ground, counted from the first that was taken: where it
// was, or some cells further, or turned or mirrored about its origin, 1 to 7. `foresee` commits, and says what edits
// would do to the islands. `in list`, `in floats 2`
// and `in doubles 2` say how a single polygon is given, and how far its reals are off the lattice; `room 1` to `3` at
// the end of a line that there is a span for handles, with one too few, just enough, or one too many places. `paint` and
// `carve` may end in `united` (the rings are simple and united) and `around <block> …`, which stay. What must be refused
// is a call like any other: it is an answer that is checked, and no fault of the trace. (Version 3 said by other words
// how edits are made. They are read over, and its edits are plain ones.)
//
// Inside is where the rings run around an odd number of times: so they may run either way around and cross, and a ring
// within a ring is a hole. A polygon that a brush changes in any way loses its name. What the brush puts there has
// names that no trace can use.
//
// Words are parted by spaces, tabs and commas; a line may end in CR LF. A name is any word, and is unique while its
// polygon is alive. A coordinate is a decimal (0.25, -1e-3) or a fraction of two integers (1/3), of up to a thousand
// characters, rounded to the nearest lattice point, halves away from zero. The end of the file commits what is pending.
//
// Parsing looks at the words alone. Whether a polygon is good, and whether a name is known, is decided when the trace
// is played (player.h), and reported with the edit's line.
#pragma once

#include "oracle/calls/call.h"

#include <lgs/error.h>
#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lgs::oracle {

struct Trace {
  PreservePairs preserve;
  std::vector<Call> calls;
  bool mayRefuse = false;  ///< what must be refused is no fault of the trace: format 4
  friend bool operator==(const Trace&, const Trace&) = default;
};

/// Why a trace is bad.
struct TraceError {
  std::size_t line = 0;               ///< 0: the file as a whole
  std::string text;                   ///< what is wrong, and what to do about it
  std::optional<Error> refusal = {};  ///< what the engine said, if it refused an edit
  bool isWrong = false;               ///< the engine is to blame, and not the trace
};

/// "FILE:LINE: text", or "FILE: text" where no line is to blame.
std::string message(const TraceError& error, std::string_view file);

struct ParsedTrace {
  Trace trace;  ///< everything before the first bad line
  std::optional<TraceError> error;
};

ParsedTrace parseTrace(std::string_view text);

/// The text that parseTrace() reads back as the same trace. Its version is the first one that has all that is in it.
std::string printTrace(const Trace& trace);

/// Whether there is a call by a brush.
inline bool hasBrushes(const Trace& trace) {
  return std::ranges::any_of(trace.calls, [](const Call& call) { return call.kind == Call::Kind::brush; });
}

/// Whether there are adds, removes and commits alone.
inline bool isPlain(const Trace& trace) {
  return std::ranges::all_of(trace.calls, [](const Call& call) { return isPlain(call); });
}

/// How many calls there are that are no commits.
inline std::size_t editCount(const Trace& trace) {
  return static_cast<std::size_t>(
      std::ranges::count_if(trace.calls, [](const Call& call) { return call.kind != Call::Kind::commit; }));
}

}  // namespace lgs::oracle
