// Edits: after every commit the engine against the naive reference, its change list against a mirror; at the end CGAL's
// union, the loops, and the same world built in another order. Most of the edits of `edits` are good, most of
// `polygons` are bad. `views` has views of loops, islands and pieces follow the world, and holds them against full recomputes.
#include "fuzz/check_edits.h"

#include <array>

namespace lgs::fuzz {
namespace {

constexpr std::array kMostlyGood{Action::replace, Action::replace, Action::place,  Action::hull,  Action::hull,
                                 Action::fill,    Action::remove,  Action::remove, Action::clear, Action::commit};

constexpr std::array kMostlyBad{Action::spoilt,   Action::spoilt, Action::spoilt, Action::free,  Action::free,
                                Action::vertices, Action::raw,    Action::hull,   Action::place, Action::remove};

std::optional<Finding> checkTrace(const oracle::Trace& trace, oracle::CheckStats& stats) {
  return checkEdits(trace, {.unionAtEnd = true}, stats);
}

std::optional<Finding> checkViews(const oracle::Trace& trace, oracle::CheckStats& stats) {
  return checkEdits(trace, {.cgal = false, .views = true}, stats);
}

std::optional<Finding> checkViews(Bytes input, oracle::CheckStats& stats) { return checkViews(decode(input), stats); }

std::optional<Finding> check(Bytes input, oracle::CheckStats& stats) { return checkTrace(decode(input), stats); }

}  // namespace

std::optional<Finding> checkEdits(const oracle::Trace& trace, oracle::CheckOptions options, oracle::CheckStats& stats) {
  options.skipRefused = true;
  auto result = oracle::checkTrace(trace, options, stats);
  if (!result) return Finding{"an edit can not be judged: " + result.error().text + "\n"};
  if (!*result) return std::nullopt;
  return Finding{describe((*result)->kind) + ":\n" + (*result)->text, std::move(*result)};
}

const Target kEdits{"edits", "edit sequences against the references", check, decode, checkTrace, kMostlyGood, {}};

const Target kViews{
    "views", "loops, islands and pieces against full recomputes", checkViews, decode, checkViews, kMostlyGood, {}};

const Target kPolygons{"polygons", "bad polygons: refusals are right and total", check, decode, checkTrace, kMostlyBad,
                       {}};

}  // namespace lgs::fuzz
