// Random edits that an edge set or a terrain must follow.
#pragma once

#include "oracle/generate/generator.h"
#include "oracle/trace/player.h"
#include "proptests/first_failure.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace lgs::box2d_test {

/// Plays a trace. Edits that are refused are left out. Calls `commit` at each commit of the trace and at its end; it is
/// to commit the player's world and to expect what must hold then. Returns the message of the first expectation that
/// fails.
inline std::optional<std::string> firstProblem(const oracle::Trace& trace, oracle::Player& player,
                                               const std::function<void()>& commit) {
  for (const oracle::Edit& edit : trace.edits) {
    if (edit.kind != oracle::Edit::Kind::commit) {
      static_cast<void>(player.apply(edit));  // some edits are made to be refused
    } else if (auto problem = test::failedExpectation(commit)) {
      return problem;
    }
  }
  return test::failedExpectation(commit);
}

/// Tries the random cases of seeds 1 to `cases`. The current test fails with the first one that there is a complaint
/// about.
inline void forSeeds(const std::string& name, std::uint64_t cases,
                     const std::function<std::optional<std::string>(const oracle::Trace&, std::uint64_t)>& complaint) {
  const auto failure = test::firstFailure(
      {.name = name,
       .count = cases,
       .trace = [](std::uint64_t k) { return oracle::randomCase({.width = 5, .height = 4, .edits = 60}, k + 1); },
       .complaint = [&](const oracle::Trace& trace, std::uint64_t k) -> std::optional<std::string> {
         const auto problem = complaint(trace, k + 1);
         return problem ? std::optional(fmt::format("seed {}, {}", k + 1, *problem)) : std::nullopt;
       }});
  if (failure) FAIL() << failure->text << "\nagain      " << test::again("lgs_box2d_tests");
}

}  // namespace lgs::box2d_test
