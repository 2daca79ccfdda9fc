// Most targets make edits of an input, and check them in this way.
#pragma once

#include "fuzz/target.h"

namespace lgs::fuzz {

/// Checks edits. Some of them may have to be refused. It is a finding too if the checker can not explain an error.
std::optional<Finding> checkEdits(const oracle::Trace& trace, oracle::CheckOptions options, oracle::CheckStats& stats);

}  // namespace lgs::fuzz
