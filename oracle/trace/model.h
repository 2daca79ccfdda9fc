// The naive world: what stands in which cell, by name, and whether an edit is good. It knows the rules of edits and
// nothing of segments.
#pragma once

#include "oracle/reference/validity.h"
#include "oracle/trace/trace.h"

#include <lgs/ids.h>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

namespace lgs::oracle {

class Model {
 public:
  struct Placed {
    std::string name;
    Block block = 0;
    LocalPolygon vertices;
  };

  /// What an edit must be refused for; nothing if it must be accepted.
  struct Verdict {
    bool accepted = true;
    std::optional<ErrorCode> code = {};  ///< none where the name is to blame
  };
  Verdict judge(const Edit& edit) const;

  void apply(const Edit& edit);  ///< one that is accepted; a commit does nothing

  const std::vector<Placed>& in(Cell cell) const;  ///< what stands in a cell, in order of adding
  const std::map<Cell, std::vector<Placed>>& cells() const { return cells_; }  ///< those that are not empty
  bool isAlive(const std::string& name) const { return cellOf_.contains(name); }
  Cell cellOf(const std::string& name) const { return cellOf_.at(name); }  ///< of a name alive
  std::size_t polygons() const { return cellOf_.size(); }

 private:
  std::map<Cell, std::vector<Placed>> cells_;
  std::unordered_map<std::string, Cell> cellOf_;
};

/// The trace without the edits that must be refused: what `lgs replay` takes.
Trace withoutRefused(const Trace& trace);

}  // namespace lgs::oracle
