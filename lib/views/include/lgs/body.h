// Bodies: polygons that have left the ground of a world, or never were in it, with what a physics engine needs.
#pragma once

#include <lgs/world.h>

#include <vector>

namespace lgs {

/// A polygon of a body.
struct BodyPolygon {
  Cell cell;                         ///< counted from the body's origin
  Block block = 0;                   ///< as it was in the ground
  std::vector<LocalPoint> vertices;  ///< in its cell
  friend bool operator==(const BodyPolygon&, const BodyPolygon&) = default;
};

/// What a set of polygons weighs where each square unit weighs one. The sums are exact; each number is rounded once.
struct MassOfPolygons {
  double area = 0;          ///< in square cells
  DoublePoint centroid{};   ///< in cells, from the lower-left corner of the body's origin cell
  double secondMoment = 0;  ///< of area, about the centroid, in cells to the power of 4: times density it is inertia
};

/// Ground that has left the world. Its origin is the lower-left corner of a cell: where that cell lies in the world,
/// the body lies as it lay in the ground.
struct Body {
  Cell origin;                        ///< where it was: the lower-left cell of its box
  CellRect cells;                     ///< its box, in the world
  std::vector<BodyPolygon> polygons;  ///< by cell (j, then i) and handle
  MassOfPolygons mass;                ///< of all of them
};

/// The same for some polygons alone, say those of one material. A polygon that is clockwise, or has a vertex outside of
/// its cell or more than kMaxVerticesPerCell, counts as nothing: no world hands out such. Cost: in proportion to their
/// vertices.
MassOfPolygons massOf(const std::vector<BodyPolygon>& polygons) noexcept;

/// Sets a body into the ground, so that its origin is this cell. Its polygons keep their blocks; their handles are new,
/// and are returned in the same order. All of it happens as one edit, or nothing. Refused: as by World::add(), for the
/// first polygon that does not fit: Error::index names which.
[[nodiscard]] Expected<std::vector<PolygonHandle>> put(World& world, const Body& body, Cell cell) noexcept;

}  // namespace lgs
