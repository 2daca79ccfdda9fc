#include "random_traces.h"

#include "oracle/check/failure.h"
#include "oracle/check/generator.h"
#include "oracle/check/isolated.h"
#include "oracle/check/model.h"
#include "oracle/check/shrink.h"
#include "oracle/reference/compare.h"
#include "oracle/trace/dump.h"
#include "oracle/trace/file.h"
#include "oracle/trace/player.h"
#include "scale.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <vector>

namespace lgs::engine_test {

using oracle::Edit;
using oracle::Trace;

std::uint64_t anySeed() {
  return *rc::gen::noShrink(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>()));
}

oracle::Outline outlineAfter(const Trace& trace) {
  oracle::Player player(trace.preserve);
  EXPECT_TRUE(oracle::play(trace, player));
  player.commit();
  return oracle::outlineOf(player.world());
}

std::optional<std::string> differenceOf(oracle::Outline expected, const oracle::Outline& actual) {
  std::sort(expected.begin(), expected.end());
  if (expected == actual) return std::nullopt;
  return describe(compare(expected, actual));
}

std::map<std::string, Edit> survivors(const Trace& trace) {
  std::map<std::string, Edit> out;
  for (const Edit& edit : trace.edits) {
    if (edit.kind == Edit::Kind::add) out[edit.name] = edit;
    if (edit.kind == Edit::Kind::remove) out.erase(edit.name);
  }
  return out;
}

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

std::optional<std::string> complaintOf(const Cases& cases, const Trace& trace, std::uint64_t number, bool quiet) {
  const oracle::Shared<Verdict> verdict;
  const auto crash = oracle::crashOf(
      [&] {
        if (const auto why = cases.complaint(trace, number)) verdict->fail(*why);
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
  const oracle::Shared<Verdict> verdict;
  const auto crash = oracle::crashOf([&] {
    for (verdict->number = 0; verdict->number < cases.count && !verdict->failed; ++verdict->number) {
      oracle::stillAlive();
      if (const auto why = cases.complaint(cases.trace(verdict->number), verdict->number)) {
        verdict->fail(*why);
        return;
      }
    }
  });
  if (!crash && !verdict->failed) return std::nullopt;

  const std::uint64_t number = verdict->number;
  const Trace trace = cases.trace(number);
  const auto stillFails = [&](const Trace& t) {
    return (!cases.mayBe || cases.mayBe(t)) && complaintOf(cases, t, number, true).has_value();
  };
  if (!stillFails(trace))
    return Failure{trace, cases.name + ": fails once, but not again: " + (crash ? *crash : verdict->text.data())};
  const Trace small = oracle::shrink(trace, stillFails, std::chrono::seconds(20));
  const std::string why = complaintOf(cases, small, number, true).value_or("not again");
  // For whoever reads the report of a test run: proptests/bugs/run.py does.
  testing::Test::RecordProperty("cases", std::to_string(number + 1));
  testing::Test::RecordProperty("shrunk_edits", std::to_string(editCount(small)));
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

void forRandomTraces(const std::string& name, int cases, const CaseKind& kind, const Property& property) {
  struct Choice {
    oracle::GeneratorOptions options;
    std::uint64_t seed;
  };
  std::vector<Choice> choices;
  for (std::int64_t k = 0; k < scaled(cases); ++k) {
    oracle::GeneratorOptions options;
    // A commit goes another way where a row has many dirty cells: so every third case is a wide and low one.
    const bool wide = k % 3 == 2;
    options.width = wide ? *rc::gen::noShrink(rc::gen::inRange(8, 20)) : *rc::gen::noShrink(rc::gen::inRange(1, 6));
    options.height = *rc::gen::noShrink(rc::gen::inRange(1, wide ? 4 : 5));
    options.edits = *rc::gen::noShrink(rc::gen::inRange<std::size_t>(1, kind.maxEdits + 1));
    choices.push_back({options, anySeed()});
  }
  const auto traceOf = [&](std::uint64_t k) {
    Trace trace = oracle::randomCase(choices[k].options, choices[k].seed);
    if (!kind.withPreserve) trace.preserve = {};
    return kind.withRefused ? trace : withoutRefused(trace);
  };
  const auto failure = firstFailure(
      {.name = name,
       .count = choices.size(),
       .trace = traceOf,
       .complaint = [&](const Trace& t, std::uint64_t k) { return property(t, oracle::Random(choices[k].seed)); },
       .mayBe = [&](const Trace& t) { return kind.withRefused || withoutRefused(t).edits.size() == t.edits.size(); }});
  if (failure) RC_FAIL(failure->text);
}

}  // namespace lgs::engine_test
