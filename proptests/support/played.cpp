#include "proptests/support/played.h"

#include "oracle/check/failure.h"
#include "oracle/reference/compare.h"
#include "oracle/trace/dump.h"
#include "proptests/support/law.h"

#include <algorithm>

namespace lgs::test {

using oracle::Outline;
using oracle::Trace;

void playAll(const Trace& trace, oracle::Player& player, const oracle::CommitCallback& afterCommit) {
  keep([&] { return printTrace(trace); });
  const auto played = oracle::play(trace, player, afterCommit);
  if (!played) failIf("refused, but is good: " + played.error().text);
}

Outline outlineAfter(const Trace& trace) {
  oracle::Player player(trace.preserve);
  playAll(trace, player);
  player.commit();
  return oracle::outlineOf(player.world());
}

std::optional<std::string> differenceOf(Outline expected, const Outline& actual) {
  std::sort(expected.begin(), expected.end());
  if (expected == actual) return std::nullopt;
  return describe(compare(expected, actual));
}

void expectSame(Outline expected, const Outline& actual) { failIf(differenceOf(std::move(expected), actual)); }

void expectNoMismatch(const Trace& trace, const oracle::CheckOptions& options, oracle::CheckStats& stats) {
  const auto result = oracle::checkTrace(trace, options, stats);
  if (!result) failIf(message(result.error(), "trace"));
  if (*result) failIf(describe(**result, trace));
}

void expectNoMismatch(const Trace& trace, const oracle::CheckOptions& options) {
  oracle::CheckStats stats;
  expectNoMismatch(trace, options, stats);
}

}  // namespace lgs::test
