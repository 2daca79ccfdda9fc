// A shape as a file has it: of a tile, or of an object layer. Object templates are files (TX) that hold one object
// each, which others fill up.
#pragma once

#include "words.h"

#include <functional>
#include <memory>

namespace lgs::tiled {

struct Template {
  Template(const XmlFile& by, const std::string& named) : file(by, named, "template", error) {}

  std::optional<ImportError> error;  ///< why it or its tileset can not be read; this does not spoil the map
  XmlFile file;
};

/// The templates of a map, each read once, by path.
using Templates = std::map<std::string, std::unique_ptr<Template>>;

/// A shape in pixels, y down: from the upper left corner of a tile's image, or of the map.
struct CollisionObject : Called {
  enum class Kind : std::uint8_t { rectangle, polygon, polyline, ellipse, capsule, tile, unsupported };
  std::uint32_t id = 0;
  Kind kind = Kind::rectangle;
  std::string unsupported;  ///< the reason, for Kind::unsupported
  DoublePoint at;
  DoublePoint size;
  double rotation = 0;              ///< degrees, clockwise, around `at`
  std::vector<DoublePoint> points;  ///< of a polygon or an open polyline, relative to `at`
  std::uint32_t gid = 0;            ///< for Kind::tile, with the flags for flipping
  Template* gidFrom = nullptr;      ///< the template whose tileset the gid is of; null: it is of the map's
  bool hidden = false;
  double thickness = 0;  ///< pixels, of an open polyline
};

/// How the reason begins why an open polyline is left out.
inline constexpr std::string_view kNoArea = "an open polyline has no area";

/// Whether a polyline does not end where it began; otherwise it is a polygon.
bool isOpen(const std::vector<DoublePoint>& points);

/// Reads an <object>, with what its template says. The offset is that of its <objectgroup>.
CollisionObject readObject(const XmlFile& file, pugi::xml_node node, DoublePoint offset, Templates& templates);

/// Makes it Kind::unsupported, with the reason.
void leaveOut(CollisionObject& object, std::string reason);

/// Whether Options::leaveOut has the class or name of something, or a property.
bool isLeftOut(const Called& called, const Options& options);

/// The object as the options want it: if names say what its block is, its class is its name. One that is hidden may be
/// left out. An open polyline is left out as well, or gets its thickness. What is left out is of Kind::unsupported, with
/// the reason.
CollisionObject asAsked(CollisionObject object, const Options& options);

using Outline = std::vector<DoublePoint>;

/// The outline of an object; of an open polyline one for each segment. `place` takes its points from pixels, y down, to
/// where they should be. They may run either way round. There are none for Kind::tile and Kind::unsupported.
std::vector<Outline> outlines(const CollisionObject& object, const std::function<DoublePoint(DoublePoint)>& place);

/// A point turned around the origin by an angle in degrees, clockwise where y points down. Quarter turns are exact.
DoublePoint turned(DoublePoint p, double degrees);

/// A number in a layer, or of a tile object, without the flags that say how the tile is flipped.
std::uint32_t tileNumber(std::uint32_t gid);

/// How the image of a tile lies on its cell. Their lower left corners coincide, before the shift.
struct ImageFrame {
  DoublePoint image;      ///< size in pixels, before the flips
  std::uint32_t gid = 0;  ///< with the flags for flipping; the diagonal flip comes first: x and y change places
  DoublePoint scale{1, 1};
  DoublePoint shift;  ///< pixels, y down: the tileset's offset, and what is no whole tile of the layer's offset

  /// Takes a place in pixels from the image's upper left corner, y down, to pixels from the cell's lower left corner, y
  /// up.
  DoublePoint toCell(DoublePoint p) const;

  /// Scales the image to a size, which is measured after the flips.
  void scaleTo(DoublePoint size);
};

}  // namespace lgs::tiled
