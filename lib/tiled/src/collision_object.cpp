#include "collision_object.h"

namespace lgs::tiled {
namespace {

using Kind = CollisionObject::Kind;

/// Reads the vertices of a polygon, or of a polyline that ends where it began.
void readPoints(const XmlFile& file, pugi::xml_node node, bool closed, CollisionObject& object) {
  const auto leaveOut = [&](const char* reason) {
    object.kind = Kind::unsupported;
    object.unsupported = reason;
  };
  object.kind = Kind::polygon;
  object.points = file.points(node, "points");
  if (!closed) {
    const auto same = [](DoublePoint a, DoublePoint b) { return a.x == b.x && a.y == b.y; };
    if (object.points.size() < 4 || !same(object.points.front(), object.points.back())) {
      return leaveOut("an open polyline has no area: close it, or draw a polygon instead");
    }
    object.points.pop_back();
  }
  if (object.points.size() < 3) return leaveOut("the polygon has fewer than 3 vertices");
  if (object.points.size() > kMaxObjectVertices) return leaveOut("the polygon has more than 1024 vertices");
}

/// Reads the kind of an object, and for Kind::unsupported the reason.
void readKind(const XmlFile& file, pugi::xml_node node, CollisionObject& object) {
  const auto leaveOut = [&](const char* reason) {
    object.kind = Kind::unsupported;
    object.unsupported = reason;
  };
  if (node.child("point")) return leaveOut("a point has no area");
  if (node.child("text")) return leaveOut("a text is no shape");
  if (object.gid != 0) {
    object.kind = Kind::tile;
  } else if (const auto polygon = node.child("polygon")) {
    readPoints(file, polygon, true, object);
  } else if (const auto polyline = node.child("polyline")) {
    readPoints(file, polyline, false, object);
  } else {
    object.kind = node.child("ellipse") ? Kind::ellipse : node.child("capsule") ? Kind::capsule : Kind::rectangle;
    if (object.size.x <= 0 || object.size.y <= 0) leaveOut("it has no area: its width or height is 0");
  }
}

/// An object of a template: what it says itself, and else what the template says.
void merge(pugi::xml_node instance, pugi::xml_node origin, pugi::xml_document& merged) {
  pugi::xml_node node = merged.append_copy(origin);
  for (const auto attribute : instance.attributes()) {
    if (std::string_view(attribute.name()) == "template") continue;
    node.remove_attribute(attribute.name());
    node.append_attribute(attribute.name()) = attribute.value();
  }
  for (const char* shape : {"polygon", "polyline", "ellipse", "capsule", "point", "text"}) {
    if (!instance.child(shape)) continue;
    node.remove_child(shape);
    node.append_copy(instance.child(shape));
  }
}

CollisionObject readPlain(const XmlFile& file, pugi::xml_node node, DoublePoint offset) {
  constexpr std::int64_t kMost = 0xFFFF'FFFF;
  CollisionObject object;
  object.id = static_cast<std::uint32_t>(file.integer(node, "id", 0, 0, kMost));
  object.className = classOf(node);
  object.at = {file.real(node, "x") + offset.x, file.real(node, "y") + offset.y};
  object.size = {file.real(node, "width"), file.real(node, "height")};
  object.rotation = file.real(node, "rotation");
  object.gid = static_cast<std::uint32_t>(file.integer(node, "gid", 0, 0, kMost));
  readKind(file, node, object);
  return object;
}

}  // namespace

CollisionObject readObject(const XmlFile& file, pugi::xml_node node, DoublePoint offset, Templates& templates) {
  const std::string named = node.attribute("template").value();
  if (named.empty()) return readPlain(file, node, offset);
  Template& origin = templates.of(file, named);
  const auto model = origin.file.root().child("object");
  if (origin.error || !model) {
    CollisionObject object;
    object.id = static_cast<std::uint32_t>(file.integer(node, "id", 0, 0, 0xFFFF'FFFF));
    object.kind = Kind::unsupported;
    object.unsupported = "its template " + (origin.error ? message(*origin.error) : named + " has no <object>");
    return object;
  }
  pugi::xml_document merged;
  merge(node, model, merged);
  CollisionObject object = readPlain(file, merged.first_child(), offset);
  if (!node.attribute("gid")) object.gidFrom = &origin;
  return object;
}

}  // namespace lgs::tiled
