// What a person gets to see of a check: in words, as a trace that shows a failure again, and as a picture.
#pragma once

#include "oracle/check/checker.h"

#include <optional>
#include <string>
#include <string_view>

namespace lgs::oracle {

/// Which edit it was, what is wrong, and what differs where. Whole lines.
std::string describe(const Mismatch& mismatch, const Trace& trace);

/// What an engine did that gave no answer: "the engine crashed with SIGSEGV after edit 3", and the end of its log.
/// Whole lines.
std::string inWords(const Failure& failure, std::string_view when = "");

/// What was compared, where nothing was wrong. A whole line.
std::string inWords(const CheckStats& stats);

/// What stands at the end of a trace. A whole line.
std::string inWords(const Trace& trace, const World& world, const Outline& outline);

/// What shows a finding: an SVG picture, and a page for a browser.
struct Views {
  std::string picture;
  std::string page;
};

/// Both boundaries, the ghosts, the difference.
std::string draw(const Mismatch& mismatch);

/// A page that steps through the trace, for a browser; at the end both boundaries, and what differs in words.
std::string page(const Mismatch& mismatch, const Trace& trace);

/// The same for a trace that was found right.
std::string page(const Trace& trace, const std::string& title);

/// The world at the end of a trace as the naive reference sees it, edits that must be refused left out. The engine has
/// no part in it: for a trace that makes it crash.
std::string drawWithoutEngine(const Trace& trace, const std::string& title);
std::string pageWithoutEngine(const Trace& trace, const std::string& title);

/// The trace as text, with a comment of one or more lines after its first.
std::string printTrace(const Trace& trace, std::string_view comment);

/// The address that opens a trace in the sandbox, for a copy that is served at `site`. Empty, if there is no site, or if
/// the trace is longer than addresses should be.
std::string linkTo(const std::string& site, const Trace& trace);

/// The first mismatch, if there is one; none if an edit is bad.
std::optional<Mismatch> findMismatch(const Trace& trace, const CheckOptions& options);

}  // namespace lgs::oracle
