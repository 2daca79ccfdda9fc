#include "cell_edit.h"

#include "calm.h"
#include "clip.h"
#include "geometry/ring.h"
#include "ownership.h"
#include "plain.h"
#include "rounding.h"

#include <algorithm>
#include <utility>

namespace lgs::brush {
using detail::nextVertex;

bool meets(PieceSpan region, FillRule rule, const Points& ring) {
  if (region.empty() || ring.empty()) return false;
  Point rising{};  // a place just left of which the polygon is, doubled
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point u = ring[k], v = nextVertex(ring, k);
    if (u.y < v.y) rising = {u.x + v.x, u.y + v.y};
  }
  const auto [min, max] = detail::boundingBox(ring);
  for (const Piece& p : region) {
    if (!p.isOfRegion || !detail::boxesMeet(min, max, p.a, p.b)) continue;
    for (std::size_t k = 0; k < ring.size(); ++k)
      if (detail::segmentsMeet(ring[k], nextVertex(ring, k), p.a, p.b)) return true;
  }
  // The outlines do not meet. So the polygon is inside the region or outside, and each ring of the region is inside the
  // polygon or outside.
  if (isFilled(windingLeftOf(rising, region), rule)) return true;
  const Pieces outline = piecesOf(ring);
  return std::any_of(region.begin(), region.end(), [&](const Piece& p) {
    return p.start == p.a && p.isOfRegion && windingLeftOf({2 * p.start.x, 2 * p.start.y}, outline) != 0;
  });
}

namespace {

/// The atoms of the cell. Polygons that stand in the way become groups. Nothing if edges cross in too many points.
std::optional<List<Atom>> atomsOf(Ground& ground, PieceSpan region, const Stroke& stroke) {
  if (auto calm = calmAtoms(ground, region, stroke)) return calm;
  for (;;) {
    auto arrangement = arrangementOf(ground, region);
    if (!arrangement) return std::nullopt;
    Rounding result = snapRounded(std::move(*arrangement), stroke.rule);
    if (result.inTheWay.empty()) return std::move(result.atoms);
    for (const std::size_t k : result.inTheWay) ground.groups[k] = k;
  }
}

/// By an arrangement. A ground without known points and sides gets them.
CellEdit arranged(Ground& ground, const List<bool>& meeting, PieceSpan region, const Stroke& stroke) {
  CellEdit edit;
  const auto atoms = addKnown(ground, region) ? atomsOf(ground, region, stroke) : std::nullopt;
  edit.isTooMuch = !atoms;
  if (!atoms) return edit;
  edit = divided(ground, *atoms, stroke);
  for (const std::size_t k : edit.gone)
    if (!meeting[k]) edit.rounded.push_back(k);
  return edit;
}

}  // namespace

List<bool> meetingOf(const List<CellPolygon>& polygons, PieceSpan region, FillRule rule) {
  List<bool> meeting;
  meeting.reserve(polygons.size());
  for (const CellPolygon& p : polygons) meeting.push_back(meets(region, rule, p.ring));
  return meeting;
}

namespace {

/// Whether rings have the same vertices in the same order.
bool isSameRing(const Points& a, const Points& b) {
  const auto first = std::ranges::find(b, a[0]);
  return a.size() == b.size() && first != b.end() && std::equal(first, b.end(), a.begin()) &&
         std::equal(b.begin(), first, a.begin() + (b.end() - first));
}

/// Polygons that come out as they were stay: chords of holes and what is cut off may part a union where it was parted.
CellEdit withoutSame(CellEdit edit, const List<CellPolygon>& old) {
  std::erase_if(edit.placed, [&](const NewPart& part) {
    const auto same = std::ranges::find_if(
        edit.gone, [&](std::size_t k) { return old[k].block == part.block && isSameRing(part.ring, old[k].ring); });
    if (same == edit.gone.end()) return false;
    std::erase(edit.rounded, *same);
    edit.gone.erase(same);
    return true;
  });
  for (NewPart& part : edit.placed)
    std::erase_if(part.from, [&](std::size_t k) { return std::ranges::find(edit.gone, k) == edit.gone.end(); });
  return edit;
}

}  // namespace

CellEdit editOf(std::span<const PlacedPolygon> polygons, PieceSpan region, const Stroke& stroke) {
  if (auto edit = plainEdit(polygons, region, stroke)) return std::move(*edit);
  List<CellPolygon> old;
  old.reserve(polygons.size());
  for (const PlacedPolygon& p : polygons) {
    old.push_back({{}, p.block});
    old.back().ring.reserve(p.vertices.size());
    for (const LocalPoint v : p.vertices) old.back().ring.push_back({v.x, v.y});
  }
  const List<bool> meeting = meetingOf(old, region, stroke.rule);
  Ground ground = groundOf(old, meeting);
  auto edit = clippedEdit(ground, region, stroke);
  return withoutSame(edit ? std::move(*edit) : arranged(ground, meeting, region, stroke), old);
}

CellEdit arrangedEdit(const List<CellPolygon>& polygons, PieceSpan region, const Stroke& stroke) {
  const List<bool> meeting = meetingOf(polygons, region, stroke.rule);
  Ground ground = groundOf(polygons, meeting);
  return arranged(ground, meeting, region, stroke);
}

}  // namespace lgs::brush
