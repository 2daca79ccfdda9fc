// Edits: after every commit the engine against the naive reference, its change list against a mirror; at the end CGAL's
// union, the loops, and the same world built in another order. Most of what `edits` tries is good, most of what
// `polygons` tries is bad. `views` has views of loops, islands and pieces follow the world, and holds them against full
// recomputes. `brush` has strokes of brushes among its edits. How far these are from the exact result (law 8) CGAL
// measures in `lgs check`: here it would take most of the time.
#include "fuzz/check_edits.h"

namespace lgs::fuzz {

using oracle::Trace;

namespace {

constexpr std::size_t kMost = 2'048;  // edits

Trace mostlyBad(Bytes input) { return oracle::caseOf(input, {.edits = kMost, .isOfCalls = true, .bad = true}); }

std::optional<Finding> checkTrace(const Trace& trace, oracle::CheckStats& stats) {
  return checkEdits(trace, {.unionAtEnd = true}, stats);
}

std::optional<Finding> checkStrokes(const Trace& trace, oracle::CheckStats& stats) {
  return checkEdits(trace, {.cgal = false}, stats);
}

std::optional<Finding> checkViews(const Trace& trace, oracle::CheckStats& stats) {
  return checkEdits(trace, {.cgal = false, .views = true}, stats);
}

}  // namespace

Trace mostlyGood(Bytes input) { return oracle::caseOf(input, {.edits = kMost, .isOfCalls = true}); }

namespace {
Trace withStrokes(Bytes input) { return oracle::caseOf(input, {.edits = kMost, .isOfCalls = true, .brushes = true}); }

// Views do not know what is not in memory.
Trace inMemory(Bytes input) { return oracle::caseOf(input, {.edits = kMost, .isOfCalls = true, .inMemory = true}); }
}  // namespace

std::optional<Finding> checkEdits(const Trace& trace, oracle::CheckOptions options, oracle::CheckStats& stats) {
  options.skipRefused = true;
  auto result = oracle::checkTrace(trace, options, stats);
  if (!result) return Finding{"an edit can not be judged: " + result.error().text + "\n"};
  if (!*result) return std::nullopt;
  return Finding{describe((*result)->kind) + ":\n" + (*result)->text, std::move(*result)};
}

const Target kEdits{"edits", "edit sequences against the references", check<mostlyGood, checkTrace>, mostlyGood,
                    checkTrace};

const Target kViews{"views", "loops, islands and pieces against full recomputes", check<inMemory, checkViews>, inMemory,
                    checkViews};

const Target kBrush{"brush", "strokes of brushes on a small world", check<withStrokes, checkStrokes>, withStrokes,
                    checkStrokes};

const Target kPolygons{"polygons", "bad polygons: refusals are right and total", check<mostlyBad, checkTrace>,
                       mostlyBad, checkTrace};

}  // namespace lgs::fuzz
