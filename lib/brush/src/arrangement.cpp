#include "arrangement.h"

#include <algorithm>
#include <span>

namespace lgs::brush {
namespace {

/// A part of an edge of the region between two neighbouring hot points.
struct Part {
  Point low, high;
  Segment segment;
  friend bool operator<(const Part& a, const Part& b) { return a.low != b.low ? a.low < b.low : a.high < b.high; }
};

/// The region's edges, parted at the known points whose pixels they pass.
std::vector<Part> partsOf(const Pieces& region, const std::vector<Point>& known) {
  std::vector<Part> parts;
  parts.reserve(known.size());
  std::vector<Point> chain;
  for (const Piece& p : region) {
    route({p.a, p.b, p.start, p.end, {}, true}, known, chain);
    for (std::size_t k = 1; k < chain.size(); ++k) {
      const Point u = chain[k - 1], v = chain[k];
      const bool rises = isLower(u, v);
      parts.push_back({rises ? u : v, rises ? v : u, {p.a, p.b, u, v, {1, 0, 0, 0}, true}});
    }
  }
  std::stable_sort(parts.begin(), parts.end());
  return parts;
}

/// The parts with the ends of a side.
std::span<const Part> partsAlong(Point low, Point high, const std::vector<Part>& parts) {
  const auto [begin, end] = std::equal_range(parts.begin(), parts.end(), Part{low, high, {}});
  return {begin, end};
}

/// Adds the outlines of groups. An edge between the same known points as a part of the region's edge follows that part.
/// Otherwise rounding could part them by slivers, wherever a brush comes back to where it was.
void addGroups(const Ground& ground, const std::vector<Part>& parts, Arrangement& result) {
  const std::vector<Side>& sides = ground.sides;
  for (std::size_t k = 0; k < sides.size();) {
    const Side& first = sides[k];
    Segment segment{first.low, first.high, first.low, first.high, {}, true};
    for (; k < sides.size() && !(first < sides[k]); ++k) {
      const Side& s = sides[k];
      if (ground.groups[s.area] != kNoGroup) {
        const auto number = static_cast<std::int64_t>(s.area) + 1;
        const Sum sum{0, 1, number, number * number};
        segment.sum += s.isLeft ? sum : -sum;
      } else {
        segment.bends = false;
      }
    }
    if (segment.sum == Sum{}) continue;
    const auto along = partsAlong(first.low, first.high, parts);
    if (segment.bends && !along.empty()) {
      const Segment& part = along[0].segment;
      segment.a = part.start == first.low ? part.a : part.b;
      segment.b = part.start == first.low ? part.b : part.a;
    }
    result.segments.push_back(segment);
  }
}

/// Whether a part may follow an edge that must stay, as there is nothing between them.
bool mayFollow(const Segment& part, std::span<const Segment> polygons) {
  return std::none_of(polygons.begin(), polygons.end(), [&](const Segment& edge) {
    const auto pixel = crossingPixel(edge, part);
    return pixel && *pixel != part.start && *pixel != part.end;
  });
}

/// Adds the region's edges. Parts from one known point to the same other one will lie on each other: they count as one,
/// or as none. A part beside an edge that must stay follows that.
void addRegion(const std::vector<Part>& parts, FillRule, const Ground& ground, bool follows, Arrangement& result) {
  const std::size_t polygons = result.segments.size();
  for (std::size_t k = 0; k < parts.size();) {
    auto& [low, high, segment] = parts[k++];
    const std::int64_t winding = segment.start == low ? 1 : -1;
    const auto [begin, end] = std::equal_range(ground.sides.begin(), ground.sides.end(), Side{low, high, 0, true});
    const auto isToStay = [&](const Side& s) { return ground.groups[s.area] == kNoGroup; };
    const bool stays = follows && std::any_of(begin, end, isToStay);
    if ((stays && mayFollow(segment, std::span(result.segments).first(polygons)))) {
      result.segments.push_back({low, high, low, high, {winding, 0, 0, 0}, !stays});
    } else {
      result.segments.push_back(segment);
    }
  }
}

}  // namespace

Arrangement arrangementOf(const Ground& ground, const Pieces& region, FillRule rule, bool follows) {
  Arrangement result;
  result.hot = ground.known;
  for (std::size_t k = 0; k < ground.polygons.size(); ++k)
    result.staying.push_back(ground.groups[k] == kNoGroup ? &ground.polygons[k].ring : nullptr);
  const std::vector<Part> parts = partsOf(region, ground.known);
  result.segments.reserve(ground.sides.size() + parts.size());
  addGroups(ground, follows ? parts : std::vector<Part>{}, result);
  addRegion(parts, rule, ground, follows, result);
  addCrossings(result.segments, result.hot);
  normalize(result.hot);
  return result;
}

}  // namespace lgs::brush
