// Random sequences of edits, degenerate on purpose, the same for the same seed everywhere.
//
// A *case* is one sequence, starting from an empty world or from a given trace. Each case draws its own habits: which
// shapes of the degenerate ones it uses, how often it removes, leans a new polygon on an edge that is there, or tries an edit
// that must be refused; how it groups edits into commits; where in the world it lies; which blocks and which preserve
// relation it has. Habits that are rare on average thus dominate some cases.
#pragma once

#include "oracle/trace/trace.h"

#include <cstdint>

namespace lgs::oracle {

struct GeneratorOptions {
  std::int32_t width = 4;  ///< cells; some cases are four times as wide and half as high
  std::int32_t height = 4;
  std::size_t edits = 100;  ///< adds and removes, refused ones included
};

/// A case of its own. The trace may hold edits that must be refused; see CheckOptions::skipRefused.
Trace randomCase(const GeneratorOptions& options, std::uint64_t seed);

/// A case about the limits of <lgs/world.h>: a cell is filled until it holds as many polygons, or vertices, as it may.
enum class Crowd : std::uint8_t { none, polygons, vertices };
Trace crowdedCase(Crowd of, std::size_t edits, std::uint64_t seed);
inline constexpr std::size_t kCrowdedEdits = 300;  ///< enough for any

/// Of many cases, those of some numbers are crowded ones.
Crowd crowdOf(std::uint64_t number);
Trace caseOf(std::uint64_t number, const GeneratorOptions& options, std::uint64_t seed);

/// How many edits the case of a number needs, where others have `edits`.
std::size_t editsOf(std::uint64_t number, std::size_t edits);

/// Digs in the world of a trace, and refills: wanders about, takes polygons away, puts them back, or puts others of the
/// same world or degenerate ones in their place. Returns the trace, committed, with `edits` more.
Trace digIn(Trace start, std::size_t edits, std::uint64_t seed);

}  // namespace lgs::oracle
