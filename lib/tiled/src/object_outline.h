// From a collision object to an outline in pixels: first on the tile's image, then in the cell, where Tiled draws it.
#pragma once

#include "tileset.h"

namespace lgs::tiled {

/// The outline of an object, in pixels from the upper left corner of its tile's image, y down. It may run either way
/// round, and is empty for Kind::unsupported.
std::vector<DoublePoint> outline(const CollisionObject& object);

/// How a tile is flipped. The diagonal flip comes first: x and y change places.
struct Flips {
  bool horizontal = false;
  bool vertical = false;
  bool diagonal = false;
};

/// How the image of a tile lies on its cell. Their lower left corners coincide, before the shift.
struct ImageFrame {
  DoublePoint image;  ///< size in pixels, before the flips
  Flips flips;
  DoublePoint scale{1, 1};
  DoublePoint shift;  ///< pixels, y down: the tileset's offset, and what is no whole tile of the layer's offset

  /// Takes a place in pixels from the image's upper left corner, y down, to pixels from the cell's lower left corner, y
  /// up.
  DoublePoint toCell(DoublePoint p) const;
};

}  // namespace lgs::tiled
