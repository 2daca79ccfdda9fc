// What a person gets to see of a mismatch: what differs, the smallest trace that shows it, a picture, and how to see it
// again.
#pragma once

#include "oracle/check/failure.h"
#include "oracle/cli/command.h"

#include <chrono>
#include <string>

namespace lgs::oracle {

struct ReportOptions {
  std::string folder = ".";  ///< where trace and picture go
  std::string name;          ///< of these files, without folder and extension
  std::string reproduce;     ///< the command that finds the mismatch again
  std::chrono::milliseconds shrinkFor{};
};

/// Shrinks the trace, prints all of it, saves trace and picture. `options` are those that found the mismatch.
Status reportMismatch(const Mismatch& found, const Trace& trace, const CheckOptions& options,
                      const ReportOptions& report);

/// The same for a trace that makes the engine crash or hang: `how` says which, as crashOf() does.
Status reportCrash(const std::string& how, const Trace& trace, const CheckOptions& options,
                   const ReportOptions& report);

}  // namespace lgs::oracle
