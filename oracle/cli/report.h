// What a person gets to see of a mismatch: what differs, the smallest trace that shows it, a picture, and how to see it
// again.
#pragma once

#include "oracle/check/checker.h"
#include "oracle/cli/command.h"

#include <chrono>
#include <string>

namespace lgs::oracle {

/// Which edit it was, what is wrong, and what differs where. Whole lines.
std::string describe(const Mismatch& mismatch, const Trace& trace);

/// Both boundaries, the ghosts, the difference.
std::string draw(const Mismatch& mismatch);

struct ReportOptions {
  std::string folder = ".";  ///< where trace and picture go
  std::string name;          ///< of these files, without folder and extension
  std::string reproduce;     ///< the command that finds the mismatch again
  std::chrono::milliseconds shrinkFor{};
};

/// Shrinks the trace, prints all of it, saves trace and picture. `options` are those that found the mismatch.
Status reportMismatch(const Mismatch& found, const Trace& trace, const CheckOptions& options,
                      const ReportOptions& report);

}  // namespace lgs::oracle
