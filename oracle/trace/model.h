// The naive world: it knows by name what stands in which cell, and says whether an edit is good. It knows the rules of
// edits and the limits of <lgs/world.h>, and nothing of segments.
//
// No trace can reach two of the limits: 2^28 polygons placed in one cell, and 2^23 contents. An engine that refuses an
// edit for one of them is wrong.
#pragma once

#include "oracle/reference/validity.h"
#include "oracle/trace/trace.h"

#include <lgs/error.h>
#include <lgs/ids.h>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace lgs::oracle {

/// What an edit, or a call, must be refused for; nothing if it must be accepted.
struct Verdict {
  bool accepted = true;
  std::optional<ErrorCode> code = {};  ///< none if the name is to blame
  Cell cell = Error::kNoCell;          ///< the one that the refusal must name
  int index = -1;                      ///< the entry to blame, of a call that takes many
};

class Model {
 public:
  struct Placed {
    std::string name;
    Block block = 0;
    LocalPolygon vertices;
    PolygonHandle handle{};  ///< that the engine gave it; null if nobody asked
  };

  Verdict judge(const Edit& edit) const;

  /// Why a good shape must be refused in this cell; nothing if it must be accepted.
  std::optional<ErrorCode> refusalIn(Cell cell, std::span<const LocalPolygon> shape) const;

  /// The edit must be one that is accepted. A commit does nothing, and neither does a brush: what it did is made as
  /// removes and adds (brushing.h).
  void apply(const Edit& edit, PolygonHandle handle = {});

  const std::vector<Placed>& in(Cell cell) const;  ///< what stands in a cell, in order of adding
  const std::map<Cell, std::vector<Placed>>& cells() const { return cells_; }  ///< those that are not empty
  std::size_t polygonsIn(const CellRect& cells) const;
  Scene scene(PreservePairs preserve) const;                                             ///< of all that stands
  ScenePolygon operator[](const std::string& name) const;                                ///< of a name alive
  PolygonHandle handleOf(const std::string& name) const { return placed(name).handle; }  ///< of a name alive
  const std::string* nameOf(PolygonHandle handle) const;  ///< null, if it is no handle of what stands
  Model part(const std::set<Cell>& cells) const;          ///< what stands in these, and nothing else
  bool isAlive(const std::string& name) const { return cellOf_.contains(name); }
  Cell cellOf(const std::string& name) const { return cellOf_.at(name); }  ///< of a name alive
  std::size_t polygons() const { return cellOf_.size(); }
  std::size_t chunks() const { return chunks_.size(); }  ///< of 32×32 cells, ever edited

 private:
  const Placed& placed(const std::string& name) const;

  std::map<Cell, std::vector<Placed>> cells_;
  std::unordered_map<std::string, Cell> cellOf_;
  std::map<PolygonHandle, std::string> names_;  // of those that the engine gave a handle
  std::set<Cell> chunks_;
};

/// Why shape() must refuse a set of polygons; nothing if it is good.
std::optional<ErrorCode> faultOf(std::span<const LocalPolygon> shape);

/// The trace without the edits that must be refused: what `lgs replay` takes.
Trace withoutRefused(const Trace& trace);

}  // namespace lgs::oracle
