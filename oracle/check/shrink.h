// Makes a failing trace small: fewer calls, then simpler ones.
#pragma once

#include "oracle/trace/trace.h"

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace lgs::oracle {

/// A walk from a trace to ever smaller ones, for whoever decides at each step whether it still fails. In this order:
///   all that stands at the end, built at once;
///   calls dropped in chunks, then one by one (a polygon takes its removal by name with it);
///   calls simpler: with fewer parts, or one of the parts of a group in its place; in plain notation;
///   polygons with fewer vertices, on rounder coordinates, or replaced by a full square or half of one;
///   brushes with fewer rings, fewer vertices, on rounder coordinates;
///   blocks small, preserve pairs dropped, cells near the origin and near each other;
///   names p1, p2, …; nothing that must be refused
/// and again from the start while that helps. A candidate may be bad (a polygon made simpler may overlap another).
/// A walk is a value: a copy goes its own way.
class ShrinkWalk {
 public:
  explicit ShrinkWalk(Trace trace) : best_(std::move(trace)) {}

  /// The smallest trace so far.
  const Trace& best() const { return best_; }

  /// The next candidate, never best() itself; nothing at the end of the walk. Without accept() it counts as rejected.
  std::optional<Trace> next();

  /// The last candidate still fails: the walk goes on from there.
  void accept(Trace candidate);

 private:
  // The next candidate of a pass; nothing at its end.
  using Pass = std::optional<Trace> (ShrinkWalk::*)();
  static const std::vector<Pass>& passes();
  std::optional<Trace> buildAtOnce();
  std::optional<Trace> rename();
  std::optional<Trace> dropCalls();
  std::optional<Trace> simplifyCalls();
  std::optional<Trace> refuseNothing();
  std::optional<Trace> simplifyPolygons();
  std::optional<Trace> simplifyBrushes();
  std::optional<Trace> dropPairs();
  std::optional<Trace> renumberBlocks();
  std::optional<Trace> oneBlock();
  std::optional<Trace> moveColumns() { return moveCells(&Cell::i); }
  std::optional<Trace> moveRows() { return moveCells(&Cell::j); }
  std::optional<Trace> moveCells(std::int32_t Cell::*axis);

  Trace best_;
  std::size_t pass_ = 0;
  std::size_t at_ = 0;       // where the pass is: a call, a pair, a line of cells; while dropping, the calls behind it
  std::size_t variant_ = 0;  // which candidate it tries there next
  std::size_t length_ = 0;   // of the chunk of calls to drop
  bool isSmaller_ = false;   // than at the start of this round
};

/// The same with names p1, p2, … in order of the adds; no two polygons share one.
Trace renamed(Trace trace);

/// Without commits but the last, and without what is added and removed again, both by name. Names become plain.
Trace builtAtOnce(Trace trace);

/// Whether a candidate still fails in the way that is of interest. It must answer false for a bad trace.
using StillFails = std::function<bool(const Trace&)>;

/// Walks until no step helps or time is up. `trace` itself must fail. The same trace and predicate give the same result
/// unless time runs out.
Trace shrink(Trace trace, const StillFails& stillFails, std::chrono::milliseconds budget);

}  // namespace lgs::oracle
