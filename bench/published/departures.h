// Where the published algorithm departs from the laws: each way, as something that can be recognised in the outcome of
// a trace. See docs/departures.md.
#pragma once

#include "oracle/reference/outline.h"
#include "oracle/reference/scene.h"
#include "oracle/trace/trace.h"

#include <array>
#include <string>
#include <tl/expected.hpp>

namespace lgs::oracle {

enum class Departure {
  uncutSingle,    ///< a rim edge, alone on its boundary, is not cut where a corner touches it in mid-edge
  uncutSwept,     ///< the same on a boundary that was swept
  uncutInCell,    ///< an edge inside the cell is not cut where another polygon's vertex lies on it
  keptInCell,     ///< an edge shared inside a cell is not cancelled
  preservedPair,  ///< two edges that cancel exactly are dropped though they are to be preserved
  preservedSide,  ///< an overlap is kept because another one on the same boundary is, or not kept because that is not
  otherBlock,     ///< right segments, and some have another polygon's block
  nearVertices,   ///< right segments, wrong ghosts: vertices nearer than ε count as one
  smallAngle,     ///< right segments, wrong ghosts: directions nearer than ε count as one
  removedOther,   ///< of two opposite edges shorter than ε, removing a polygon takes the other's away
  staleGhosts,    ///< ghosts depend on what was there before
  coarseFloats,   ///< a vertex far from the origin is another lattice point once it is a float
};
inline constexpr std::array kDepartures{Departure::uncutSingle,  Departure::uncutSwept,    Departure::uncutInCell,
                                        Departure::keptInCell,   Departure::preservedPair, Departure::preservedSide,
                                        Departure::otherBlock,   Departure::nearVertices,  Departure::smallAngle,
                                        Departure::removedOther, Departure::staleGhosts,   Departure::coarseFloats};

/// A name for a file, "uncut-single"; and a sentence without its full stop.
std::string nameOf(Departure departure);
std::string describe(Departure departure);

/// The end of a trace, three times.
struct PublishedRun {
  Scene scene;
  Outline expected;   ///< by the laws: the naive reference
  Outline published;  ///< by the published algorithm, edit by edit
  Outline afresh;     ///< by the same, from the scene alone
};

/// Runs a trace; an error if one of its edits is bad.
tl::expected<PublishedRun, TraceError> runPublished(const Trace& trace);

bool shows(const PublishedRun& run, Departure departure);

/// Whether a scene keeps to what the published algorithm gets right, as far as contacts go: one block, nothing
/// preserved, within 128 cells of the origin, vertices on eighths of a cell; no edge shared inside a cell; and a vertex
/// in the middle of an edge only on a rim, where an edge along that rim ends in it as well, so that the sweep cuts
/// there.
bool isWithinItsReach(const Scene& scene);

}  // namespace lgs::oracle
