#include "random_traces.h"

#include "oracle/generate/generator.h"
#include "oracle/reference/compare.h"
#include "oracle/trace/dump.h"
#include "oracle/trace/model.h"
#include "oracle/trace/player.h"
#include "scale.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <vector>

namespace lgs::engine_test {

using oracle::Edit;
using oracle::Trace;

std::uint64_t anySeed() {
  return *rc::gen::noShrink(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>()));
}

void failProperty(const Failure& failure) {
  // What RapidCheck prints for this, "reproduce=…", does not say the scale; at another one it leads to other cases.
  const std::string text = fmt::format("{}\nagain      RC_PARAMS='seed={}' {}", failure.text,
                                       rc::detail::configuration().testParams.seed, test::again("lgs_engine_tests"));
  RC_FAIL(text);
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
  if (failure) failProperty(*failure);
}

}  // namespace lgs::engine_test
