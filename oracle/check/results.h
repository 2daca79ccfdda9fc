// What a survey has come to, for programs of others to read.
#pragma once

#include "oracle/check/survey.h"

#include <string>
#include <vector>

namespace lgs::oracle {

struct Results {
  std::string engine;
  const Survey& survey;
  CheckStats stats;
  double seconds = 0;
  std::vector<KnownMismatch> gone;  ///< what was known, and is not there any more

  bool areFine() const { return survey.faults().empty() && gone.empty(); }
};

/// {"engine", "fine", "edits", "commits", "seconds", "kinds": [{"kind", "count", "only counted", "findings": [{"state":
/// "fault", "known" or "advice", "edits", "trace", "text"}]}], "gone": [{"kind", "trace"}]}
std::string asJson(const Results& results);

/// A suite of JUnit: a case for each finding, which has failed if it is a fault, and else is skipped; one for each known
/// mismatch that is gone, which has failed; and one for the run.
std::string asJUnit(const Results& results);

}  // namespace lgs::oracle
