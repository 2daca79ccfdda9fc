#include "oracle/check/simpler.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numeric>

namespace lgs::oracle {
namespace {

constexpr std::int32_t U = kUnitsPerCell;
constexpr std::size_t kSteps = 16;            // of coordinates: a whole cell, a half, … two units
constexpr std::size_t kRounded = 2 * kSteps;  // variants of a coordinate: down and up
constexpr std::size_t kMoved = kRounded + 2;  // and of one of a stroke: as its neighbours are

// The square and its halves.
const std::array<LocalPolygon, 5>& plainPolygons() {
  static const std::array<LocalPolygon, 5> kPlain{
      LocalPolygon{{0, 0}, {U, 0}, {U, U}, {0, U}}, LocalPolygon{{0, 0}, {U, 0}, {U, U}},
      LocalPolygon{{0, 0}, {U, 0}, {0, U}}, LocalPolygon{{0, 0}, {U, U}, {0, U}}, LocalPolygon{{U, 0}, {U, U}, {0, U}}};
  return kPlain;
}

// How much there is to say about a coordinate: 0 for 0, 1 for 1, 2 for a half, … 17 for an odd number of units.
int costOf(std::int32_t v) {
  if (v == 0 || v == U) return v == 0 ? 0 : 1;
  int cost = 18;
  for (std::int32_t units = std::gcd(v, U); units > 0; units /= 2) --cost;
  return cost;
}

std::size_t costOf(const LocalPolygon& polygon) {
  std::size_t cost = 1'000 * polygon.size();
  for (const LocalPoint& p : polygon) cost += static_cast<std::size_t>(costOf(p.x) + costOf(p.y));
  return cost;
}

// Vertices go in halves, quarters, … and one by one.
std::size_t dropsOf(std::size_t size) {
  std::size_t drops = 0;
  for (std::size_t length = size / 2; length > 0; length /= 2) drops += (size + length - 1) / length;
  return drops;
}

template <class Vertices>
std::optional<Vertices> withoutSome(const Vertices& polygon, std::size_t drop) {
  std::size_t length = polygon.size() / 2;
  const auto pieces = [&] { return (polygon.size() + length - 1) / length; };
  for (; drop >= pieces(); length /= 2) drop -= pieces();
  const std::size_t begin = drop * length, end = std::min(begin + length, polygon.size());
  if (polygon.size() - (end - begin) < 3) return std::nullopt;
  Vertices rest(polygon.begin(), polygon.begin() + static_cast<std::ptrdiff_t>(begin));
  rest.insert(rest.end(), polygon.begin() + static_cast<std::ptrdiff_t>(end), polygon.end());
  return rest;
}

// With a coordinate go those that are equal, so that edges along the axes stay so.
template <class Vertices, class Number, class Axis>
void move(Vertices& polygon, Axis axis, Number from, Number to) {
  for (auto& p : polygon)
    if (p.*axis == from) p.*axis = to;
}

std::optional<LocalPolygon> withRounded(const LocalPolygon& polygon, std::size_t variant) {
  const std::size_t vertex = variant / (2 * kRounded);
  const auto axis = variant / kRounded % 2 == 0 ? &LocalPoint::x : &LocalPoint::y;
  const std::int32_t step = U >> (variant % kRounded / 2);
  const std::int32_t v = polygon[vertex].*axis;
  const std::int32_t rounded = v / step * step + (variant % 2 == 0 ? 0 : step);
  if (rounded > U || costOf(rounded) >= costOf(v)) return std::nullopt;
  LocalPolygon rounder = polygon;
  move(rounder, axis, v, rounded);
  return rounder;
}

// A coordinate of the world is rounded down or up. Nothing if that is not rounder.
std::optional<std::int64_t> rounder(std::int64_t v, std::size_t variant) {
  const std::int64_t step = U >> (variant / 2);
  const std::int64_t rest = (v % step + step) % step;
  const std::int64_t rounded = v - rest + (variant % 2 == 0 ? 0 : step);
  const auto grain = [](std::int64_t c) { return std::gcd(c, std::int64_t{U}); };
  return grain(rounded) > grain(v) ? std::optional(rounded) : std::nullopt;
}

// The coordinate of a vertex as the next lower or higher one is that the rings have, or rounded.
std::optional<BrushEdit> withMoved(BrushEdit brush, const std::vector<Point>& ring, std::size_t variant) {
  const auto axis = variant / kMoved % 2 == 0 ? &Point::x : &Point::y;
  const std::int64_t v = ring[variant / (2 * kMoved)].*axis;
  std::optional<std::int64_t> to;
  if (variant %= kMoved; variant < kRounded) {
    to = rounder(v, variant);
  } else {
    const bool isUp = variant == kRounded;
    for (const auto& other : brush.rings)
      for (const Point p : other)
        if ((isUp ? p.*axis > v : p.*axis < v) && (!to || std::abs(p.*axis - v) < std::abs(*to - v))) to = p.*axis;
  }
  if (!to) return std::nullopt;
  for (auto& other : brush.rings) move(other, axis, v, *to);
  return brush;
}

std::size_t variantsOf(const std::vector<Point>& ring) { return dropsOf(ring.size()) + 2 * kMoved * ring.size(); }

}  // namespace

std::size_t variantsOf(const LocalPolygon& polygon) {
  return plainPolygons().size() + dropsOf(polygon.size()) + 2 * kRounded * polygon.size();
}

std::optional<LocalPolygon> simplerPolygon(const LocalPolygon& polygon, std::size_t variant) {
  const std::size_t plain = plainPolygons().size();
  if (variant < plain) {
    const LocalPolygon& candidate = plainPolygons()[variant];
    return costOf(candidate) < costOf(polygon) ? std::optional(candidate) : std::nullopt;
  }
  variant -= plain;
  const std::size_t drops = dropsOf(polygon.size());
  return variant < drops ? withoutSome(polygon, variant) : withRounded(polygon, variant - drops);
}

std::size_t variantsOf(const BrushEdit& brush) {
  std::size_t variants = brush.rings.size();
  for (const auto& ring : brush.rings) variants += variantsOf(ring);
  return variants;
}

std::optional<BrushEdit> simplerBrush(const BrushEdit& brush, std::size_t variant) {
  BrushEdit simpler = brush;
  if (variant < brush.rings.size()) {
    if (brush.rings.size() == 1) return std::nullopt;
    simpler.rings.erase(simpler.rings.begin() + static_cast<std::ptrdiff_t>(variant));
    return simpler;
  }
  variant -= brush.rings.size();
  std::size_t k = 0;
  for (; variant >= variantsOf(brush.rings[k]); ++k) variant -= variantsOf(brush.rings[k]);
  const std::vector<Point>& ring = brush.rings[k];
  const std::size_t drops = dropsOf(ring.size());
  if (variant >= drops) return withMoved(brush, ring, variant - drops);
  auto rest = withoutSome(ring, variant);
  if (!rest) return std::nullopt;
  simpler.rings[k] = std::move(*rest);
  return simpler;
}

}  // namespace lgs::oracle
