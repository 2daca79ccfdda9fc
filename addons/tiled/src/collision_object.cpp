#include "collision_object.h"

#include "json.h"
#include "words.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace lgs::tiled {
namespace {

using Kind = CollisionObject::Kind;

constexpr std::int64_t kMostId = 0xFFFF'FFFF;
constexpr std::uint32_t kHorizontal = 0x8000'0000, kVertical = 0x4000'0000, kDiagonal = 0x2000'0000;  // flips

/// Reads the vertices of a polygon, or of a polyline.
void readPoints(const XmlFile& file, pugi::xml_node node, bool closed, CollisionObject& object) {
  std::vector<DoublePoint>& points = object.points;
  points = file.points(node, "points");
  object.kind = !closed && isOpen(points) ? Kind::polyline : Kind::polygon;
  if (!closed && object.kind == Kind::polygon) points.pop_back();
  if (object.kind == Kind::polygon && points.size() < 3)
    return leaveOut(object, "the polygon has fewer than 3 vertices");
  if (points.size() > kMaxObjectVertices) return leaveOut(object, "the polygon has more than 1024 vertices");
}

/// Reads the kind of an object, and for Kind::unsupported the reason.
void readKind(const XmlFile& file, pugi::xml_node node, CollisionObject& object) {
  if (node.child("point")) return leaveOut(object, "a point has no area");
  if (node.child("text")) return leaveOut(object, "a text is no shape");
  if (object.gid != 0) {
    object.kind = Kind::tile;
  } else if (const auto polygon = node.child("polygon")) {
    readPoints(file, polygon, true, object);
  } else if (const auto polyline = node.child("polyline")) {
    readPoints(file, polyline, false, object);
  } else {
    object.kind = node.child("ellipse") ? Kind::ellipse : node.child("capsule") ? Kind::capsule : Kind::rectangle;
    if (object.size.x <= 0 || object.size.y <= 0) leaveOut(object, "it has no area: its width or height is 0");
  }
}

/// An object of a template: what it says itself, and else what the template says.
void merge(pugi::xml_node instance, pugi::xml_node origin, pugi::xml_document& merged) {
  pugi::xml_node node = merged.append_copy(origin);
  for (const auto attribute : instance.attributes()) setAttribute(node, attribute.name(), attribute.value());
  for (const auto child : instance.children()) {
    if (std::string_view(child.name()) != "properties") node.remove_child(child.name());
    node.append_copy(child);
  }
}

CollisionObject readPlain(const XmlFile& file, pugi::xml_node node, DoublePoint offset) {
  CollisionObject object;
  static_cast<Called&>(object) = calledOf(node);
  object.id = static_cast<std::uint32_t>(file.integer(node, "id", 0, 0, kMostId));
  object.at = {file.real(node, "x") + offset.x, file.real(node, "y") + offset.y};
  object.size = {file.real(node, "width"), file.real(node, "height")};
  object.rotation = file.real(node, "rotation");
  object.gid = static_cast<std::uint32_t>(file.integer(node, "gid", 0, 0, kMostId));
  object.hidden = !node.attribute("visible").as_bool(true);
  readKind(file, node, object);
  return object;
}

/// Cosine and sine of an angle in degrees, exact for quarter turns, so that turned rectangles stay on the grid.
std::pair<double, double> turn(double degrees) {
  int quarters = 0;
  const double rest = std::remquo(degrees, 90.0, &quarters) / 180.0 * std::numbers::pi;
  std::pair result(std::cos(rest), std::sin(rest));
  for (quarters &= 3; quarters > 0; --quarters) result = {-result.second, result.first};
  return result;
}

/// A rounded box: quarter circles of kCurveVertices / 4 steps around the four corners of an inner box. If the inner box
/// is a point, the result is an ellipse; if it is a line, a capsule.
std::vector<DoublePoint> roundedBox(DoublePoint size, DoublePoint radius) {
  constexpr int kSteps = kCurveVertices / 4;
  std::vector<DoublePoint> points;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const bool isRight = quarter == 0 || quarter == 3, isLow = quarter < 2;
    for (int step = 0; step <= kSteps; ++step) {  // the ends of two quarters can coincide; tidied() drops one
      const auto [cosine, sine] = turn(90.0 * quarter + 90.0 * step / kSteps);
      points.push_back({(isRight ? size.x - radius.x : radius.x) + radius.x * cosine,
                        (isLow ? size.y - radius.y : radius.y) + radius.y * sine});
    }
  }
  return points;
}

