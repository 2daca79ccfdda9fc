// Plays a trace into an engine, and compares it with the references after every commit.
//
// Each call is held against the model (model.h): the engine accepts and refuses what the rules do, and gives what they
// say. What is looked at besides is up to the laws (law.h); laws/list.h has all of them.
#pragma once

#include "oracle/engine/engine.h"
#include "oracle/reference/outline.h"
#include "oracle/reference/scene.h"
#include "oracle/trace/model.h"
#include "oracle/trace/player.h"
#include "oracle/trace/trace.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace lgs::oracle {

struct Mismatch;
using LawSet = unsigned;  ///< bits, of levels.h

struct CheckOptions {
  Engine* engine = nullptr;  ///< whom to check; null: this library's engine, and all that it shows
  bool naive = true;
  bool cgal = true;
  bool skipRefused = false;  ///< go on after an edit that is rightly refused; if false, the trace is bad

  /// Compare the whole world after every commit whose number is a multiple of this, and at the end. After other
  /// commits, compare what lies within one cell of the edits (window.h). 0: the whole world at the end only. Change
  /// lists are always checked for the whole world.
  std::size_t wholeEvery = 1;

  /// Follow this library's engine with views of loops, islands and pieces, and hold these against a full recompute
  /// after every commit. It takes a time in proportion to the square of the polygons.
  bool views = false;

  /// Compare with CGAL after the last commit only: it costs more than all the rest together.
  bool unionAtEnd = false;

  /// Read everything after every commit, and ask so many questions each time; 0: after some, and ask a few.
  std::size_t questions = 0;

  /// Called after each commit that was found right, with what stands then; false stops the check there.
  std::function<bool(const Model&)> afterCommit = {};

  /// The only law to ask, by its place in the list; -1: none, as what calls give tells all. Null: all laws.
  std::optional<int> law = {};

  /// Laws that are a recommendation to another engine. What breaks no others is handed to `advise`, the first of each
  /// in a trace, and the check goes on. There the engine must be left as it is.
  LawSet recommended = 0;
  std::function<void(const Mismatch&)> advise = {};
};

struct Mismatch {
  enum class Kind {
    verdict,   ///< the engine accepts what is bad, refuses what is good, or says another reason
    refusal,   ///< a refused edit changed something
    changes,   ///< a change list is wrong
    needless,  ///< a change list reports what did not change
    reading,   ///< the world's queries contradict each other or the edits
    naive,     ///< another outline than the naive reference's
    cgal,      ///< another outline than CGAL's
    loops,     ///< equal outlines, other loops
    reach,     ///< a brush changed a polygon that law 9 keeps
    rounding,  ///< a brush is farther from its exact result than law 8 allows
    history,   ///< the outline depends on how it came about
    past,      ///< what was undone, saved or copied has left a trace (law 12)
    memory,    ///< what went has left something
    views,     ///< a view of loops, islands or pieces is not that of the world
    terrain,   ///< a physics engine's copy is not that of the world; the checker itself knows no such copy
    crash,     ///< the engine ended
    hang,      ///< the engine gave no answer in time
    protocol,  ///< the engine gave an answer that is none
  };
  Kind kind{};
  std::string text;        ///< what differs, and where; whole lines
  std::size_t edits = 0;   ///< how many edits of the trace had been played
  std::size_t commit = 0;  ///< after which commit, from 1
  Scene scene;             ///< as of then
  Outline expected;        ///< of the reference that disagrees; the engine's, if none does
  Outline actual;
  std::vector<Cell> edited;                ///< since the commit before
  Outline marked;                          ///< segments to point out, if neither outline shows what is wrong
  Capabilities can = Capabilities::all();  ///< of the engine: both outlines have no more than that
  int law = -1;                            ///< that found it, by its place in the list; -1: what a call gave

  bool isNoAnswer() const { return kind == Kind::crash || kind == Kind::hang || kind == Kind::protocol; }
};

/// A phrase for a report: "the outline differs from CGAL's".
std::string describe(Mismatch::Kind kind);

struct CheckStats {
  std::uint64_t edits = 0;
  std::uint64_t refused = 0;
  std::uint64_t commits = 0;
  std::uint64_t whole = 0;                         ///< comparisons of the whole world
  std::uint64_t naive = 0;                         ///< comparisons with the naive reference
  std::uint64_t cgal = 0;                          ///< comparisons with CGAL
  std::uint64_t brushed = 0;                       ///< edits by brushes that were measured against the exact result
  std::uint64_t segments = 0;                      ///< compared with a reference
  std::uint64_t read = 0;                          ///< how often everything was read
  std::uint64_t full = 0;                          ///< calls refused because of a limit
  std::uint64_t pasts = 0;                         ///< worlds that were made once more without what was undone
  std::array<std::uint64_t, Call::kKinds> made{};  ///< calls that were accepted, by kind
};

/// "add 20%, place 10%, …": the share of each kind among the calls that were accepted.
std::string callsInWords(const CheckStats& stats);

/// Checks a trace up to the first mismatch, if there is one; adds to `stats`. An error if an edit is rightly refused
/// and `skipRefused` is not set, and for no other reason.
tl::expected<std::optional<Mismatch>, TraceError> checkTrace(const Trace& trace, const CheckOptions& options,
                                                             CheckStats& stats);

}  // namespace lgs::oracle
