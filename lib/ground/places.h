// What the ground answers about its polygons and about places. Nothing here changes it.
#pragma once

#include "ground/ground.h"

#include <lgs/world.h>

#include <optional>
#include <vector>

namespace lgs::detail {

/// By handle. Valid until the next edit.
void polygonsOf(const Ground& ground, Cell cell, std::vector<PlacedPolygon>& out);
Expected<PlacedPolygon> polygonOf(const Ground& ground, PolygonHandle handle);
void forEachPolygon(const Ground& ground, const CellRect& cells, const World::PolygonVisitor& visit);
std::optional<CellRect> boundsOf(const Ground& ground);
Spot spotAt(const Ground& ground, Point p);
/// Whether every polygon of the other is here too.
bool holdsPolygonsOf(const Ground& ground, const Ground& other);
/// Adds polygons, cells, shapes, contents, chunks and bytes.
void count(const Ground& ground, Stats& stats);

}  // namespace lgs::detail
