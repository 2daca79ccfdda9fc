// What the steps of a page share: points, polygons and segments. Each is written once, and has a number.
#pragma once

#include "oracle/reference/outline.h"
#include "oracle/trace/trace.h"

#include <lgs/lattice.h>
#include <cstddef>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

namespace lgs::oracle::paging {

using Json = nlohmann::ordered_json;

class Tables {
 public:
  std::size_t addPolygon(const Call& add);
  const ScenePolygon& polygon(std::size_t number) const { return placed_[number]; }
  const std::vector<ScenePolygon>& polygons() const { return placed_; }

  /// The number of a segment of this polygon; of none if no polygon has such an edge.
  std::size_t segment(const OutlineSegment& segment, std::optional<std::size_t> owner);

  /// Adds the tables to a page's data.
  void writeTo(Json& data) &&;

 private:
  std::size_t point(Point point);
  Json pointOrNull(const std::optional<Point>& point);

  std::map<Point, std::size_t> numberOfPoint_;
  std::map<std::pair<OutlineSegment, std::optional<std::size_t>>, std::size_t> numberOfSegment_;
  std::vector<ScenePolygon> placed_;
  Json points_ = Json::array();
  Json polygons_ = Json::array();
  Json segments_ = Json::array();
};

}  // namespace lgs::oracle::paging
