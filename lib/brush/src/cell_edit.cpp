#include "cell_edit.h"

#include "arrangement.h"
#include "geometry/ring.h"
#include "ownership.h"
#include "rounding.h"

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
    return p.start == p.a && p.isOfRegion && windingLeftOf({2 * p.start.x, 2 * p.start.y}, outline) != 0;
  });
}

}  // namespace

CellEdit editOf(const std::vector<CellPolygon>& polygons, const Pieces& region, const Stroke& stroke) {
  std::vector<bool> reached;
  for (const CellPolygon& p : polygons) reached.push_back(meets(region, stroke.rule, p.ring));
  std::vector<std::size_t> bent;
  for (;;) {
    std::vector<Atom> atoms;
    const std::vector<std::size_t> crossed =
        rounded(arrangementOf(polygons, reached, region, stroke.rule), stroke.rule, atoms);
    for (const std::size_t k : crossed) {
      if (!reached[k]) bent.push_back(k);
      reached[k] = true;
    }
    if (!crossed.empty()) continue;
    CellEdit edit = divided(polygons, reached, atoms, stroke);
    std::sort(bent.begin(), bent.end());
    std::set_intersection(bent.begin(), bent.end(), edit.gone.begin(), edit.gone.end(), std::back_inserter(edit.bent));
    return edit;
  }
}

}  // namespace lgs::brush
