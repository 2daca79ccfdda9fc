// What a person gets to see of a mismatch: what differs, the smallest trace that shows it, a picture, and how to see it
// again. For the lgs command and the fuzzers.
#pragma once

#include "oracle/check/failure.h"

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace lgs::oracle {

struct ReportOptions {
  std::string folder = ".";  ///< where trace, picture and page go
  std::string name;          ///< of these files, without folder and extension
  std::string reproduce;     ///< the command that finds the mismatch again, from any folder
  std::chrono::milliseconds shrinkFor{};
  std::string lgs = "lgs";  ///< the lgs command, as a shell takes it
  std::string engine = {};  ///< the options that name the engine, with a blank before; empty for this library's
  bool views = false;       ///< views followed the world
  std::string site = {};    ///< where a copy of the sandbox is served, if anywhere
};

/// Where a trace goes, without its ending: nothing that an earlier run found is replaced, but by the same.
std::string freePlace(const std::string& first, const std::string& text);

/// Writes a file; complains on the standard error if that does not work. Whether it did.
bool writeOrComplain(const std::string& path, std::string_view content);

/// Finds a mismatch of the same kind in another trace; nothing if it is not there, or the trace is bad.
using FindAgain = std::function<std::optional<Mismatch>(const Trace&)>;

/// Does so by a check with these options. A trace that the engine can not have is a bad one.
FindAgain sameKind(Mismatch::Kind kind, const CheckOptions& options);

/// Shrinks with an engine that lives on from trial to trial. What is left must fail in a new one; if it does not, the
/// engine keeps something over a reset, and each trial gets a new one. A hang is shrunk in haste, for three time-outs at
/// most; where what is left is only slow, what was undone again is left out alone.
Trace shrinkWithEngine(const Mismatch& found, const Trace& trace, Engine& engine, const FindAgain& findAgain,
                       std::chrono::milliseconds budget);

/// The trace up to where the mismatch was found: to tell it by, when it is not found again.
Trace untilFound(Trace trace, const Mismatch& found);

/// A trace without the calls from which the engine crashes or hangs, and all that follows them, unless all are plain: a
/// picture needs to know what the others do.
Trace beforeCrash(Trace trace);

/// Shrinks the trace, prints all of it, saves trace, picture and page.
void reportMismatch(const Mismatch& found, const Trace& trace, const FindAgain& findAgain, const ReportOptions& report);

/// The same for a mismatch that checkTrace() found with these options.
void reportMismatch(const Mismatch& found, const Trace& trace, const CheckOptions& options,
                    const ReportOptions& report);

/// The same for a trace that makes this library's engine crash or hang: `how` says which, as crashOf() does.
void reportCrash(const std::string& how, const Trace& trace, const CheckOptions& options, const ReportOptions& report);

}  // namespace lgs::oracle
