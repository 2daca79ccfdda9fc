// Edits, most of them good: after every commit the engine against the naive reference, its change list against a mirror;
// at the end CGAL's union, the loops, and the same world built in another order.
#include "fuzz/target.h"

#include <array>

namespace lgs::fuzz {
namespace {

constexpr std::array kActions{Action::replace, Action::replace, Action::place,  Action::hull,  Action::hull,
                              Action::fill,    Action::remove,  Action::remove, Action::clear, Action::commit};

std::optional<Finding> checkTrace(const oracle::Trace& trace, oracle::CheckStats& stats) {
  oracle::CheckOptions options;
  options.skipRefused = true;
  options.unionAtEnd = true;
  auto result = oracle::checkTrace(trace, options, stats);
  if (!result || !*result) return std::nullopt;  // an error is a limit of the engine's
  return Finding{describe((*result)->kind) + ":\n" + (*result)->text, std::move(*result)};
}

std::optional<Finding> check(Bytes input, oracle::CheckStats& stats) { return checkTrace(decode(input), stats); }

}  // namespace

const Target kEdits{"edits", "edit sequences against the references", check, decode, checkTrace, kActions, {}};

}  // namespace lgs::fuzz
