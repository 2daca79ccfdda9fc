// Random sequences of edits. They are degenerate on purpose, and the same seed gives the same ones everywhere.
//
// A *case* is one sequence. It starts from an empty world or from a given trace. Each case draws its own habits:
//  - which of the degenerate shapes it uses, which blocks, and which preserve relation;
//  - how often it removes, leans a new polygon on an edge that is there, or tries an edit that must be refused;
//  - how many edits it makes before it commits;
//  - where in the world it lies.
// So there are cases that mostly do what is rare on average.
#pragma once

#include "oracle/engine/capabilities.h"
#include "oracle/trace/trace.h"

#include <cstdint>
#include <span>
#include <string>

namespace lgs::oracle {

struct GeneratorOptions {
  std::int32_t width = 4;  ///< cells; some cases are four times as wide and half as high
  std::int32_t height = 4;
  std::size_t edits = 100;                 ///< adds and removes, refused ones included
  Capabilities can = Capabilities::all();  ///< what the worlds must be fit for
  bool crowds = true;      ///< the limits of a cell are this library's: other engines need not know them
  bool isOfCalls = false;  ///< all calls of this library's; else adds, removes and commits alone, by name
  bool brushes = false;    ///< among the other calls
  bool inMemory = false;   ///< chunks stay there
  bool streams = false;    ///< they mostly come and go, and little else is done
  bool bad = false;        ///< most of the edits must be refused
};

/// A case of its own. The trace may hold edits that must be refused; see CheckOptions::skipRefused.
Trace randomCase(const GeneratorOptions& options, std::uint64_t seed);

/// A case of a fuzzer's bytes: any bytes are one. The first record of 16 is the seed of its habits; each one after that
/// chooses an operation, of which a choice takes a byte. So a byte that changes changes one operation, but that what
/// comes later meets another world.
Trace caseOf(std::span<const std::uint8_t> bytes, const GeneratorOptions& options);
inline constexpr std::size_t kRecord = 16;

/// A case about the limits of <lgs/world.h>: it fills a cell until no polygon, or no vertex, may be added; or until a
/// stroke that cuts some would leave too many.
enum class Crowd : std::uint8_t { none, polygons, vertices, strokes };
Trace crowdedCase(Crowd of, std::size_t edits, std::uint64_t seed);
inline constexpr std::size_t kCrowdedEdits = 300;  ///< enough for any

/// In a row of cases, some are crowded: those with certain numbers.
Crowd crowdOf(std::uint64_t number, const GeneratorOptions& options);
Trace caseOf(std::uint64_t number, const GeneratorOptions& options, std::uint64_t seed);

/// How many edits the case with this number has: as many as asked for, unless it is crowded.
std::size_t editsOf(std::uint64_t number, const GeneratorOptions& options);

/// Digs in the world of a trace, and refills it: wanders about, takes polygons away, and puts back the same ones,
/// others of that world, or degenerate ones. Returns the trace with a commit and `edits` more edits.
Trace digIn(Trace start, std::size_t edits, std::uint64_t seed, const Capabilities& can = Capabilities::all(),
            bool isOfCalls = false);

/// Why an engine can not play a trace, as a phrase that names the edit; empty if it can.
std::string whyNot(const Trace& trace, const Capabilities& can);

}  // namespace lgs::oracle
