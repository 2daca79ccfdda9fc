// Random edits with something of Box2D's that must follow them.
#pragma once

#include "oracle/trace/player.h"
#include "proptests/first_failure.h"

#include <functional>
#include <optional>
#include <string>

namespace lgs::box2d_test {

/// Plays a trace; edits that are refused are left out. `commit` is called at each of its commits and at its end, to commit
/// the player's world and say with expectations what must hold then. What the first that fails says, if one does.
inline std::optional<std::string> firstProblem(const oracle::Trace& trace, oracle::Player& player,
                                               const std::function<void()>& commit) {
  for (const oracle::Edit& edit : trace.edits) {
    if (edit.kind != oracle::Edit::Kind::commit) {
      static_cast<void>(player.apply(edit));  // some are there to be refused
    } else if (auto problem = test::failedExpectation(commit)) {
      return problem;
    }
  }
  return test::failedExpectation(commit);
}

}  // namespace lgs::box2d_test
