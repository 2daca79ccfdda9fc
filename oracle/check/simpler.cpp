#include "oracle/check/simpler.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace lgs::oracle {
namespace {

constexpr std::int32_t U = kUnitsPerCell;
constexpr std::size_t kSteps = 16;            // of coordinates: a whole cell, a half, … two units
constexpr std::size_t kRounded = 2 * kSteps;  // variants of a coordinate: down and up

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

std::optional<LocalPolygon> withoutSome(const LocalPolygon& polygon, std::size_t drop) {
  std::size_t length = polygon.size() / 2;
  const auto pieces = [&] { return (polygon.size() + length - 1) / length; };
  for (; drop >= pieces(); length /= 2) drop -= pieces();
  const std::size_t begin = drop * length, end = std::min(begin + length, polygon.size());
  if (polygon.size() - (end - begin) < 3) return std::nullopt;
  LocalPolygon rest(polygon.begin(), polygon.begin() + static_cast<std::ptrdiff_t>(begin));
  rest.insert(rest.end(), polygon.begin() + static_cast<std::ptrdiff_t>(end), polygon.end());
  return rest;
}

std::optional<LocalPolygon> withRounded(const LocalPolygon& polygon, std::size_t variant) {
  const std::size_t vertex = variant / (2 * kRounded);
  const auto axis = variant / kRounded % 2 == 0 ? &LocalPoint::x : &LocalPoint::y;
  const std::int32_t step = U >> (variant % kRounded / 2);
  const std::int32_t v = polygon[vertex].*axis;
  const std::int32_t rounded = v / step * step + (variant % 2 == 0 ? 0 : step);
  if (rounded > U || costOf(rounded) >= costOf(v)) return std::nullopt;
  LocalPolygon rounder = polygon;
  rounder[vertex].*axis = rounded;
  return rounder;
}

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

}  // namespace lgs::oracle
