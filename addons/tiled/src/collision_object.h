// A shape as a file has it: of a tile, or of an object layer.
#pragma once

#include "properties.h"
#include "templates.h"

namespace lgs::tiled {

/// A shape in pixels, y down: from the upper left corner of a tile's image, or of the map.
struct CollisionObject {
  enum class Kind : std::uint8_t { rectangle, polygon, polyline, ellipse, capsule, tile, unsupported };
  std::uint32_t id = 0;
  Kind kind = Kind::rectangle;
  std::string unsupported;  ///< the reason, for Kind::unsupported
  std::string className;
  std::string name;
  Properties properties;
  DoublePoint at;
  DoublePoint size;
  double rotation = 0;              ///< degrees, clockwise, around `at`
  std::vector<DoublePoint> points;  ///< of a polygon or an open polyline, relative to `at`
  std::uint32_t gid = 0;            ///< for Kind::tile, with the flags for flipping
  Template* gidFrom = nullptr;      ///< the template whose tileset the gid is of; null: it is of the map's
  bool hidden = false;
  bool oneWay = false;   ///< something says so, be it of the object or of what it belongs to
  double thickness = 0;  ///< pixels, of a polygon that was an open polyline
};

/// Reads an <object>, with what its template says. The offset is that of its <objectgroup>.
CollisionObject readObject(const XmlFile& file, pugi::xml_node node, DoublePoint offset, Templates& templates);

/// Whether Options::leaveOut has what has this class or name and these properties.
bool isLeftOut(const Options& options, const std::string& className, const std::string& name,
               const Properties& properties);

/// The object as the options want it: if names say what its block is, its class is its name. One that is hidden may be
/// left out. An open polyline is left out as well, or becomes a thin polygon. What is left out is of Kind::unsupported,
/// with the reason.
CollisionObject asAsked(CollisionObject object, const Options& options);

}  // namespace lgs::tiled
