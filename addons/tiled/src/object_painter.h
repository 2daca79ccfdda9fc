// A world in which the objects of object layers are painted, each with a brush. So an object may have any size, and
// what comes later loses what is covered already.
#pragma once

#include "budget.h"
#include "map_objects.h"
#include "pixel_grid.h"
#include "placer.h"

#include <lgs/world.h>

namespace lgs::tiled {

class ObjectPainter {
 public:
  explicit ObjectPainter(Budget& budget) : budget_(budget) {}

  /// Paints a shape of a layer. What happens to it becomes a note of the layer. False if it would cost more than the
  /// budget has.
  [[nodiscard]] bool paint(const MapShape& shape, const PixelGrid& grid, const Placer::Entry& entry,
                           LayerReport& report);

  /// Visits what was painted: a polygon in a cell, and the entry of its shape.
  using Visitor = std::function<void(Cell, const Polygon&, const Placer::Entry&)>;
  void visit(const Visitor& visitor) const;

 private:
  Budget& budget_;
  World world_;  // its blocks are indices in entries_: so polygons of two shapes are never united
  std::vector<Placer::Entry> entries_;
};

}  // namespace lgs::tiled
