// Most targets make edits of an input, and check them in this way.
#pragma once

#include "fuzz/target.h"

namespace lgs::fuzz {

/// Random edits of an input's bytes, most of them good.
oracle::Trace mostlyGood(Bytes input);

/// Checks edits. Some of them may have to be refused. It is a finding too if the checker can not explain an error.
std::optional<Finding> checkEdits(const oracle::Trace& trace, oracle::CheckOptions options, oracle::CheckStats& stats);

/// Runs an input by its edits.
template <auto traceOf, auto checkTrace>
std::optional<Finding> check(Bytes input, oracle::CheckStats& stats) {
  return checkTrace(traceOf(input), stats);
}

}  // namespace lgs::fuzz
