// Law 4, history does not matter: the output is a function of the polygons that stand there.
#include "oracle/trace/dump.h"
#include "oracle/trace/player.h"
#include "random_traces.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace lgs::engine_test {
namespace {

using oracle::Edit;
using oracle::Outline;
using oracle::outlineOf;
using oracle::Player;
using oracle::Random;
using oracle::Trace;

RC_GTEST_PROP(History, OrderOfEditsDoesNotMatter, ()) {
  forRandomTraces("order", 20, {}, [](const Trace& trace, Random random) {
    std::vector<Edit> adds;
    for (auto& [name, edit] : survivors(trace)) adds.push_back(edit);
    random.shuffle(adds);
    Trace shuffled{trace.preserve, {}};
    for (const Edit& add : adds) {
      shuffled.edits.push_back(add);
      if (random.chance(20)) {  // comes and goes and comes again
        if (random.chance(50)) shuffled.edits.push_back(Edit::commit());
        shuffled.edits.push_back(Edit::remove(add.name));
        if (random.chance(50)) shuffled.edits.push_back(Edit::commit());
        shuffled.edits.push_back(add);
      }
      if (random.chance(30)) shuffled.edits.push_back(Edit::commit());
    }
    return differenceOf(outlineAfter(trace), outlineAfter(shuffled));
  });
}

RC_GTEST_PROP(History, GroupingIntoCommitsDoesNotMatter, ()) {
  forRandomTraces("grouping", 20, {}, [](const Trace& trace, Random random) {
    Trace grouped{trace.preserve, {}};
    const int percent = random.chance(50) ? 0 : random.below(100);
    for (const Edit& edit : trace.edits) {
      if (edit.kind != Edit::Kind::commit) grouped.edits.push_back(edit);
      while (random.chance(percent)) grouped.edits.push_back(Edit::commit());
    }
    return differenceOf(outlineAfter(trace), outlineAfter(grouped));
  });
}

RC_GTEST_PROP(History, UndoingAllLeavesNothing, ()) {
  forRandomTraces("undo", 20, {}, [](const Trace& trace, Random random) -> std::optional<std::string> {
    Player player(trace.preserve);
    if (!oracle::play(trace, player)) return "refused";
    player.commit();
    const Outline before = outlineOf(player.world());
    const auto standing = survivors(trace);
    std::vector<Edit> undo;
    for (const auto& [name, edit] : standing) undo.push_back(Edit::remove(name));
    random.shuffle(undo);
    for (const Edit& edit : undo) {
      if (!player.apply(edit)) return "could not be removed: " + edit.name;
      if (random.chance(40)) player.commit();
    }
    player.commit();
    const Stats stats = player.world().stats();
    if (!player.world().segments().empty() || !player.world().loops().empty()) return "segments are left";
    if (stats.polygons + stats.cells + stats.segments != 0) return "the statistics say that something is left";
    for (const auto& [name, edit] : standing)
      if (!player.apply(edit)) return "could not be added again: " + name;
    player.commit();
    return differenceOf(before, outlineOf(player.world()));
  });
}

}  // namespace
}  // namespace lgs::engine_test
