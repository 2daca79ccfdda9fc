#include "oracle/reference/blame.h"

#include <fmt/format.h>
#include <algorithm>
#include <cstdint>
#include <utility>

namespace lgs::oracle {
namespace {

bool isOutside(LocalPoint p) { return p.x < 0 || p.x > kUnitsPerCell || p.y < 0 || p.y > kUnitsPerCell; }

// The first edge that meets another one, and the first of these after it.
std::pair<std::size_t, std::size_t> firstThatMeet(const LocalPolygon& polygon) {
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n + (i + 1) / n; ++j)
      if (edgesMeet(polygon, i, j % n) && (i != 0 || j + 1 != n)) return {i, j % n};
  return {n, n};
}

bool areVerticesToBlame(const Error& error, const LocalPolygon& polygon) {
  const auto exists = [&](std::int32_t k) { return k >= 0 && static_cast<std::size_t>(k) < polygon.size(); };
  const auto at = [&](std::int32_t k) { return polygon[static_cast<std::size_t>(k)]; };
  const auto firstLike = [&](std::int32_t k) {
    return static_cast<std::int32_t>(std::find(polygon.begin(), polygon.end(), at(k)) - polygon.begin());
  };
  const auto hasRepeatBefore = [&](std::int32_t end) {
    for (std::int32_t k = 0; k < end; ++k)
      if (firstLike(k) != k) return true;
    return false;
  };
  const std::int32_t a = error.vertex;
  const std::int32_t b = error.vertex2;
  switch (error.code) {
    case ErrorCode::outsideCell:
      return exists(a) && isOutside(at(a)) && b == -1;
    case ErrorCode::repeatedVertex:
      return exists(a) && exists(b) && firstLike(b) == a && a != b && !hasRepeatBefore(b);
    case ErrorCode::selfIntersecting:
      return exists(a) && exists(b) &&
             std::pair(static_cast<std::size_t>(a), static_cast<std::size_t>(b)) == firstThatMeet(polygon);
    default:  // no vertex is to blame
      return a == -1 && b == -1;
  }
}

}  // namespace

std::string wrongBlame(const Error& error, std::span<const LocalPolygon> polygons) {
  const auto isFaulty = [](const LocalPolygon& polygon) { return faultOf(polygon).has_value(); };
  const auto faulty = std::ranges::find_if(polygons, isFaulty);
  const auto blamed = faulty == polygons.end() ? polygons.begin() : faulty;
  if (!areVerticesToBlame(error, *blamed))
    return fmt::format("names vertices {} and {}, which are not to blame", error.vertex, error.vertex2);
  const bool isOverlap = error.code == ErrorCode::overlap;
  const auto index =
      error.code == ErrorCode::cellOutOfRange ? -1 : static_cast<std::int32_t>(blamed - polygons.begin());
  const bool isJudged = isOverlap && polygons.size() > 1;
  if (error.polygon != index && !isJudged) return fmt::format("names polygon {} instead of {}", error.polygon, index);
  if ((error.polygon2 != -1 && !isJudged) || (!isOverlap && error.other != PolygonHandle{}) ||
      error.segment != SegmentId{})
    return "sets a field that does not apply";
  return {};
}

}  // namespace lgs::oracle
