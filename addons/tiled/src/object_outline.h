// From a collision object to an outline in pixels: first on the tile's image, then in the cell, where Tiled draws it.
#pragma once

#include "collision_object.h"

namespace lgs::tiled {

/// The outline of an object, in pixels from where it is measured, y down. It may run either way round. It is empty for
/// Kind::polyline, Kind::tile and Kind::unsupported.
std::vector<DoublePoint> outline(const CollisionObject& object);

/// A point turned around the origin by an angle in degrees, clockwise where y points down. Quarter turns are exact.
DoublePoint turned(DoublePoint p, double degrees);

/// How a tile is flipped. The diagonal flip comes first: x and y change places.
struct Flips {
  bool horizontal = false;
  bool vertical = false;
  bool diagonal = false;
};

/// A number in a layer, or of a tile object: the tile's without the flags, and what the flags say.
std::uint32_t tileNumber(std::uint32_t gid);
Flips flipsOf(std::uint32_t gid);

/// How the image of a tile lies on its cell. Their lower left corners coincide, before the shift.
struct ImageFrame {
  DoublePoint image;  ///< size in pixels, before the flips
  Flips flips;
  DoublePoint scale{1, 1};
  DoublePoint shift;  ///< pixels, y down: the tileset's offset, and what is no whole tile of the layer's offset

  /// Takes a place in pixels from the image's upper left corner, y down, to pixels from the cell's lower left corner, y
  /// up.
  DoublePoint toCell(DoublePoint p) const;

  /// Scales the image to a size, which is measured after the flips.
  void scaleTo(DoublePoint size);
};

}  // namespace lgs::tiled
