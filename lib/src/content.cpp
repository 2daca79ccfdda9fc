#include "content.h"

#include "geometry/ring.h"
#include "geometry/sort.h"

#include <algorithm>
#include <tuple>

namespace lgs::detail {
namespace {

/// A piece of a polygon edge without a vertex in between.
struct AtomicEdge {
  LocalPoint start;
  LocalPoint end;
  Slot slot;
  friend auto operator<=>(const AtomicEdge&, const AtomicEdge&) = default;
};

std::vector<LocalPoint> allVertices(std::span<const PolygonView> polygons) {
  std::vector<LocalPoint> vertices;
  for (const PolygonView polygon : polygons) vertices.insert(vertices.end(), polygon.begin(), polygon.end());
  detail::sort(vertices);
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

/// Those of the vertices, which are sorted by x, that may lie on the edge a→b.
std::span<const LocalPoint> candidates(LocalPoint a, LocalPoint b, std::span<const LocalPoint> vertices) {
  const auto [low, high] = std::minmax(a.x, b.x);
  const auto first = std::ranges::lower_bound(vertices, low, {}, &LocalPoint::x);
  const auto last = std::ranges::upper_bound(first, vertices.end(), high, {}, &LocalPoint::x);
  return {first, last};
}

/// Every polygon edge, cut at every vertex on it. Sorted by start, then end.
std::vector<AtomicEdge> atomicEdges(std::span<const PolygonView> polygons, std::span<const LocalPoint> vertices) {
  std::vector<AtomicEdge> edges;
  edges.reserve(vertices.size());
  std::vector<LocalPoint> cuts;
  for (std::size_t slot = 0; slot < polygons.size(); ++slot) {
    const PolygonView polygon = polygons[slot];
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const LocalPoint a = polygon[i], b = nextVertex(polygon, i);
      cutEdge(a, b, candidates(a, b, vertices), cuts);
      for (std::size_t k = 1; k < cuts.size(); ++k) edges.push_back({cuts[k - 1], cuts[k], static_cast<Slot>(slot)});
    }
  }
  detail::sort(edges);
  return edges;
}

bool isOnSide(unsigned side, LocalPoint p) { return pointAt(side, along(side, p)) == p; }

/// The side that an edge lies along, or kSides.
unsigned sideOf(const AtomicEdge& edge) {
  for (unsigned side = 0; side < kSides; ++side)
    if (isOnSide(side, edge.start) && isOnSide(side, edge.end)) return side;
  return kSides;
}

bool isOnRim(LocalPoint p) { return p.x == 0 || p.y == 0 || p.x == kUnitsPerCell || p.y == kUnitsPerCell; }

void fillSides(Content& content, std::span<const AtomicEdge> edges, std::span<const LocalPoint> vertices) {
  for (const AtomicEdge& edge : edges) {
    const unsigned s = sideOf(edge);
    if (s == kSides) continue;
    const std::int32_t a = along(s, edge.start), b = along(s, edge.end);
    content.sides[s].covered.push_back({std::min(a, b), std::max(a, b), edge.slot});
  }
  for (unsigned s = 0; s < kSides; ++s) {
    Side& side = content.sides[s];
    detail::sort(side.covered, [](auto& a, auto& b) { return a.begin < b.begin; });
    for (const LocalPoint v : vertices)
      if (isOnSide(s, v) && along(s, v) > 0 && along(s, v) < kUnitsPerCell) side.points.push_back({along(s, v), {}});
    // `vertices` is sorted by x, then y, so the points of each side are in increasing order already.
  }
}

/// Law 1 inside the cell.
void fillInterior(Content& content, std::span<const AtomicEdge> edges,
                  std::span<const std::pair<Slot, Slot>> preserved) {
  for (const AtomicEdge& edge : edges) {
    if (sideOf(edge) != kSides) continue;
    const AtomicEdge reversed{edge.end, edge.start, 0};
    const auto found = std::lower_bound(edges.begin(), edges.end(), reversed);
    if (found != edges.end() && found->start == reversed.start && found->end == reversed.end) {
      const std::pair<Slot, Slot> contact = std::minmax(edge.slot, found->slot);
      content.contacts.push_back(contact);
      if (!std::binary_search(preserved.begin(), preserved.end(), contact)) continue;
    }
    content.interior.push_back(
        {PackedEnds::of(edge.start, edge.end), InteriorSegment::kRim, InteriorSegment::kRim, edge.slot});
  }
  auto& contacts = content.contacts;
  detail::sort(contacts);
  contacts.erase(std::unique(contacts.begin(), contacts.end()), contacts.end());
}

/// The interior half-edges of a content, by vertex.
class Fans {
 public:
  explicit Fans(const std::vector<InteriorSegment>& interior) {
    ends_.reserve(2 * interior.size());
    for (std::uint32_t k = 0; k < interior.size(); ++k) {
      const LocalPoint start = interior[k].ends.start(), end = interior[k].ends.end();
      ends_.push_back({start, end - start, {k, 0, 1}});
      ends_.push_back({end, start - end, {k, 0, 0}});
    }
    detail::sort(ends_, [](const End& a, const End& b) { return a.vertex < b.vertex; });
  }

