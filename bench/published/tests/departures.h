// The ways in which the published algorithm departs from the laws, and how to recognise each in the outcome of a trace.
// docs/internals/departures.md shows them.
#pragma once

#include "oracle/reference/outline.h"
#include "oracle/reference/scene.h"
#include "oracle/trace/trace.h"

#include <array>
#include <string_view>
#include <tl/expected.hpp>

namespace lgs::bench {

enum class Departure {
  uncutSingle,    ///< an edge that is alone on its boundary is not cut where a corner touches it in mid-edge
  uncutSwept,     ///< the same of an edge on a boundary that was swept
  uncutInCell,    ///< an edge inside the cell is not cut where another polygon's vertex lies on it
  keptInCell,     ///< an edge shared inside a cell is not cancelled
  preservedPair,  ///< two edges that cancel exactly are dropped though they are to be preserved
  preservedSide,  ///< the overlaps on one boundary are all kept, or all cancelled, as one of them should be
  otherBlock,     ///< the segments are right, but some have another polygon's block
  nearVertices,   ///< the segments are right, the ghosts are not: vertices nearer than ε count as one
  smallAngle,     ///< the segments are right, the ghosts are not: directions nearer than ε count as one
  removedOther,   ///< of two edges nearer than ε, each shorter, removing one polygon removes the other's
  staleGhosts,    ///< ghosts depend on what was there before
  coarseFloats,   ///< a vertex far from the origin becomes another lattice point when it is made a float
};
inline constexpr std::array kDepartures{Departure::uncutSingle,  Departure::uncutSwept,    Departure::uncutInCell,
                                        Departure::keptInCell,   Departure::preservedPair, Departure::preservedSide,
                                        Departure::otherBlock,   Departure::nearVertices,  Departure::smallAngle,
                                        Departure::removedOther, Departure::staleGhosts,   Departure::coarseFloats};

std::string_view nameOf(Departure departure);  ///< a name for files: "uncut-single"

/// The world at the end of a trace, computed in three ways.
struct PublishedRun {
  oracle::Scene scene;
  oracle::Outline expected;   ///< by the laws: the naive reference
  oracle::Outline published;  ///< by the published algorithm, edit by edit
  oracle::Outline afresh;     ///< by the published algorithm, from the scene alone
};

/// What the published algorithm puts out at the end of a trace. No edit may be bad.
oracle::Outline publishedOutline(const oracle::Trace& trace);

/// Runs a trace; an error if one of its edits is bad.
tl::expected<PublishedRun, oracle::TraceError> runPublished(const oracle::Trace& trace);

/// Whether the outcome departs in this way.
bool shows(const PublishedRun& run, Departure departure);

/// Whether a scene has only contacts that the published algorithm gets right. There is one block, and nothing is
/// preserved. Vertices are on eighths of a cell, within 128 cells of the origin. No edge is shared inside a cell. Where
/// a vertex lies in the middle of an edge, it is on a rim, and an edge along that rim ends in it as well, so that the
/// sweep cuts there.
bool isWithinItsReach(const oracle::Scene& scene);

}  // namespace lgs::bench
