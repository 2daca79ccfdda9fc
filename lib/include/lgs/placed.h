// Polygons in cells: as they stand there, as they shall be placed, and as a commit changed them.
#pragma once

#include <lgs/ids.h>
#include <lgs/lattice.h>

#include <span>

namespace lgs {

/// A polygon as it stands in a cell. `vertices` is valid until the next edit of the world: copy them first if you
/// remove a polygon to put it back later.
struct PlacedPolygon {
  PolygonHandle handle;                  ///< its name
  Block block = 0;                       ///< the number that it was given
  std::span<const LocalPoint> vertices;  ///< counter-clockwise, in its cell
};

/// A shape and where it shall be: for World::addMany().
struct Placement {
  Cell cell;        ///< where
  ShapeId shape;    ///< what
  Block block = 0;  ///< the number that all its polygons get
};

/// A polygon that shall be placed, by its vertices: for World::exchange().
struct NewPolygon {
  std::span<const LocalPoint> vertices;  ///< counter-clockwise, in its cell
  Block block = 0;                       ///< the number that it gets
};

/// A cell that a commit or a roll-back changed, and what it held: for World::cellChanges(). The polygons are by handle.
/// The handles in `before` name nothing any more, if their polygons are gone.
struct CellChange {
  Cell cell;                              ///< where
  std::span<const PlacedPolygon> before;  ///< as of the commit or roll-back before
  std::span<const PlacedPolygon> now;     ///< as of this one
};

}  // namespace lgs
