// The text of traces: parsed, played and checked, printed, parsed again.
#include "fuzz/check_edits.h"
#include "oracle/trace/plain_edits.h"

#include <algorithm>
#include <array>

namespace lgs::fuzz {
namespace trace_target {
namespace {

using oracle::Call;
using oracle::Trace;

constexpr std::array<std::string_view, 41> kWords{
    // Lines, and how they begin and end.
    "lgs-trace 1\n", "lgs-trace 2\n", "lgs-trace 3\n", "lgs-trace 4\n", " by fill too\n",
    "mark\nback 0 keep\nforward 0\n", "fill 0 0 1 0 1  0 0 1 0 1 1\n", "unload 0 0 31 31\n", "reload 0 0 31 31\n",
    "group keep\nend\n", "load\n", "place 0 0 1  0 0 1 0 1 1 | 0 0 1 1 0 1  as a b  room 1\n", "remove 0:0#0\n",
    "carve 0.2 0 1.5 0.3 1 1\n", "paint 1 fill ", "paint 2 replace 0 0 2 0 0 2 |", "add p 0 0 1 0 0 1 0 1 1\n", "add ",
    "remove ", "remove p\n", "commit\n", "preserve ", "preserve 1 2\n",
    // What stands between words.
    "# ", " ", ",", "\n", "\r\n", "\t", "-", "/",
    // Numbers.
    "1/3", "0.5", "1e-3", "-0", "1e1000", "1073741824", "-1073741824", "4294967295",
    // A mark of the byte order; a square.
    "\xef\xbb\xbf", "0 0 1 0 1 1 0 1"};

std::optional<Finding> checkTrace(const Trace& trace, oracle::CheckStats& stats) {
  const auto isLarge = [](const Call& edit) {
    std::size_t vertices = 100 * (edit.kind == oracle::Call::Kind::repeat ? edit.nth : 0);
    for (const oracle::Coming& coming : edit.comes)
      for (const oracle::LocalPolygon& polygon : coming.shape) vertices += polygon.size();
    for (const auto& ring : edit.brush.rings) vertices += ring.size();
    const auto [min, max] = oracle::cellsUnder(edit.brush);
    const std::int64_t wide = std::int64_t{edit.cells.max.i} - edit.cells.min.i,
                       high = std::int64_t{edit.cells.max.j} - edit.cells.min.j;
    if (edit.kind == oracle::Call::Kind::fill && (wide > 30 || high > 30)) return true;
    return vertices > 100 || !edit.group.empty() || std::max(max.i - min.i, max.j - min.j) > 30;
  };
  const bool large = editCount(trace) > 200 || std::any_of(trace.calls.begin(), trace.calls.end(), isLarge);
  if (large) return std::nullopt;  // the references take their time
  return checkEdits(trace, {.cgal = false}, stats);
}

Trace traceOf(Bytes input) { return oracle::parseTrace(textOf(input)).trace; }

std::string whyEmpty(Bytes input) {
  const oracle::ParsedTrace parsed = oracle::parseTrace(textOf(input));
  return parsed.error ? message(*parsed.error, "the text") : "the trace has no edits";
}

std::optional<Finding> check(Bytes input, oracle::CheckStats& stats) {
  const oracle::ParsedTrace parsed = oracle::parseTrace(textOf(input));
  if (parsed.error && (parsed.error->line == 0 || parsed.error->text.empty())) {
    return Finding{"a bad line without its number, or without a word on what is wrong\n"};
  }
  const std::string printed = printTrace(parsed.trace);
  const oracle::ParsedTrace again = oracle::parseTrace(printed);
  if (again.error) return Finding{"what was printed can not be parsed: " + message(*again.error, "printed") + "\n"};
  if (again.trace != parsed.trace) return Finding{"another trace after printing and parsing\n"};
  if (printTrace(again.trace) != printed) return Finding{"another text after parsing and printing\n"};
  return checkTrace(parsed.trace, stats);
}

constexpr Target kTarget{"trace", "the text of traces, parsed, played and printed", check, traceOf, checkTrace, kWords,
                         whyEmpty};

}  // namespace
}  // namespace trace_target

const Target kTrace = trace_target::kTarget;

}  // namespace lgs::fuzz
