// The tests' own tools on bugs planted here, in what the engine puts out or is given: each is found in random cases and
// shrinks to a few edits; what was found is saved and drawn. A crash is such a bug. (proptests/bugs plants them in
// lib/.)
#include "proptests/support/law.h"

#include "oracle/check/isolated.h"
#include "oracle/trace/dump.h"
#include "oracle/trace/file.h"
#include "oracle/trace/model.h"
#include "proptests/support/exhaust.h"
#include "proptests/support/played.h"
#include "proptests/support/traces.h"

#include <gtest/gtest.h>

#include <unistd.h>
#include <algorithm>
#include <cstdlib>
#include <set>

namespace lgs::test {
namespace {

using oracle::Call;
using oracle::Outline;
using oracle::OutlineSegment;
using oracle::Trace;
using Failure = std::optional<std::string>;
using TraceLaw = std::function<void(const GoodTrace&)>;

/// What a faulty engine makes of a trace.
using FaultyEngine = std::function<Outline(const Trace&)>;

Failure huntedDown(const FaultyEngine& engine) {
  const auto law = [&](const GoodTrace& t) { expectSame(outlineAfter(t), engine(t)); };
  return falsified({.cases = 1'000, .seed = 1}, casesOf(TraceLaw(law)));
}

/// What stands after a word at the start of a line.
std::string after(const std::string& word, const std::string& text) {
  const std::size_t at = text.find("\n" + word);
  if (at == std::string::npos) return {};
  const std::size_t begin = text.find_first_not_of(' ', at + 1 + word.size());
  return text.substr(begin, text.find('\n', begin) - begin);
}

void expectTold(const Failure& failure, std::size_t mostEdits) {
  ASSERT_TRUE(failure) << "not found";
  const std::string file = after("trace", *failure);
  const auto saved = oracle::readTrace(file);
  ASSERT_TRUE(saved) << *failure;
  EXPECT_LE(editCount(*saved), mostEdits) << *failure;
  EXPECT_NE(failure->find(printTrace(*saved)), std::string::npos) << *failure;
  const auto picture = oracle::readFile(after("picture", *failure));
  ASSERT_TRUE(picture) << *failure;
  EXPECT_NE(picture->find("</svg>"), std::string::npos);
  const auto page = oracle::readFile(after("page", *failure));
  ASSERT_TRUE(page) << *failure;
  EXPECT_NE(page->find("</html>"), std::string::npos);
  EXPECT_NE(file.find(testing::UnitTest::GetInstance()->current_test_info()->name()), std::string::npos);
  EXPECT_TRUE(after("again", *failure).starts_with("LGS_TEST_SEED=")) << *failure;
}

void expectSmall(const Failure& failure) { expectTold(failure, 4); }

bool isStraight(Point a, Point b, Point c) { return (a.x == b.x && b.x == c.x) || (a.y == b.y && b.y == c.y); }

TEST(Planted, AWallThatIsNotCut) {
  expectSmall(huntedDown([](const Trace& trace) {
    const Outline right = outlineAfter(trace);
    Outline wrong;
    for (const OutlineSegment& s : right) {
      const auto before = [&](const OutlineSegment& t) {
        return t.end == s.start && s.ghost1 == t.start && t.block == s.block && isStraight(t.start, s.start, s.end);
      };
      const auto found = std::find_if(wrong.begin(), wrong.end(), before);
      if (found == wrong.end()) {
        wrong.push_back(s);
      } else {
        found->end = s.end;
        found->ghost2 = s.ghost2;
      }
    }
    return wrong;
  }));
}

TEST(Planted, AnExpectationThatFails) {
  const Failure failure = huntedDown([](const Trace& trace) {
    for (const Call& edit : trace.calls) EXPECT_NE(edit.polygon().vertices.size(), 5U);
    return outlineAfter(trace);
  });
  expectSmall(failure);
  EXPECT_NE(failure->find("edit.polygon().vertices.size()"), std::string::npos) << *failure;
}

bool hasCrowdedCell(const Trace& trace) {
  oracle::Model model;
  for (const Call& edit : trace.calls) model.apply(edit);
  return std::ranges::any_of(model.standing().cells(), [](const auto& entry) { return entry.second.size() >= 2; });
}

TEST(Planted, ACrash) {
  const Failure failure = huntedDown([](const Trace& trace) {
    if (hasCrowdedCell(trace)) std::abort();
    return outlineAfter(trace);
  });
  expectSmall(failure);
  EXPECT_NE(failure->find("the engine crashed with SIGABRT"), std::string::npos) << *failure;
}

// It is no bug of the engine's, so a replay can not show it; then the text must not say so.
TEST(Planted, ABugThatNoReplayShows) {
  const Failure failure = huntedDown([](const Trace&) { return Outline(); });
  expectSmall(failure);
  EXPECT_EQ(failure->find("look at it"), std::string::npos) << *failure;
  EXPECT_NE(failure->find("shows nothing wrong"), std::string::npos) << *failure;
}

TEST(Planted, AFailureThatTakesTheCasesBeforeItIsToldAsItIs) {
  const oracle::Shared<int> tried;
  const auto law = [&](const GoodTrace&) {
    if (++*tried == 30) failIf("the thirtieth");
  };
  const Failure failure = falsified({.cases = 100, .seed = 1}, casesOf(TraceLaw(law)));
  expectTold(failure, 60);
  EXPECT_NE(failure->find("does not hold for case 30 of 100"), std::string::npos) << *failure;
  EXPECT_NE(failure->find("not by itself: the thirtieth"), std::string::npos) << *failure;
}

TEST(Planted, EqualEffortsMakeEqualCases) {
  const auto casesOf64 = [](std::uint64_t seed) {
    const oracle::Shared<std::uint64_t> sum;
    const auto law = [&](Chance chance) { *sum = 3 * *sum + *chance.seed; };
    EXPECT_FALSE(falsified({.cases = 64, .seed = seed}, casesOf(std::function<void(Chance)>(law))));
    return *sum;
  };
  EXPECT_EQ(casesOf64(1), casesOf64(1));
  EXPECT_NE(casesOf64(1), casesOf64(2));
}

TEST(Planted, WhereChanceDoesNotMatterItGoesAsItComes) {
  const auto toldOf = [](const std::function<void(Chance)>& law) {
    return falsified({.cases = 64, .seed = 1}, casesOf(law)).value_or("");
  };
  EXPECT_NE(toldOf([](Chance) { failIf("always"); }).find("as it comes"), std::string::npos);
  EXPECT_EQ(toldOf([](Chance chance) { failUnless(!chance.chance(50), "now and then"); }).find("as it comes"),
            std::string::npos);
  Chance plain;
  std::vector<int> items{1, 2, 3};
  plain.shuffle(items);
  EXPECT_EQ(items, (std::vector<int>{1, 2, 3}));
  EXPECT_EQ(plain.pick(items), 1);
  EXPECT_TRUE(plain.chance(100) && !plain.chance(99));
}

TEST(Planted, AnEndlessLoop) {
  const oracle::IsolationOptions oneSecond{.seconds = 1, .quiet = true};
  volatile bool forEver = true;
  const auto spin = [&] {
    while (forEver) {
    }
  };
  EXPECT_EQ(oracle::crashOf(spin, oneSecond), "hung for 1 s of CPU time");
  EXPECT_EQ(oracle::crashOf([] {}, oneSecond), std::nullopt);
}

TEST(Planted, ASleepWithoutEnd) {
  const oracle::IsolationOptions oneSecond{.asleep = 1, .quiet = true};
  const auto sleep = [] {
    for (;;) pause();
  };
  EXPECT_EQ(oracle::crashOf(sleep, oneSecond), "hung asleep for 1 s");
}

TEST(Exhaust, DrawsEveryCombinationOnce) {
  std::set<std::vector<int>> seen;
  int count = 0;
  Exhaust all;
  while (all.next()) {
    std::vector<int> drawn{all.below(3)};
    for (int k = 0; k < drawn[0]; ++k) drawn.push_back(all.below(2 + k));  // as many as the first says, and so far
    seen.insert(drawn);
    ++count;
  }
  EXPECT_EQ(count, 1 + 2 + 2 * 3);
  EXPECT_EQ(seen.size(), 9U);
}

TEST(Exhaust, OfNothingIsOneCombination) {
  Exhaust all;
  EXPECT_TRUE(all.next());
  EXPECT_FALSE(all.next());
}

}  // namespace
}  // namespace lgs::test
