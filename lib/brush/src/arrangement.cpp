#include "arrangement.h"

#include "atoms.h"
#include "geometry/ring.h"

#include <algorithm>
#include <span>

namespace lgs::brush {
namespace {

using detail::nextVertex;

/// An edge of a polygon between neighbouring vertices of the cell, from its lower end.
struct Side {
  Point low, high;
  std::size_t polygon;
  bool isLeft;
  friend bool operator<(const Side& a, const Side& b) { return a.low != b.low ? a.low < b.low : a.high < b.high; }
};

std::vector<Side> sidesOf(const std::vector<CellPolygon>& polygons, const std::vector<Point>& vertices) {
  std::vector<Side> sides;
  std::vector<Point> cuts;
  for (std::size_t k = 0; k < polygons.size(); ++k) {
    const Ring& ring = polygons[k].ring;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      detail::cutEdge(ring[i], nextVertex(ring, i), vertices, cuts);
      for (std::size_t c = 1; c < cuts.size(); ++c) {
        const bool isLeft = isLower(cuts[c - 1], cuts[c]);
        sides.push_back(isLeft ? Side{cuts[c - 1], cuts[c], k, true} : Side{cuts[c], cuts[c - 1], k, false});
      }
    }
  }
  std::stable_sort(sides.begin(), sides.end());
  return sides;
}

/// A part of an edge of the region between two neighbouring hot points.
struct Part {
  Point low, high;
  Segment segment;
  friend bool operator<(const Part& a, const Part& b) { return a.low != b.low ? a.low < b.low : a.high < b.high; }
};

/// The region's edges, parted at the known points whose pixels they pass.
std::vector<Part> partsOf(const Pieces& region, const std::vector<Point>& known) {
  std::vector<Part> parts;
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

/// Adds the edges of polygons that the region reaches. An edge between the same known points as a part of the region's
/// edge follows that part. Otherwise rounding could part them by slivers, wherever a brush comes back to where it was.
void addPolygons(const std::vector<Side>& sides, const std::vector<bool>& reached, const std::vector<Part>& parts,
                 Arrangement& result) {
  for (std::size_t k = 0; k < sides.size();) {
    const Side& first = sides[k];
    Segment segment{first.low, first.high, first.low, first.high, {}, true};
    for (; k < sides.size() && !(first < sides[k]); ++k) {
      const Side& s = sides[k];
      if (reached[s.polygon]) {
        const auto number = static_cast<std::int64_t>(s.polygon) + 1;
        const Sum sum{0, 1, number, number * number};
        segment.sum += s.isLeft ? sum : -sum;
      } else {
        segment.bends = false;
      }
    }
    if (segment.sum == Sum{}) continue;
    const auto along = partsAlong(first.low, first.high, parts);
    if (segment.bends && along.size() == 1) {
      const Segment& part = along[0].segment;
      segment.a = part.start == first.low ? part.a : part.b;
      segment.b = part.start == first.low ? part.b : part.a;
    }
    result.segments.push_back(segment);
  }
}

/// Whether a part may follow an edge that must stay, as there is nothing between them.
bool mayFollow(const Segment& part, const std::vector<Segment>& polygons) {
  return std::none_of(polygons.begin(), polygons.end(), [&](const Segment& edge) {
    const auto pixel = crossingPixel(edge, part);
    return pixel && *pixel != part.start && *pixel != part.end;
  });
}

/// Adds the region's edges. Parts from one known point to the same other one will lie on each other: they count as one,
/// or as none. A part beside an edge that must stay follows that.
void addRegion(const std::vector<Part>& parts, FillRule rule, const std::vector<Side>& sides,
               const std::vector<bool>& reached, Arrangement& result) {
  const std::vector<Segment> polygons = result.segments;
  for (std::size_t k = 0; k < parts.size();) {
    const auto& [low, high, segment] = parts[k];
    const auto along = partsAlong(low, high, parts);
    k += along.size();
    std::int64_t winding = 0;  // from low to high
    for (const Part& p : along) winding += p.segment.start == low ? 1 : -1;
    if (rule == FillRule::evenOdd) winding %= 2;
    if (winding == 0) continue;
    const auto [begin, end] = std::equal_range(sides.begin(), sides.end(), Side{low, high, 0, true});
    const bool stays = std::any_of(begin, end, [&](const Side& s) { return !reached[s.polygon]; });
    if (along.size() > 1 || (stays && mayFollow(segment, polygons))) {
      result.segments.push_back({low, high, low, high, {winding, 0, 0, 0}, !stays});
    } else {
      result.segments.push_back(segment);
    }
  }
}

/// The hot points that are known before polygons and region are overlaid: all vertices, and where the region's edges
/// cross each other.
std::vector<Point> knownPoints(const std::vector<CellPolygon>& polygons, const Pieces& region) {
  constexpr std::int64_t kEnd = kUnitsPerCell;
  std::vector<Point> points{{0, 0}, {kEnd, 0}, {kEnd, kEnd}, {0, kEnd}};
  for (const CellPolygon& p : polygons) points.insert(points.end(), p.ring.begin(), p.ring.end());
  std::vector<Segment> edges;
  for (const Piece& p : region) {
    edges.push_back({p.a, p.b, p.start, p.end, {}, true});
    points.insert(points.end(), {p.start, p.end});
  }
  addCrossings(edges, points);
  normalize(points);
  return points;
}

}  // namespace

Arrangement arrangementOf(const std::vector<CellPolygon>& polygons, const std::vector<bool>& reached,
                          const Pieces& region, FillRule rule, bool follows) {
  Arrangement result;
  result.hot = knownPoints(polygons, region);
  for (std::size_t k = 0; k < polygons.size(); ++k) result.staying.push_back(reached[k] ? nullptr : &polygons[k].ring);
  const std::vector<Side> sides = sidesOf(polygons, result.hot);
  const std::vector<Part> parts = partsOf(region, result.hot);
  addPolygons(sides, reached, follows ? parts : std::vector<Part>{}, result);
  addRegion(parts, rule, follows ? sides : std::vector<Side>{}, reached, result);
  addCrossings(result.segments, result.hot);
  normalize(result.hot);
  return result;
}

}  // namespace lgs::brush
