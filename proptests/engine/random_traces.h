// Properties over the random cases of oracle/check. RapidCheck chooses size and seed of a case; for what becomes of one
// that fails see first_failure.h.
#pragma once

#include "oracle/generate/random.h"
#include "oracle/reference/outline.h"
#include "oracle/trace/trace.h"
#include "proptests/first_failure.h"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>

namespace lgs::engine_test {

using test::Failure;
using test::firstFailure;

/// What is wrong, if anything. It is given traces whose every edit is accepted unless said otherwise, and its own
/// source of chance, which is the same each time the case is tried.
using Property = std::function<std::optional<std::string>(const oracle::Trace&, oracle::Random)>;

struct CaseKind {
  bool withRefused = false;   ///< keep the edits that must be refused
  bool withPreserve = true;   ///< keep the preserve relation
  std::size_t maxEdits = 60;  ///< at most
};

/// To be called in a RapidCheck property: tries this many cases (times the test scale), and fails it with the smallest
/// trace found.
void forRandomTraces(const std::string& name, int cases, const CaseKind& kind, const Property& property);

/// Fails a RapidCheck property by what firstFailure() found, with the command that finds it again.
void failProperty(const Failure& failure);

/// A 64-bit number of RapidCheck's that it does not try to make small.
std::uint64_t anySeed();

/// The adds of all that a trace leaves standing, by name.
std::map<std::string, oracle::Edit> survivors(const oracle::Trace& trace);

/// What the engine puts out after all of a trace, which must hold no refused edits.
oracle::Outline outlineAfter(const oracle::Trace& trace);

/// In words, if there is one. `expected` need not be sorted.
std::optional<std::string> differenceOf(oracle::Outline expected, const oracle::Outline& actual);

}  // namespace lgs::engine_test
