#include "random_traces.h"

#include "oracle/check/generator.h"
#include "oracle/check/model.h"
#include "oracle/check/shrink.h"
#include "oracle/reference/compare.h"
#include "oracle/trace/dump.h"
#include "oracle/trace/file.h"
#include "oracle/trace/player.h"
#include "scale.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <chrono>

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

Trace withoutRefused(const Trace& trace) {
  oracle::Model model;
  Trace good{trace.preserve, {}};
  for (const Edit& edit : trace.edits) {
    if (!model.judge(edit).accepted) continue;
    model.apply(edit);
    good.edits.push_back(edit);
  }
  return good;
}

void forRandomTraces(const std::string& name, int cases, const CaseKind& kind, const Property& property) {
  for (std::int64_t k = 0; k < scaled(cases); ++k) {
    oracle::GeneratorOptions options;
    // A commit goes another way where a row has many dirty cells: so every third case is a wide and low one.
    const bool wide = k % 3 == 2;
    options.width = wide ? *rc::gen::noShrink(rc::gen::inRange(8, 20)) : *rc::gen::noShrink(rc::gen::inRange(1, 6));
    options.height = *rc::gen::noShrink(rc::gen::inRange(1, wide ? 4 : 5));
    options.edits = *rc::gen::noShrink(rc::gen::inRange<std::size_t>(1, kind.maxEdits + 1));
    const std::uint64_t seed = anySeed();
    Trace trace = oracle::randomCase(options, seed);
    if (!kind.withPreserve) trace.preserve = {};
    if (!kind.withRefused) trace = withoutRefused(trace);
    const auto complaint = [&](const Trace& t) { return property(t, oracle::Random(seed)); };
    if (!complaint(trace)) continue;

    const auto stillFails = [&](const Trace& t) {
      if (!kind.withRefused && withoutRefused(t).edits.size() != t.edits.size()) return false;
      return complaint(t).has_value();
    };
    const Trace small = oracle::shrink(trace, stillFails, std::chrono::seconds(20));
    std::string file = testing::TempDir() + "lgs-" + name + ".trace";
    std::replace(file.begin(), file.end(), ' ', '-');
    const std::string text = oracle::printTrace(small);
    static_cast<void>(oracle::writeFile(file, text));
    RC_FAIL(name + ": " + *complaint(small) + "\n" + text + "Look at it with: lgs replay " + file +
            " --check --svg mismatch.svg");
  }
}

}  // namespace lgs::engine_test
