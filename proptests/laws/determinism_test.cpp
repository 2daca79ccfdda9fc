// Determinism: the same edits give the same ids everywhere, in lists of the same order. (The same whatever executor does the
// work: threads_test.cpp.)
#include "proptests/support/law.h"
#include "proptests/support/played.h"
#include "proptests/support/traces.h"
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace lgs::test {
namespace {

/// Everything that a world tells while it plays a trace.
std::pair<std::vector<ChangeLists>, Snapshot> toldBy(const oracle::Trace& trace) {
  oracle::Player player(trace.preserve);
  std::vector<ChangeLists> changes;
  playAll(trace, player, [&](oracle::Player&, const Changes& c) {
    changes.push_back(copyOf(c));
    return true;
  });
  return {changes, snapshotOf(player.world(), cellsOf(boundsOf(trace)))};
}

// The second world lies elsewhere in memory.
LGS_LAW(Determinism, TheSameEditsGiveTheSameIds, 500, (const GoodTrace& trace)) {
  failUnless(toldBy(trace) == toldBy(trace), "the second time ids or lists are others");
}

}  // namespace
}  // namespace lgs::test
