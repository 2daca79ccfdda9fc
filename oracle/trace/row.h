// A trace as calls. A *row* is the edits that one call of the engine makes, as their lines say (way.h); an edit whose
// line says nothing is a row of its own. A row that its door can not make comes apart: a fill of cells that are no
// rectangle, for instance, which is what is left where a trace was made shorter. So is one with a bad name.
//
// If a call of several edits must be refused, it is tried, and then its edits come one by one.
#pragma once

#include "oracle/trace/call_model.h"
#include "oracle/trace/trace.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lgs::oracle {

struct Row {
  std::span<const Edit> edits;  ///< removes, then adds; a commit or a brush stands alone
  Way way;
  Call call;                       ///< what makes them, with the handles of what stands; none of a brush
  Verdict verdict;                 ///< what must come of it
  std::vector<Cell> cells;         ///< where they are, if names are good
  std::vector<std::string> names;  ///< of what comes, in the order of the handles
  std::size_t end = 0;             ///< the number of edits up to its last one
  bool isTrial = false;            ///< the call must be refused; then its edits come again, one by one

  bool isCommit() const { return edits.front().kind == Edit::Kind::commit; }
};

/// "fill of 'p1' to 'p6'".
std::string inWords(const Row& row);

/// An edit by itself.
Row rowOf(const Edit& edit, const CallModel& standing);

class Rows {
 public:
  /// The trace must stay as it is.
  explicit Rows(const Trace& trace) : edits_(trace.edits) {}

  /// The next row, to be made where this stands; nothing at the end of the trace.
  std::optional<Row> next(const CallModel& standing);

 private:
  std::span<const Edit> edits_;  // of the trace
  std::size_t at_ = 0;           // the next one
  std::size_t oneByOne_ = 0;     // the edits before this one were tried together
};

}  // namespace lgs::oracle
