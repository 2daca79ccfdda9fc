#include "area_by_block.h"

#include <cstddef>

namespace examples {
namespace {

/// By the shoelace formula: twice the area in square units. At most 2^33, and each product is.
std::int64_t halfUnitsOf(std::span<const lgs::LocalPoint> polygon) {
  std::int64_t sum = 0;
  lgs::LocalPoint a = polygon.back();
  for (const lgs::LocalPoint b : polygon) {
    sum += std::int64_t{a.x} * b.y - std::int64_t{b.x} * a.y;
    a = b;
  }
  return sum;
}

}  // namespace

void Area::add(std::int64_t more) {
  halfUnits += more;
  while (halfUnits < 0) {
    halfUnits += kCell;
    --cells;
  }
  while (halfUnits >= kCell) {
    halfUnits -= kCell;
    ++cells;
  }
}

AreaByBlock::AreaByBlock(const lgs::World& world) {
  world.forEachPolygon([this](lgs::Cell, const lgs::PlacedPolygon& polygon) { add(polygon, 1); });
}

void AreaByBlock::update(std::span<const lgs::CellChange> changes) {
  for (const lgs::CellChange& change : changes) {
    for (const lgs::PlacedPolygon& polygon : change.before) add(polygon, -1);
    for (const lgs::PlacedPolygon& polygon : change.now) add(polygon, 1);
  }
}

void AreaByBlock::add(const lgs::PlacedPolygon& polygon, int sign) {
  Area& area = areas_[polygon.block];
  area.add(sign * halfUnitsOf(polygon.vertices));
  if (area == Area{}) areas_.erase(polygon.block);
}

}  // namespace examples
