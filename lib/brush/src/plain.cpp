#include "plain.h"

#include "geometry/ring.h"
#include "geometry/sort.h"
#include "outline.h"
#include "rim.h"
#include "snap.h"

#include <algorithm>
#include <array>
#include <utility>

namespace lgs::brush {
namespace {

using detail::nextVertex;

constexpr std::int64_t kEnd = kUnitsPerCell;
/// How far a point of the rim is from the lower left corner, counter-clockwise.
std::int64_t alongRim(Point p) {
  if (p.y == 0) return p.x;
  if (p.x == kEnd) return kEnd + p.y;
  return p.y == kEnd ? 3 * kEnd - p.x : 4 * kEnd - p.y;
}

/// Whether an edge of the region goes through the pixel of a known point beside its ends. One that is cut at a corner
/// of the cell may: it can cross the rim beside the corner too.
bool bends(PieceSpan region, const Points& ring) {
  for (const Piece& p : region) {
    if (!p.isOfRegion) continue;
    if (isCorner(p.start) || isCorner(p.end)) return true;
    const auto box = detail::boundingBox(std::array{p.start, p.end});
    const auto isOnWay = [&](Point z) {
      return z.x >= box.min.x && z.x <= box.max.x && z.y >= box.min.y && z.y <= box.max.y && z != p.start &&
             z != p.end && passes(p.a, p.b, z);
    };
    if (std::ranges::any_of(ring, isOnWay) || std::ranges::any_of(kCorners, isOnWay)) return true;
  }
  return false;
}

/// A full cell without a convex ring: one polygon beside each chain of its edges that runs through the cell. Nothing if
/// the ring touches the rim in fewer than two points, or if two polygons would begin in the same vertex.
std::optional<List<Points>> fullWithout(const Points& ring) {
  List<Points> parts;
  for (std::size_t first = 0; first < ring.size(); ++first) {
    if (!liesOnRim(ring[first]) || runsAlongRim(ring[first], nextVertex(ring, first))) continue;
    Points part;
    part.reserve(ring.size() + kCorners.size());
    part.push_back(ring[first]);
    std::size_t k = first;
    do {
      k = k + 1 == ring.size() ? 0 : k + 1;
      part.push_back(ring[k]);
    } while (!liesOnRim(part.back()));
    if (part.back() == part.front()) return std::nullopt;
    const std::int64_t from = alongRim(part.front());
    const auto ahead = [from](Point p) { return (alongRim(p) - from + 4 * kEnd) % (4 * kEnd); };
    const std::int64_t to = ahead(part.back());
    std::ranges::reverse(part);
    const auto side = static_cast<std::size_t>(from / kEnd);
    for (std::size_t n = 1; n <= 4 && ahead(kCorners[(side + n) % 4]) < to; ++n)
      part.push_back(kCorners[(side + n) % 4]);
    parts.push_back(straightened(part));
  }
  const auto begin = [](const Points& part) { return part.front(); };
  detail::sort(parts, [&](const Points& a, const Points& b) { return begin(a) < begin(b); });
  if (parts.empty() || std::ranges::adjacent_find(parts, {}, begin) != parts.end()) return std::nullopt;
  return parts;
}

}  // namespace

std::optional<CellEdit> plainEdit(std::span<const PlacedPolygon> polygons, PieceSpan region, const Stroke& stroke) {
  const bool isEmpty = polygons.empty();
  if (!isEmpty && (polygons.size() > 1 || detail::doubleArea(polygons[0].vertices) != 2 * kEnd * kEnd))
    return std::nullopt;
  if (!isEmpty && stroke.deed == Deed::replace && polygons[0].block == stroke.block) return std::nullopt;
  const bool keepsAll =
      isEmpty ? stroke.deed == Deed::carve : stroke.deed == Deed::fill || stroke.stays(polygons[0].block);
  if (keepsAll) return CellEdit{};
  if (!isConvexRing(region)) return std::nullopt;
  Points ring;
  ring.reserve(kMostConvexPieces);
  for (const Piece& p : region) ring.push_back(p.start);
  if (bends(region, ring)) return std::nullopt;

  CellEdit edit;
  if (!isEmpty) {
    auto parts = fullWithout(ring);
    if (!parts) return std::nullopt;
    edit.gone = {0};
    for (Points& part : *parts) edit.placed.push_back({std::move(part), polygons[0].block, {0}});
  }
  if (stroke.deed != Deed::carve) edit.placed.push_back({straightened(ring), stroke.block, {}});
  return edit;
}

}  // namespace lgs::brush
