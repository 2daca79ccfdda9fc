#include "fuzz/blame.h"

#include <fmt/format.h>
#include <algorithm>
#include <cstdint>

namespace lgs::fuzz {
namespace {

using oracle::LocalPolygon;

// Positive: c is on the left of a→b.
std::int64_t side(LocalPoint a, LocalPoint b, LocalPoint c) {
  return (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) - (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
}

struct Edge {
  LocalPoint a, b;
};

bool isEnd(LocalPoint p, const Edge& e) { return p == e.a || p == e.b; }

bool isOn(LocalPoint p, const Edge& e) {
  return side(e.a, e.b, p) == 0 && std::min(e.a.x, e.b.x) <= p.x && p.x <= std::max(e.a.x, e.b.x) &&
         std::min(e.a.y, e.b.y) <= p.y && p.y <= std::max(e.a.y, e.b.y);
}

bool areApart(std::int64_t s, std::int64_t t) { return (s < 0 && t > 0) || (s > 0 && t < 0); }

// Whether two edges of a polygon of distinct vertices have a point in common that is not the vertex they share.
bool meet(const Edge& e, const Edge& f) {
  if (areApart(side(e.a, e.b, f.a), side(e.a, e.b, f.b)) && areApart(side(f.a, f.b, e.a), side(f.a, f.b, e.b))) {
    return true;
  }
  return (isOn(e.a, f) && !isEnd(e.a, f)) || (isOn(e.b, f) && !isEnd(e.b, f)) || (isOn(f.a, e) && !isEnd(f.a, e)) ||
         (isOn(f.b, e) && !isEnd(f.b, e));
}

bool isOutside(LocalPoint p) { return p.x < 0 || p.x > kUnitsPerCell || p.y < 0 || p.y > kUnitsPerCell; }

bool areVerticesToBlame(const Error& error, const LocalPolygon& polygon) {
  const auto exists = [&](std::int32_t k) { return k >= 0 && static_cast<std::size_t>(k) < polygon.size(); };
  const auto at = [&](std::int32_t k) { return polygon[static_cast<std::size_t>(k) % polygon.size()]; };
  const std::int32_t a = error.vertex;
  const std::int32_t b = error.vertex2;
  switch (error.code) {
    case ErrorCode::outsideCell:
      return exists(a) && isOutside(at(a)) && b == -1;
    case ErrorCode::repeatedVertex:
      return exists(a) && exists(b) && a != b && at(a) == at(b);
    case ErrorCode::selfIntersecting:
      return exists(a) && exists(b) && a != b && meet({at(a), at(a + 1)}, {at(b), at(b + 1)});
    default:  // no vertex is
      return a == -1 && b == -1;
  }
}

}  // namespace

std::string wrongBlame(const Error& error, const LocalPolygon& polygon) {
  if (!areVerticesToBlame(error, polygon)) {
    return fmt::format("names vertices {} and {}, which are not to blame", error.vertex, error.vertex2);
  }
  const std::int32_t index = error.code == ErrorCode::cellOutOfRange ? -1 : 0;
  if (error.polygon != index) return fmt::format("names polygon {} instead of {}", error.polygon, index);
  const bool isOverlap = error.code == ErrorCode::overlap;
  if (error.polygon2 != -1 || (!isOverlap && error.other != PolygonHandle{}) || error.segment != SegmentId{}) {
    return "sets a field that does not apply";
  }
  return {};
}

}  // namespace lgs::fuzz
