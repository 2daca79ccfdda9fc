// Properties over the random cases of oracle/check. RapidCheck chooses size and seed of a case; a case that fails is
// made small by the project's own shrinker, which knows what an edit is, and is saved as a trace for `lgs replay` and as
// a picture. Cases run in a child process (isolated.h): an engine that crashes or hangs fails them like any other.
#pragma once

#include "oracle/check/random.h"
#include "oracle/reference/outline.h"
#include "oracle/trace/trace.h"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>

namespace lgs::engine_test {

/// What is wrong, if anything. It is given traces whose every edit is accepted unless said otherwise, and its own
/// source of chance, which is the same each time the case is tried.
using Property = std::function<std::optional<std::string>(const oracle::Trace&, oracle::Random)>;

/// Many cases by number, and what is wrong with a trace that was made of one of them. Both are called in a child process:
/// what they find out beyond that they must keep in Shared values.
struct Cases {
  std::string name;
  std::uint64_t count = 0;
  std::function<oracle::Trace(std::uint64_t)> trace;
  std::function<std::optional<std::string>(const oracle::Trace&, std::uint64_t)> complaint;
  std::function<bool(const oracle::Trace&)> mayBe = {};  ///< whether shrinking may come to this trace
};

struct Failure {
  oracle::Trace trace;  ///< the smallest one found
  std::string text;     ///< what is wrong, the trace, and the files that it and its picture were saved to
};

/// The first case that fails, if any does.
std::optional<Failure> firstFailure(const Cases& cases);

struct CaseKind {
  bool withRefused = false;   ///< keep the edits that must be refused
  bool withPreserve = true;   ///< keep the preserve relation
  std::size_t maxEdits = 60;  ///< at most
};

/// To be called in a RapidCheck property: tries this many cases (times the test scale), and fails it with the smallest
/// trace found.
void forRandomTraces(const std::string& name, int cases, const CaseKind& kind, const Property& property);

/// A 64-bit number of RapidCheck's that it does not try to make small.
std::uint64_t anySeed();

/// The adds of all that a trace leaves standing, by name.
std::map<std::string, oracle::Edit> survivors(const oracle::Trace& trace);

/// What the engine puts out after all of a trace, which must hold no refused edits.
oracle::Outline outlineAfter(const oracle::Trace& trace);

/// In words, if there is one. `expected` need not be sorted.
std::optional<std::string> differenceOf(oracle::Outline expected, const oracle::Outline& actual);

}  // namespace lgs::engine_test
