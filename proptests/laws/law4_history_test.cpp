// Law 4, no history: which segments there are, and their links, depends on the placed polygons alone: not on the order
// of edits, nor on what was removed, nor on how edits were grouped into commits.
#include "proptests/support/law.h"
#include "proptests/support/played.h"
#include "proptests/support/traces.h"

#include <gtest/gtest.h>

namespace lgs::test {
namespace {

using oracle::Call;
using oracle::Trace;

std::vector<Call> shuffled(const std::map<std::string, Call>& adds, Chance& chance) {
  std::vector<Call> out;
  out.reserve(adds.size());
  for (const auto& [name, add] : adds) out.push_back(add);
  chance.shuffle(out);
  return out;
}

/// The same polygons, added in another order; some come and go and come again.
Trace reordered(const Trace& trace, Chance& chance) {
  Trace other{trace.preserve, {}};
  for (const Call& add : shuffled(survivors(trace), chance)) {
    other.calls.push_back(add);
    if (chance.chance(20)) {
      if (chance.chance(50)) other.calls.push_back(Call::commit());
      other.calls.push_back(Call::remove(add.name()));
      if (chance.chance(50)) other.calls.push_back(Call::commit());
      other.calls.push_back(add);
    }
    if (chance.chance(30)) other.calls.push_back(Call::commit());
  }
  return other;
}

LGS_LAW(History, OrderOfEditsDoesNotMatter, 2'000, (const GoodTrace& trace, Chance chance)) {
  expectSame(outlineAfter(trace), outlineAfter(reordered(trace, chance)));
}

/// The same edits with commits elsewhere: often none at all.
Trace regrouped(const Trace& trace, Chance& chance) {
  Trace other{trace.preserve, {}};
  const int percent = chance.chance(50) ? 0 : chance.below(100);
  for (const Call& edit : trace.calls) {
    if (edit.kind != Call::Kind::commit) other.calls.push_back(edit);
    while (chance.chance(percent)) other.calls.push_back(Call::commit());
  }
  return other;
}

LGS_LAW(History, GroupingIntoCommitsDoesNotMatter, 2'000, (const GoodTrace& trace, Chance chance)) {
  expectSame(outlineAfter(trace), outlineAfter(regrouped(trace, chance)));
}

/// And then what stands there is removed in any order, and committed.
Trace undone(const Trace& trace, Chance& chance) {
  Trace undo = trace;
  for (const Call& add : shuffled(survivors(trace), chance)) {
    undo.calls.push_back(Call::remove(add.name()));
    if (chance.chance(40)) undo.calls.push_back(Call::commit());
  }
  undo.calls.push_back(Call::commit());
  return undo;
}

LGS_LAW(History, UndoingAllLeavesNothing, 2'000, (const GoodTrace& trace, Chance chance)) {
  oracle::Player player(trace.preserve);
  playAll(undone(trace, chance), player);
  const Stats stats = player.world().stats();
  failUnless(player.world().segments().empty() && player.world().loops().empty(), "segments are left");
  failUnless(stats.polygons + stats.cells + stats.segments == 0, "the statistics say that something is left");
}

LGS_LAW(History, WhatWasUndoneCanBeDoneAgain, 2'000, (const GoodTrace& trace, Chance chance)) {
  Trace again = undone(trace, chance);
  for (const auto& [name, add] : survivors(trace)) again.calls.push_back(add);
  expectSame(outlineAfter(trace), outlineAfter(again));
}

}  // namespace
}  // namespace lgs::test
