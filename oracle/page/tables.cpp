#include "oracle/page/tables.h"

#include "oracle/reference/words.h"

namespace lgs::oracle::paging {

std::size_t Tables::point(Point point) {
  const auto [at, isNew] = numberOfPoint_.try_emplace(point, points_.size());
  if (isNew) points_.push_back({{"x", point.x}, {"y", point.y}, {"text", inWords(point)}});
  return at->second;
}

Json Tables::pointOrNull(const std::optional<Point>& p) { return p ? Json(point(*p)) : Json(nullptr); }

std::size_t Tables::addPolygon(const Call& add) {
  const ScenePolygon polygon = add.polygon();
  Json corners = Json::array();
  for (const LocalPoint& vertex : polygon.vertices) corners.push_back(point(toWorld(polygon.cell, vertex)));
  polygons_.push_back({{"name", add.name()},
                       {"cell", {polygon.cell.i, polygon.cell.j}},
                       {"block", polygon.block},
                       {"corners", std::move(corners)}});
  placed_.push_back(polygon);
  return placed_.size() - 1;
}

std::size_t Tables::segment(const OutlineSegment& segment, std::optional<std::size_t> owner) {
  const auto [at, isNew] = numberOfSegment_.try_emplace({segment, owner}, segments_.size());
  if (isNew) {
    segments_.push_back({{"start", point(segment.start)},
                         {"end", point(segment.end)},
                         {"ghost1", pointOrNull(segment.ghost1)},
                         {"ghost2", pointOrNull(segment.ghost2)},
                         {"block", segment.block},
                         {"owner", owner ? Json(*owner) : Json(nullptr)},
                         {"place", placeInWords(segment.start, segment.end)}});
  }
  return at->second;
}

void Tables::writeTo(Json& data) && {
  data["points"] = std::move(points_);
  data["polygons"] = std::move(polygons_);
  data["segments"] = std::move(segments_);
}

}  // namespace lgs::oracle::paging
