// A shape as a file has it: of a tile, or of an object layer.
#pragma once

#include "templates.h"

namespace lgs::tiled {

/// A shape in pixels, y down: from the upper left corner of a tile's image, or of the map.
struct CollisionObject {
  enum class Kind : std::uint8_t { rectangle, polygon, ellipse, capsule, tile, unsupported };
  std::uint32_t id = 0;
  Kind kind = Kind::rectangle;
  std::string unsupported;  ///< the reason, for Kind::unsupported
  std::string className;
  DoublePoint at;
  DoublePoint size;
  double rotation = 0;              ///< degrees, clockwise, around `at`
  std::vector<DoublePoint> points;  ///< of a polygon, relative to `at`
  std::uint32_t gid = 0;            ///< for Kind::tile, with the flags for flipping
  Template* gidFrom = nullptr;      ///< the template whose tileset the gid is of; null: it is of the map's
};

/// Reads an <object>, with what its template says. The offset is that of its <objectgroup>.
CollisionObject readObject(const XmlFile& file, pugi::xml_node node, DoublePoint offset, Templates& templates);

}  // namespace lgs::tiled
