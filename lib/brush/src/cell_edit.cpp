#include "cell_edit.h"

#include "geometry/ring.h"
#include "ownership.h"
#include "stay.h"

#include <algorithm>

namespace lgs::brush {
namespace {

using detail::nextVertex;

/// Whether the region, with its outline, has a point in common with a polygon.
bool meets(const Pieces& region, FillRule rule, const Ring& ring) {
  Point rising{};  // a place just left of which the polygon is, doubled
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point u = ring[k], v = nextVertex(ring, k);
    if (u.y < v.y) rising = {u.x + v.x, u.y + v.y};
    for (const Piece& p : region)
      if (p.isOfRegion && detail::segmentsMeet(u, v, p.a, p.b)) return true;
  }
  // The outlines do not meet. So the polygon is inside the region or outside, and each ring of the region is inside the
  // polygon or outside.
  if (isInside(windingLeftOf(rising, region), rule)) return true;
  const Pieces outline = piecesOf(ring);
  return std::any_of(region.begin(), region.end(), [&](const Piece& p) {
    return p.isOfRegion && windingLeftOf({2 * p.start.x, 2 * p.start.y}, outline) != 0;
  });
}

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

void addPolygons(const std::vector<CellPolygon>& polygons, const std::vector<bool>& reached, Arrangement& result) {
  const std::vector<Side> sides = sidesOf(polygons, result.hot);
  for (std::size_t k = 0; k < sides.size();) {
    const std::size_t first = k;
    Segment segment{sides[k].low, sides[k].high, sides[k].low, sides[k].high, {}, true};
    for (; k < sides.size() && !(sides[first] < sides[k]); ++k) {
      const Side& s = sides[k];
      if (reached[s.polygon]) {
        const Sum sum{0, 1, static_cast<std::int64_t>(s.polygon) + 1};
        segment.sum += s.isLeft ? sum : -sum;
      } else {
        segment.bends = false;
      }
    }
    if (segment.sum != Sum{}) result.segments.push_back(segment);
  }
}

Arrangement arrangementOf(const std::vector<CellPolygon>& polygons, const std::vector<bool>& reached,
                          const Pieces& region) {
  constexpr std::int64_t kEnd = kUnitsPerCell;
  Arrangement result;
  result.hot = {{0, 0}, {kEnd, 0}, {kEnd, kEnd}, {0, kEnd}};
  for (const CellPolygon& p : polygons) result.hot.insert(result.hot.end(), p.ring.begin(), p.ring.end());
  normalize(result.hot);
  for (std::size_t k = 0; k < polygons.size(); ++k) result.staying.push_back(reached[k] ? nullptr : &polygons[k].ring);
  addPolygons(polygons, reached, result);
  for (const Piece& p : region) {
    result.segments.push_back({p.a, p.b, p.start, p.end, {1, 0, 0}, true});
    result.hot.push_back(p.start);
    result.hot.push_back(p.end);
  }
  addCrossings(result.segments, result.hot);
  normalize(result.hot);
  return result;
}

}  // namespace

CellEdit editOf(const std::vector<CellPolygon>& polygons, const Pieces& region, const Stroke& stroke) {
  std::vector<bool> reached;
  for (const CellPolygon& p : polygons) reached.push_back(meets(region, stroke.rule, p.ring));
  std::vector<std::size_t> bent;
  for (;;) {
    Chains chains;
    const Arrangement arrangement = arrangementOf(polygons, reached, region);
    const std::vector<std::size_t> crossed = roundBeside(arrangement, chains);
    for (const std::size_t k : crossed) {
      if (!reached[k]) bent.push_back(k);
      reached[k] = true;
    }
    if (!crossed.empty()) continue;
    std::vector<Atom> atoms;
    for (std::size_t k = 0; k < chains.size(); ++k) addAtoms(chains[k], arrangement.segments[k].sum, atoms);
    settle(atoms);
    CellEdit edit = divided(polygons, reached, atoms, stroke);
    std::sort(bent.begin(), bent.end());
    std::set_intersection(bent.begin(), bent.end(), edit.gone.begin(), edit.gone.end(), std::back_inserter(edit.bent));
    return edit;
  }
}

}  // namespace lgs::brush
