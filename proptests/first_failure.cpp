#include "proptests/first_failure.h"

#include "oracle/check/failure.h"
#include "oracle/check/isolated.h"
#include "oracle/check/shrink.h"
#include "oracle/trace/file.h"

#include <fmt/format.h>
#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <utility>

namespace lgs::test {

using oracle::Trace;

namespace {

/// What a complaint says, in memory that the child shares with its parent.
struct Verdict {
  std::uint64_t number = 0;  // of the case
  bool failed = false;
  std::array<char, 8'000> text{};

  void fail(const std::string& why) {
    failed = true;
    text[why.copy(text.data(), text.size() - 1)] = '\0';
  }
};

/// An expectation that fails in the child process would be lost with it: it is a complaint like any other.
std::optional<std::string> complaintHere(const Cases& cases, const Trace& trace, std::uint64_t number) {
  std::optional<std::string> why;
  const auto failed = failedExpectation([&] { why = cases.complaint(trace, number); });
  return why ? why : failed;
}

std::optional<std::string> complaintOf(const Cases& cases, const Trace& trace, std::uint64_t number, bool quiet) {
  const oracle::Shared<Verdict> verdict;
  const auto crash = oracle::crashOf(
      [&] {
        if (const auto why = complaintHere(cases, trace, number)) verdict->fail(*why);
      },
      {.seconds = 20, .quiet = quiet});
  if (crash) return "the engine " + *crash;
  return verdict->failed ? std::optional<std::string>(verdict->text.data()) : std::nullopt;
}

/// Draws the mismatch that the checker finds in a trace; the world alone where it finds none, or crashes.
std::string drawTrace(const Trace& trace, const std::string& file) {
  const oracle::Shared<bool> drawn;
  oracle::CheckOptions options;
  options.skipRefused = true;
  const auto write = [&](const std::string& svg) { *drawn = oracle::writeFile(file, svg).has_value(); };
  static_cast<void>(oracle::crashOf(
      [&] {
        if (const auto mismatch = oracle::findMismatch(trace, options)) write(draw(*mismatch));
      },
      {.quiet = true}));
  if (!*drawn) write(oracle::drawWithoutEngine(trace, "the world at the end of the trace"));
  return *drawn ? file : "could not be written: " + file;
}

}  // namespace

std::optional<Failure> firstFailure(const Cases& cases) {
  // RapidCheck calls a property up to a hundred times; the number of a case counts all before it.
  static std::pair<const testing::TestInfo*, std::uint64_t> passed;
  const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
  if (passed.first != test) passed = {test, 0};
  const oracle::Shared<Verdict> verdict;
  const auto crash = oracle::crashOf([&] {
    for (verdict->number = 0; verdict->number < cases.count && !verdict->failed; ++verdict->number) {
      oracle::stillAlive();
      if (const auto why = complaintHere(cases, cases.trace(verdict->number), verdict->number)) {
        verdict->fail(*why);
        return;
      }
    }
  });
  if (!crash && !verdict->failed) {
    passed.second += cases.count;
    return std::nullopt;
  }

  const std::uint64_t number = verdict->number;
  const Trace trace = cases.trace(number);
  const auto stillFails = [&](const Trace& t) {
    return (!cases.mayBe || cases.mayBe(t)) && complaintOf(cases, t, number, true).has_value();
  };
  const bool again = stillFails(trace);
  const Trace small = again ? oracle::shrink(trace, stillFails, std::chrono::seconds(20)) : trace;
  const std::string why = again ? complaintOf(cases, small, number, true).value_or("not again")
                                : "fails in its turn, but not by itself: " +
                                      (crash ? "the engine " + *crash : std::string(verdict->text.data()));
  // For whoever reads the report of a test run: proptests/bugs/run.py does.
  testing::Test::RecordProperty("cases", std::to_string(passed.second + number + 1));
  if (again) testing::Test::RecordProperty("shrunk_edits", std::to_string(editCount(small)));
  std::string file = testing::TempDir() + "lgs-" + cases.name;
  std::replace(file.begin(), file.end(), ' ', '-');
  const bool saved = oracle::writeFile(file + ".trace", oracle::printTrace(small, why)).has_value();
  return Failure{
      small,
      fmt::format(
          "{}: {}\n{}trace      {}.trace{}\npicture    {}\nlook at it lgs replay {}.trace --check --svg mismatch.svg",
          cases.name, why, oracle::printTrace(small), file, saved ? "" : " could not be written",
          drawTrace(small, file + ".svg"), file)};
}

std::string again(const std::string& program) {
  const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
  const char* scale = std::getenv("LGS_TEST_SCALE");
  return fmt::format("{}{} --gtest_filter='{}.{}'", scale ? fmt::format("LGS_TEST_SCALE={} ", scale) : "", program,
                     test.test_suite_name(), test.name());
}

std::optional<std::string> failedExpectation(const std::function<void()>& work) {
  testing::TestPartResultArray results;
  {
    const testing::ScopedFakeTestPartResultReporter reporter(
        testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD, &results);
    work();
  }
  for (int k = 0; k < results.size(); ++k) {
    const testing::TestPartResult& result = results.GetTestPartResult(k);
    if (!result.failed()) continue;
    const std::string file = std::filesystem::path(result.file_name() ? result.file_name() : "").filename();
    return fmt::format("{}:{}: {}", file, result.line_number(), result.message());
  }
  return std::nullopt;
}

}  // namespace lgs::test
