// What stands in which cell, by name: the naive ground. It knows nothing of segments.
#pragma once

#include "oracle/calls/call.h"

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

class Standing {
 public:
  struct Placed {
    std::string name;
    Block block = 0;
    LocalPolygon vertices;
    PolygonHandle handle{};  ///< that the engine gave it; null if nobody asked
  };

  void add(const std::string& name, ScenePolygon polygon, PolygonHandle handle = {});  ///< of a name that is free
  void remove(const std::string& name);                                                ///< of a name alive
  void recolour(const std::string& name, Block block);                                 ///< of a name alive
  std::vector<Placed> take(Cell cell);                                                 ///< all that stands in a cell

  /// Why a good shape must be refused in this cell; nothing if it must be accepted.
  std::optional<ErrorCode> refusalIn(Cell cell, std::span<const LocalPolygon> shape) const;

  const std::vector<Placed>& in(Cell cell) const;  ///< what stands in a cell, in order of adding
  const std::map<Cell, std::vector<Placed>>& cells() const { return cells_; }  ///< those that are not empty
  std::size_t polygonsIn(const CellRect& cells) const;
  std::vector<ScenePolygon> polygonsOfAll() const;
  ScenePolygon operator[](const std::string& name) const;                                ///< of a name alive
  PolygonHandle handleOf(const std::string& name) const { return placed(name).handle; }  ///< of a name alive
  const std::string* nameOf(PolygonHandle handle) const;  ///< null, if it is no handle of what stands
  Standing part(const std::set<Cell>& cells) const;       ///< what stands in these, and nothing else
  bool isAlive(const std::string& name) const { return cellOf_.contains(name); }
  Cell cellOf(const std::string& name) const { return cellOf_.at(name); }  ///< of a name alive
  std::size_t polygons() const { return cellOf_.size(); }

 private:
  const Placed& placed(const std::string& name) const;

  std::map<Cell, std::vector<Placed>> cells_;
  std::unordered_map<std::string, Cell> cellOf_;
  std::map<PolygonHandle, std::string> names_;  // of those that the engine gave a handle
};

/// Why shape() must refuse a set of polygons; nothing if it is good.
std::optional<ErrorCode> faultOf(std::span<const LocalPolygon> shape);

}  // namespace lgs::oracle
