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
// A trace whose first line is `lgs-trace 3` may also say how an edit is made (way.h), at the end of a line:
//
//   add … by <door>      remove <name> by <door>      commit by <number>
//
// After `by` there may be a door, a number that says more of the call, a detour, and `too`: the call of the edit before
// makes this one too. Where a call can not make all that it is said to make, each of its edits is one by itself.
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

#include "oracle/reference/brush_edit.h"
#include "oracle/reference/scene.h"
#include "oracle/trace/way.h"

#include <lgs/error.h>
#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lgs::oracle {

struct Edit {
  enum class Kind { add, remove, commit, brush };
  Kind kind = Kind::commit;
  std::string name;      ///< of add and remove
  ScenePolygon polygon;  ///< of add
  std::size_t line = 0;  ///< where it was read; 0 if it was not read from text
  BrushEdit brush = {};  ///< of brush
  Way way = plainWay(kind);

  static Edit add(std::string name, ScenePolygon polygon) {
    return {Kind::add, std::move(name), std::move(polygon), 0};
  }
  static Edit remove(std::string name) { return {Kind::remove, std::move(name), {}, 0}; }
  static Edit commit() { return {}; }
  static Edit byBrush(BrushEdit brush) { return {Kind::brush, {}, {}, 0, std::move(brush)}; }
  static Way plainWay(Kind kind) {
    constexpr std::array kPlain{Door::points, Door::remove, Door::commit, Door::brush};
    return {kPlain[static_cast<std::size_t>(kind)]};
  }
  /// Where an edit was read is no part of what it is.
  friend bool operator==(const Edit& a, const Edit& b) {
    return a.kind == b.kind && a.name == b.name && a.polygon == b.polygon && a.brush == b.brush && a.way == b.way;
  }
};

struct Trace {
  PreservePairs preserve;
  std::vector<Edit> edits;
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

/// The line of one edit, without an end of line.
std::string printEdit(const Edit& edit);

/// Whether there is an edit by a brush.
inline bool hasBrushes(const Trace& trace) {
  return std::any_of(trace.edits.begin(), trace.edits.end(),
                     [](const Edit& edit) { return edit.kind == Edit::Kind::brush; });
}

/// How many edits there are that are no commits.
inline std::size_t editCount(const Trace& trace) {
  return static_cast<std::size_t>(std::count_if(trace.edits.begin(), trace.edits.end(),
                                                [](const Edit& edit) { return edit.kind != Edit::Kind::commit; }));
}

}  // namespace lgs::oracle
