#include "object_painter.h"

#include "snapping_notes.h"

#include <lgs/brush.h>

#include <utility>

namespace lgs::tiled {
namespace {

/// How many cells the bounding box of a ring has.
std::size_t cellsOf(const Polygon& ring) {
  const Box box = boundingBox(ring);
  const auto along = [](std::int64_t min, std::int64_t max) {
    return static_cast<std::size_t>((max >> kCellBits) - (min >> kCellBits) + 1);
  };
  return along(box.min.x, box.max.x) * along(box.min.y, box.max.y);
}

}  // namespace

bool ObjectPainter::paint(const MapShape& shape, const PixelGrid& grid, const Placer::Entry& entry,
                          LayerReport& report) {
  const auto leaveOut = [&](std::string why) {
    report.notes.push_back({NoteKind::leftOut, shape.object.id, 0, 0, {}, std::move(why)});
    return true;
  };
  if (shape.object.kind == CollisionObject::Kind::unsupported) return leaveOut(shape.object.unsupported);
  constexpr double kMost = 1 << 28;  // cells from the map's corner; below kMaxCell
  Snapped snapped = snap(shape.outline, grid, kMost);
  if (snapped.tooFar) return leaveOut("it is too far away");
  noteSnapping(shape.object, snapped, report.notes);
  if (tidyLoops(snapped.ring).empty()) return leaveOut("it has no area once it is on the grid");
  const Box box = boundingBox(snapped.ring);
  constexpr std::int64_t kExtent = kMaxRegionCells * kUnitsPerCell;
  if (box.max.x - box.min.x > kExtent || box.max.y - box.min.y > kExtent) {
    return leaveOut("it is more than " + std::to_string(kMaxRegionCells) + " cells wide or high");
  }
  const std::size_t cells = cellsOf(snapped.ring);
  if (cells > cellsLeft_) return false;
  cellsLeft_ -= cells;
  const auto number = static_cast<Block>(entries_.size());
  entries_.push_back(entry);
  const auto painted = lgs::paint(world_, {{std::move(snapped.ring)}, FillRule::evenOdd}, number, PaintMode::fill);
  if (!painted) return leaveOut("a cell holds as many polygons or vertices as it can");
  if (painted->came.empty()) {
    report.notes.push_back({NoteKind::trimmed, shape.object.id, 0, 0, {}, "objects before it cover all of it"});
  }
  return true;
}

void ObjectPainter::visit(const Visitor& visitor) const {
  world_.forEachPolygon([&](Cell cell, const PlacedPolygon& polygon) {
    Polygon ring;
    for (const LocalPoint v : polygon.vertices) ring.push_back({v.x, v.y});
    visitor(cell, std::move(ring), entries_[polygon.block]);
  });
}

}  // namespace lgs::tiled
