// What the engine makes of a trace, for laws that compare.
#pragma once

#include "oracle/check/checker.h"
#include "oracle/reference/outline.h"
#include "oracle/trace/player.h"
#include "oracle/trace/trace.h"

#include <optional>
#include <string>

namespace lgs::test {

/// Plays all of a trace, which must hold no refused edits. The trace is kept (law.h): where the law fails it may be the
/// one to look at.
void playAll(const oracle::Trace& trace, oracle::Player& player, const oracle::CommitCallback& afterCommit = {});

/// What the engine puts out after it.
oracle::Outline outlineAfter(const oracle::Trace& trace);

/// In words, if there is one. `expected` need not be sorted.
std::optional<std::string> differenceOf(oracle::Outline expected, const oracle::Outline& actual);

/// Fails the case that is running, if they differ.
void expectSame(oracle::Outline expected, const oracle::Outline& actual);

/// Fails the case that is running, if the checker finds something in the trace, or can not go on; adds to `stats`.
void expectNoMismatch(const oracle::Trace& trace, const oracle::CheckOptions& options, oracle::CheckStats& stats);
void expectNoMismatch(const oracle::Trace& trace, const oracle::CheckOptions& options = {});

}  // namespace lgs::test
