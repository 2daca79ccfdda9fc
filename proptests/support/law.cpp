#include "proptests/support/law.h"

#include "oracle/check/isolated.h"
#include "oracle/check/shell.h"
#include "proptests/support/rapid.h"
#include "proptests/support/scale.h"
#include "proptests/support/time_limit.h"

#include <fmt/format.h>
#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <filesystem>

// A race that the thread sanitizer sees in a child has to end it: a child leaves without telling how it went.
// NOLINTNEXTLINE(bugprone-reserved-identifier,cert-dcl37-c,cert-dcl51-cpp,readability-identifier-naming)
extern "C" const char* __tsan_default_options() { return "halt_on_error=1"; }

namespace lgs::test {
namespace {

using Clock = std::chrono::steady_clock;

/// Texts in memory that a child shares with its parent: the last one is what is wrong, if anything is.
struct Verdict {
  bool failed = false;
  std::array<char, 100'000> kept{};  // one after the other, each ended by a null
  std::size_t used = 0;
  std::array<char, 20'000> why{};

  void fail(const std::string& text) {
    failed = true;
    why[text.copy(why.data(), why.size() - 1)] = '\0';
  }
  void keep(std::string_view text) {
    if (used + text.size() >= kept.size()) return;
    text.copy(kept.data() + used, text.size());
    used += text.size() + 1;
  }
};

Verdict* keeper = nullptr;  // of the case that runs, where what it keeps will be read
Told theTold;
Clock::time_point deadline = Clock::time_point::max();  // to make a case small

std::vector<std::string> textsIn(const Verdict& verdict) {
  std::vector<std::string> texts;
  for (std::size_t at = 0; at < verdict.used; at += texts.back().size() + 1) texts.emplace_back(&verdict.kept[at]);
  return texts;
}

/// An expectation that fails in the child process would be lost with it.
std::optional<std::string> failureHere(const Case& theCase) {
  std::optional<std::string> thrown;
  const auto expectation = failedExpectation([&] {
    try {
      thrown = rapid::failedAssertion(theCase.run);
    } catch (const std::exception& error) {
      thrown = fmt::format("an exception: {}", error.what());
    }
  });
  return thrown ? thrown : expectation;
}

std::optional<Told> failureInChild(const Case& theCase) {
  const oracle::Shared<Verdict> verdict;
  const auto run = [&] {
    keeper = &*verdict;
    if (const auto why = failureHere(theCase)) verdict->fail(*why);
  };
  const auto crash = oracle::crashOf(run, {.seconds = 20, .quiet = true});
  if (!crash && !verdict->failed) return std::nullopt;
  return Told{crash ? "the engine " + *crash : verdict->why.data(), textsIn(*verdict)};
}

/// The number of the first case that fails, all in one child process, and what it said.
struct Search {
  std::int64_t tried = 0;
  Verdict verdict;
};

void search(const Effort& effort, const rc::Gen<Case>& cases, Search& found) {
  rapid::tryCases(effort, cases, false, [&](const Case& theCase) {
    if (found.verdict.failed) return false;  // RapidCheck asks again
    ++found.tried;
    oracle::stillAlive();
    if (const auto why = failureHere(theCase)) found.verdict.fail(*why);
    return !found.verdict.failed;
  });
}

struct Smallest {
  Case theCase;
  std::optional<Told> failed;  ///< none if the case holds by itself
};

/// Makes a case small. RapidCheck generates the earlier cases again, but they are not run. Then it tries simpler ones.
Smallest madeSmall(const Effort& effort, const rc::Gen<Case>& cases, std::int64_t number) {
  deadline = Clock::now() + std::chrono::seconds(20);
  Smallest best;
  std::int64_t come = 0;
  rapid::tryCases(effort, cases, true, [&](const Case& theCase) {
    ++come;
    if (come == number) best.theCase = theCase;
    if (come < number || (come > number && !best.failed) || isTimeUp()) return true;
    auto failed = failureInChild(theCase);
    if (!failed) return true;
    best = {theCase, std::move(failed)};
    return false;
  });
  return best;
}

const testing::TestInfo& runningTest() { return *testing::UnitTest::GetInstance()->current_test_info(); }
std::string nameOf(const testing::TestInfo& test) { return fmt::format("{}.{}", test.test_suite_name(), test.name()); }

/// The command that runs the current test again, wherever it is given.
std::string again() {
  return fmt::format("LGS_TEST_SEED={} LGS_TEST_SCALE={} {} --gtest_filter={}", testSeed(), testScale(),
                     oracle::thisProgram("the tests' program"), oracle::shellWord(nameOf(runningTest())));
}

}  // namespace

Effort effortOf(std::int64_t cases) {
  std::uint64_t hash = 14'695'981'039'346'656'037U;  // FNV-1a: the same everywhere, which std::hash need not be
  for (const char c : nameOf(runningTest())) hash = (hash ^ static_cast<unsigned char>(c)) * 1'099'511'628'211U;
  return {scaled(cases), hash + testSeed()};
}

std::optional<std::string> falsified(const Effort& effort, const rc::Gen<Case>& cases) {
  const oracle::Shared<Search> found;
  const auto crash = oracle::crashOf([&] { search(effort, cases, *found); });
  if (!crash && !found->verdict.failed) return std::nullopt;

  const std::int64_t number = found->tried;
  testing::Test::RecordProperty("cases", std::to_string(number));  // for whoever reads the report of a test run
  const Smallest smallest = madeSmall(effort, cases, number);
  const std::string first = crash ? "the engine " + *crash : found->verdict.why.data();
  theTold = smallest.failed.value_or(Told{"fails in its turn, but not by itself: " + first, {}});
  return fmt::format("{} does not hold for case {} of {}\n{}\n\n{}again      {}\n", nameOf(runningTest()), number,
                     effort.cases, theTold.why, smallest.theCase.told ? smallest.theCase.told() : std::string(),
                     again());
}

void failIf(const std::optional<std::string>& complaint) {
  if (complaint) rapid::fail(*complaint);
}

void failUnless(bool holds, const char* complaint) {
  if (!holds) failIf(complaint);
}

void keep(const std::function<std::string()>& text) {
  if (keeper != nullptr) keeper->keep(text());
}

bool isTimeUp() { return Clock::now() > deadline; }

const Told& told() { return theTold; }

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

std::string fileBase() {
  std::string name = nameOf(runningTest());
  std::replace(name.begin(), name.end(), '/', '-');
  return std::filesystem::absolute(testing::TempDir() + "lgs-" + name).string();
}

rc::Gen<Case> casesOf(std::function<void(const Arguments&)> law, const std::vector<rc::Gen<Argument>>& arguments) {
  rc::Gen<Arguments> all = rc::gen::just(Arguments());
  for (const rc::Gen<Argument>& next : arguments) {
    all = rc::gen::map(rc::gen::pair(all, next), [](std::pair<Arguments, Argument>&& drawn) {
      drawn.first.push_back(std::move(drawn.second));
      return std::move(drawn.first);
    });
  }
  return rc::gen::map(all, [law = std::move(law)](Arguments&& drawn) {
    const auto tell = [drawn] {
      std::string text;
      for (const Argument& each : drawn) text += each.told();
      return text;
    };
    return Case{[law, drawn] { law(drawn); }, tell};
  });
}

void check(const Effort& effort, const rc::Gen<Case>& cases) {
  const auto failure = falsified(effort, cases);
  if (failure) ADD_FAILURE_AT(runningTest().file(), runningTest().line()) << *failure;
}

}  // namespace lgs::test
