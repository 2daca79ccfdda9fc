// From a collision object to pixels in its cell: the shape's outline, and where Tiled draws it.
#pragma once

#include "tileset.h"

namespace lgs::tiled {

/// The outline of an object in pixels from the upper left corner of its tile's image, y down. In either orientation;
/// empty for Kind::unsupported.
std::vector<DoublePoint> outline(const CollisionObject& object);

/// Tiled's flags for a flipped tile: first the diagonal flip (x and y change places), then the others.
struct Flips {
  bool horizontal = false;
  bool vertical = false;
  bool diagonal = false;
};

/// Where a tile's image stands in relation to its cell.
struct Frame {
  DoublePoint image;  ///< the size of the image, before flips
  Flips flips;
  DoublePoint scale{1, 1};
  DoublePoint shift;  ///< pixels, y down: the tileset's offset and what the layer's offset leaves over

  /// From the image's upper left corner, y down, to the cell's lower left corner, y up; in pixels.
  DoublePoint toCell(DoublePoint p) const;
};

}  // namespace lgs::tiled
