// Random cases and what becomes of one that fails: it is made small by the project's own shrinker, which knows what an
// edit is, and is saved as a trace for `lgs replay` and as a picture. Cases run in a child process (isolated.h): code that
// crashes or hangs fails them like any other.
#pragma once

#include "oracle/trace/trace.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace lgs::test {

/// Many cases by number, and what is wrong with a trace that was made of one of them. Both are called in a child process:
/// what they find out beyond that they must keep in Shared values.
struct Cases {
  std::string name;
  std::uint64_t count = 0;
  std::function<oracle::Trace(std::uint64_t)> trace;
  std::function<std::optional<std::string>(const oracle::Trace&, std::uint64_t)> complaint;
  std::function<bool(const oracle::Trace&)> mayBe = {};  ///< whether shrinking may come to this trace
};

struct Failure {
  oracle::Trace trace;  ///< the smallest one found
  std::string text;     ///< what is wrong, the trace, and the files that it and its picture were saved to
};

/// The first case that fails, if any does. One that fails only after those before it is saved as it is, and says so.
std::optional<Failure> firstFailure(const Cases& cases);

/// The command that runs the current test again, at the scale it has now. A seed that it has from outside goes before it.
std::string again(const std::string& program);

/// What the first expectation (EXPECT_…, ASSERT_…) says that fails in `work`, if one does: for complaints. The test that
/// is running does not fail by it.
std::optional<std::string> failedExpectation(const std::function<void()>& work);

}  // namespace lgs::test