  /// Those at a vertex, counter-clockwise from the direction `from`. They are valid until the next call.
  std::span<const Spoke> at(LocalPoint vertex, Vector from) {
    const auto first = std::ranges::lower_bound(ends_, vertex, {}, &End::vertex);
    const auto last = std::ranges::upper_bound(first, ends_.end(), vertex, {}, &End::vertex);
    const std::span<End> ends(first, last);
    // The plane is turned so that `from` is the x axis.
    const auto turned = [&](Vector d) { return Vector{dot(from, d), cross(from, d)}; };
    detail::sort(ends, [&](const End& a, const End& b) {
      return sameDirection(a.direction, b.direction) ? a.spoke.segment < b.spoke.segment
                                                     : angleLess(turned(a.direction), turned(b.direction));
    });
    fan_.clear();
    std::uint32_t rank = 0;
    for (std::size_t k = 0; k < ends.size(); ++k) {
      if (k > 0 && !sameDirection(ends[k - 1].direction, ends[k].direction)) ++rank;
      fan_.push_back(ends[k].spoke);
      fan_.back().direction = rank & kMaxDirection;
    }
    return fan_;
  }

 private:
  struct End {
    LocalPoint vertex;
    Vector direction;
    Spoke spoke;
  };
  std::vector<End> ends_;  ///< sorted by vertex
  std::vector<Spoke> fan_;
};

SpokeRange storeRimFan(Content& content, std::span<const Spoke> fan) {
  SpokeRange range{static_cast<std::uint32_t>(fan.size()), static_cast<std::uint32_t>(content.spokes.size()), {}};
  content.widestFan = std::max(content.widestFan, range.count);
  if (!fan.empty()) {
    range.first = fan.front();
    content.spokes.insert(content.spokes.end(), fan.begin() + 1, fan.end());
  }
  return range;
}

/// Law 2 at the vertices inside the cell.
void linkInside(Content& content, std::span<const LocalPoint> vertices, Fans& fans) {
  for (const LocalPoint v : vertices) {
    if (isOnRim(v)) continue;
    radialMatch(
        fans.at(v, {1, 0}), InteriorSegment::kNone,
        [&](std::uint32_t s, std::uint32_t other) { content.interior[s].predecessor = other; },
        [&](std::uint32_t s, std::uint32_t other) { content.interior[s].successor = other; });
  }
}

/// Law 2 between the cell's own half-edges at a corner. Where nothing is preserved, incoming and outgoing ones take
/// turns, and the wedge from an incoming one to the next is free. Where something is, Linking matches whole fans.
void linkAtCorner(Content& content, unsigned corner, std::span<const Spoke> fan) {
  for (std::size_t k = 1; k < fan.size(); ++k) {
    const Spoke &before = fan[k - 1], &after = fan[k];
    if (before.outgoing || !after.outgoing) continue;
    content.interior[before.segment].successor = after.segment;
    content.interior[after.segment].predecessor = before.segment;
  }
  const auto place = [&](const Spoke& spoke) {
    return static_cast<std::uint16_t>((spoke.segment < CornerEnds::kMaxPlace ? spoke.segment + 1 : 0) << 4 * corner);
  };
  if (fan.empty()) return;
  if (fan.front().outgoing) content.cornerEnds.first |= place(fan.front());
  if (!fan.back().outgoing) content.cornerEnds.last |= place(fan.back());
}

/// One interval without a rim point can only run from corner to corner.
bool isWhole(const Side& side) { return side.covered.size() == 1 && side.points.empty(); }

Facts factsOf(const Content& content) {
  const bool linkedInside = std::any_of(content.interior.begin(), content.interior.end(), [](const InteriorSegment& s) {
    return s.predecessor != InteriorSegment::kRim || s.successor != InteriorSegment::kRim;
  });
  const bool rimPoints =
      std::any_of(content.sides.begin(), content.sides.end(), [](const Side& side) { return !side.points.empty(); });
  unsigned facts =
      (rimPoints ? kRimPoints : 0u) | (content.interior.empty() ? 0u : kInside) | (linkedInside ? kLinkedInside : 0u);
  for (unsigned s = 0; s < kSides; ++s) facts |= (isWhole(content.sides[s]) ? 1u : 0u) << s;
  return static_cast<Facts>(facts);
}

/// The direction of each side. At a vertex on the side, the cell's interior directions follow it counter-clockwise.
constexpr std::array<Vector, 4> kSideDirections{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

}  // namespace

Content buildContent(std::span<const PolygonView> polygons, std::span<const std::pair<Slot, Slot>> preserved) {
  const std::vector<LocalPoint> vertices = allVertices(polygons);
  const std::vector<AtomicEdge> edges = atomicEdges(polygons, vertices);
  Content content;
  fillSides(content, edges, vertices);
  fillInterior(content, edges, preserved);
  Fans fans(content.interior);
  linkInside(content, vertices, fans);
  for (unsigned s = 0; s < kSides; ++s) {
    const std::span<const Spoke> fan = fans.at(kCorners[s], kSideDirections[s]);
    content.corners[s] = storeRimFan(content, fan);
    if (preserved.empty()) linkAtCorner(content, s, fan);
    for (RimPoint& point : content.sides[s].points)
      point.spokes = storeRimFan(content, fans.at(pointAt(s, point.at), kSideDirections[s]));
  }
  content.facts = factsOf(content);
  return content;
}

}  // namespace lgs::detail
