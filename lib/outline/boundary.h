// Phase 1 as a pure function: law 1 on the side that two cells share.
#pragma once

#include "ground/content.h"

#include <algorithm>
#include <cstdint>

namespace lgs::detail {

/// What stays exposed of `mine` against `theirs`, the facing side of the neighbour: a 1D sweep over both profiles.
/// `preserve(mySlot, theirSlot)` says whether an overlap is kept. `emit(begin, end, mySlot)` receives the intervals in
/// increasing order, cut at every vertex of either side. Cost: linear in the two profiles.
template <class Preserve, class Emit>
void exposedIntervals(const Side& mine, const Side& theirs, Preserve&& preserve, Emit&& emit) {
  auto cut = theirs.points.begin();
  auto facing = theirs.covered.begin();
  for (const Interval& interval : mine.covered) {
    for (std::int32_t at = interval.begin, next = at; at < interval.end; at = next) {
      while (cut != theirs.points.end() && cut->at <= at) ++cut;
      next = cut == theirs.points.end() ? interval.end : std::min(interval.end, cut->at);
      // Their intervals end at their vertices, so one of them covers all of [at, next], or none touches its inside.
      while (facing != theirs.covered.end() && facing->end <= at) ++facing;
      const bool overlapped = facing != theirs.covered.end() && facing->begin <= at;
      if (!overlapped || preserve(interval.slot, facing->slot)) emit(at, next, interval.slot);
    }
  }
}

}  // namespace lgs::detail
