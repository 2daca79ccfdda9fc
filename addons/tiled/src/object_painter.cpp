#include "object_painter.h"

#include "snapping_notes.h"

#include <lgs/brush.h>

#include <utility>

namespace lgs::tiled {
bool ObjectPainter::paint(const MapShape& shape, const PixelGrid& grid, const Placer::Entry& entry,
                          LayerReport& report) {
  const auto leaveOut = [&](std::string why) {
    report.notes.push_back({NoteKind::leftOut, shape.object.id, 0, 0, {}, std::move(why)});
    return true;
  };
  if (shape.object.kind == CollisionObject::Kind::unsupported) return leaveOut(shape.object.unsupported);
  if (!budget_.shape(shape.outline.size())) return false;
  constexpr double kMost = 1 << 28;  // cells from the map's corner; below kMaxCell
  Snapped snapped = snap(shape.outline, grid, kMost);
  if (snapped.tooFar) return leaveOut("it is too far away");
  const Box box = boundingBox(snapped.ring);
  constexpr std::int64_t kExtent = kMaxRegionCells * kUnitsPerCell;
  if (box.max.x - box.min.x > kExtent || box.max.y - box.min.y > kExtent) {
    return leaveOut("it is more than " + std::to_string(kMaxRegionCells) + " cells wide or high");
  }
  takeBackCollapse(snapped);
  noteSnapping(shape.object, snapped, report.notes);
  if (isTangled(snapped.ring)) return leaveOut("its outline crosses itself more than 1024 times");
  if (tidyLoops(snapped.ring).empty()) return leaveOut("it has no area once it is on the grid");
  if (!budget_.stroke(snapped.ring, &world_)) return false;
  const auto number = static_cast<Block>(entries_.size());
  entries_.push_back(entry);
  const Region region{{std::move(snapped.ring)}, FillRule::evenOdd};
  const auto painted = lgs::paint(world_, region, number, PaintMode::fill);
  if (!painted) return leaveOut("a cell holds as many polygons or vertices as it can");
  if (painted->came.empty()) {
    World empty;
    const auto alone = lgs::paint(empty, region, number, PaintMode::fill);
    if (alone && alone->came.empty())
      return leaveOut("it has no area: what its outline goes around twice is not solid");
    report.notes.push_back({NoteKind::trimmed, shape.object.id, 0, 0, {}, "objects before it cover all of it"});
  }
  return true;
}

void ObjectPainter::visit(const Visitor& visitor) const {
  Polygon ring;
  world_.forEachPolygon([&](Cell cell, const PlacedPolygon& polygon) {
    ring.clear();
    for (const LocalPoint v : polygon.vertices) ring.push_back({v.x, v.y});
    visitor(cell, ring, entries_[polygon.block]);
  });
}

}  // namespace lgs::tiled
