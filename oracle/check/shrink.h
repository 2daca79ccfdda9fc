// Makes a failing trace small: fewer edits, then simpler ones.
#pragma once

#include "oracle/trace/trace.h"

#include <chrono>
#include <functional>

namespace lgs::oracle {

/// Whether a candidate still fails in the way that is of interest. It is given traces that may be bad (a polygon made
/// simpler may overlap another), and must answer false for those.
using StillFails = std::function<bool(const Trace&)>;

/// Tries ever smaller traces as long as they fail, and returns the smallest found when no step helps or time is up:
///   edits dropped in chunks, then one by one (a polygon takes its removal with it); commits dropped;
///   polygons with fewer vertices, on rounder coordinates, or replaced by a full square or half of one;
///   blocks small, preserve pairs dropped, cells near the origin and near each other; names p1, p2, …
/// `trace` itself must fail. The same trace and predicate give the same result unless time runs out.
Trace shrink(Trace trace, const StillFails& stillFails, std::chrono::milliseconds budget);

}  // namespace lgs::oracle
