// Law 2 at a vertex on the rims of cells, by all half-edges around it: at the vertices between the corners; and at the
// corners, if something is preserved.
#pragma once

#include "fan.h"
#include "links.h"
#include "world_impl.h"

#include <array>

namespace lgs::detail {

class Rim {
 public:
  /// `fan` is working memory.
  Rim(World::Impl& world, Links& links, std::vector<Spoke>& fan);

  /// Links at all vertices in the open side of a cell.
  void linkSide(CellAt at, unsigned side);
  /// Links at the vertex that is corner q to the cell of quadrant q. A cell without segments has no record.
  void linkCorner(const std::array<const CellRecord*, 4>& quadrants);

 private:
  void match(std::span<const Spoke> fan);

  World::Impl& world_;
  Links& links_;
  std::vector<Spoke>& fan_;
};

}  // namespace lgs::detail
