// Random edits that an edge set or a terrain must follow.
#pragma once

#include "oracle/generate/generator.h"
#include "oracle/trace/player.h"
#include "proptests/support/law.h"
#include "proptests/support/traces.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <utility>

namespace lgs::box2d_test {

using oracle::Trace;
using test::Chance;

/// Random edits. Some are there to be refused.
struct Edits : Trace {
  static rc::Gen<Edits> arbitrary() {
    const auto edits = [](int, oracle::Random random) {
      return oracle::randomCase({.width = 5, .height = 4, .edits = 60}, random.next());
    };
    return rc::gen::map(test::traces(edits, {}), [](Trace&& trace) { return Edits{std::move(trace)}; });
  }
};

/// Fails the running test with the first case that a law, of edits and a source of chance, does not hold for.
template <class Law>
void forAllEdits(std::int64_t cases, Law law) {
  test::forAll(cases, [law](const Edits& edits, Chance chance) { law(edits, chance); });
}

/// Where a trace places its first polygon. That may be at the rim of the world, and Box2D 3 in float asserts that
/// nothing is 100 km from its origin.
inline Cell firstCell(const Trace& trace) {
  const Trace good = withoutRefused(trace);
  const auto first = std::ranges::find(good.calls, oracle::Call::Kind::add, &oracle::Call::kind);
  return first == good.calls.end() ? Cell{} : first->comes[0].cell;
}

/// Plays a trace, of which some edits may have to be refused. `commit` is called at each of its commits and at its end,
/// to commit the player's world and say with expectations what must hold then. The first that fails ends the case.
inline void playAll(const Trace& trace, oracle::Player& player, const std::function<void()>& commit) {
  for (const oracle::Call& call : trace.calls) {
    if (call.kind == oracle::Call::Kind::commit) {
      test::failIf(test::failedExpectation(commit));
      continue;
    }
    const auto done = player.apply(call);
    test::failUnless(done || !done.error().isWrong, done ? "" : done.error().text.c_str());
  }
  test::failIf(test::failedExpectation(commit));
}

}  // namespace lgs::box2d_test
