// What most targets do with the edits that they make of an input.
#pragma once

#include "fuzz/target.h"

namespace lgs::fuzz {

/// Checks edits, of which some may have to be refused. What the checker can not explain is a finding too.
std::optional<Finding> checkEdits(const oracle::Trace& trace, oracle::CheckOptions options, oracle::CheckStats& stats);

}  // namespace lgs::fuzz