/// What lies below each segment of an open polyline; right of it, if it is steep.
std::vector<Outline> thickened(const std::vector<DoublePoint>& points, double thickness) {
  std::vector<Outline> pieces;
  for (std::size_t k = 1; k < points.size(); ++k) {
    const DoublePoint a = points[k - 1], b = points[k];
    const bool isSteep = std::fabs(b.y - a.y) > std::fabs(b.x - a.x);
    const DoublePoint out = isSteep ? DoublePoint{thickness, 0} : DoublePoint{0, thickness};
    pieces.push_back({a, b, {b.x + out.x, b.y + out.y}, {a.x + out.x, a.y + out.y}});
  }
  return pieces;
}

std::vector<Outline> plainOutlines(const CollisionObject& object) {
  const DoublePoint size = object.size;
  const double radius = std::fmin(size.x, size.y) / 2;
  if (object.kind == Kind::rectangle) return {{{0, 0}, {size.x, 0}, size, {0, size.y}}};
  if (object.kind == Kind::polygon) return {object.points};
  if (object.kind == Kind::polyline) return thickened(object.points, object.thickness);
  if (object.kind == Kind::ellipse) return {roundedBox(size, {size.x / 2, size.y / 2})};
  if (object.kind == Kind::capsule) return {roundedBox(size, {radius, radius})};
  return {};
}

}  // namespace

bool isOpen(const std::vector<DoublePoint>& points) {
  return points.size() < 4 || points.front().x != points.back().x || points.front().y != points.back().y;
}

void leaveOut(CollisionObject& object, std::string reason) {
  object.kind = Kind::unsupported;
  object.unsupported = std::move(reason);
}

CollisionObject readObject(const XmlFile& file, pugi::xml_node node, DoublePoint offset, Templates& templates) {
  const std::string named = node.attribute("template").value();
  if (named.empty()) return readPlain(file, node, offset);
  std::unique_ptr<Template>& known = templates[file.pathTo(named)];
  if (!known) known = std::make_unique<Template>(file, named);
  Template& origin = *known;
  const auto model = origin.file.root().child("object");
  if (origin.error || !model) {
    CollisionObject object = readPlain(file, node, offset);
    leaveOut(object, "its template " + (origin.error ? message(*origin.error) : named + " has no <object>"));
    return object;
  }
  pugi::xml_document merged;
  merge(node, model, merged);
  CollisionObject object = readPlain(file, merged.first_child(), offset);
  if (!node.attribute("gid")) object.gidFrom = &origin;
  return object;
}

bool isLeftOut(const Called& called, const Options& options) {
  return std::any_of(options.leaveOut.begin(), options.leaveOut.end(), [&](const std::string& rule) {
    return (!rule.empty() && (rule == called.className || rule == called.name)) ||
           (rule.find('=') != std::string::npos && firstFit({rule}, called.properties));
  });
}

CollisionObject asAsked(CollisionObject object, const Options& options) {
  const bool isNotAsked = isLeftOut(object, options);
  if (options.blockFrom == BlockFrom::name && !object.name.empty()) object.className = object.name;
  if (object.kind == Kind::unsupported) return object;
  if (isNotAsked) {
    leaveOut(object, "it is left out, as asked");
  } else if (object.hidden && options.visibleOnly) {
    leaveOut(object, "it is hidden");
  } else if (object.kind == Kind::polyline) {
    object.thickness = object.points.size() > 1 ? options.polylineThickness : 0;
    if (object.thickness == 0)
      leaveOut(object, concat(kNoArea, ": close it, or --polyline-thickness PIXELS makes it thick"));
  }
  return object;
}

std::vector<Outline> outlines(const CollisionObject& object, const std::function<DoublePoint(DoublePoint)>& place) {
  std::vector<Outline> all = plainOutlines(object);
  for (Outline& outline : all) {
    for (DoublePoint& p : outline) {
      const DoublePoint q = turned(p, object.rotation);
      p = place({object.at.x + q.x, object.at.y + q.y});
    }
  }
  return all;
}

DoublePoint turned(DoublePoint p, double degrees) {
  const auto [cosine, sine] = turn(degrees);
  return {p.x * cosine - p.y * sine, p.x * sine + p.y * cosine};
}

std::uint32_t tileNumber(std::uint32_t gid) { return gid & 0x0FFF'FFFF; }  // one flag is only for hexagonal maps

void ImageFrame::scaleTo(DoublePoint size) {
  const DoublePoint box = (gid & kDiagonal) != 0 ? DoublePoint{image.y, image.x} : image;
  scale = {size.x / box.x, size.y / box.y};
}

DoublePoint ImageFrame::toCell(DoublePoint p) const {
  DoublePoint box = image;
  if ((gid & kDiagonal) != 0) {
    std::swap(p.x, p.y);
    std::swap(box.x, box.y);
  }
  if ((gid & kHorizontal) != 0) p.x = box.x - p.x;
  if ((gid & kVertical) != 0) p.y = box.y - p.y;
  return {p.x * scale.x + shift.x, (box.y - p.y) * scale.y - shift.y};
}

}  // namespace lgs::tiled
