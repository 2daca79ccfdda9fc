#include "content.h"

#include "geometry/ring.h"

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
  std::sort(vertices.begin(), vertices.end());
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
  std::vector<LocalPoint> cuts;
  for (std::size_t slot = 0; slot < polygons.size(); ++slot) {
    const PolygonView polygon = polygons[slot];
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const LocalPoint a = polygon[i], b = nextVertex(polygon, i);
      cutEdge(a, b, candidates(a, b, vertices), cuts);
      for (std::size_t k = 1; k < cuts.size(); ++k) edges.push_back({cuts[k - 1], cuts[k], static_cast<Slot>(slot)});
    }
  }
  std::sort(edges.begin(), edges.end());
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
  for (unsigned s = 0; s < kSides; ++s) {
    Side& side = content.sides[s];
    for (const AtomicEdge& edge : edges) {
      if (sideOf(edge) != s) continue;
      const std::int32_t a = along(s, edge.start), b = along(s, edge.end);
      side.covered.push_back({std::min(a, b), std::max(a, b), edge.slot});
    }
    std::sort(side.covered.begin(), side.covered.end(), [](auto& a, auto& b) { return a.begin < b.begin; });
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
  std::sort(contacts.begin(), contacts.end());
  contacts.erase(std::unique(contacts.begin(), contacts.end()), contacts.end());
}

/// The interior half-edges at a vertex, counter-clockwise from the direction `from`.
std::vector<Spoke> fanAt(const Content& content, LocalPoint v, Vector from) {
  struct Directed {
    Vector direction;
    Spoke spoke;
  };
  std::vector<Directed> directed;
  for (std::uint32_t k = 0; k < content.interior.size(); ++k) {
    const LocalPoint start = content.interior[k].ends.start(), end = content.interior[k].ends.end();
    if (start == v) directed.push_back({end - v, {k, 0, 1}});
    if (end == v) directed.push_back({start - v, {k, 0, 0}});
  }
  // The plane is turned so that `from` is the x axis.
  const auto turned = [&](Vector d) { return Vector{dot(from, d), cross(from, d)}; };
  std::sort(directed.begin(), directed.end(), [&](auto& a, auto& b) {
    return sameDirection(a.direction, b.direction) ? a.spoke.segment < b.spoke.segment
                                                   : angleLess(turned(a.direction), turned(b.direction));
  });
  std::vector<Spoke> fan;
  fan.reserve(directed.size());
  std::uint32_t rank = 0;
  for (std::size_t k = 0; k < directed.size(); ++k) {
    Spoke spoke = directed[k].spoke;
    if (k > 0 && !sameDirection(directed[k - 1].direction, directed[k].direction)) ++rank;
    spoke.direction = rank & kMaxDirection;
    fan.push_back(spoke);
  }
  return fan;
}

SpokeRange storeRimFan(Content& content, LocalPoint v, Vector from) {
  const std::vector<Spoke> fan = fanAt(content, v, from);
  SpokeRange range{static_cast<std::uint32_t>(fan.size()), static_cast<std::uint32_t>(content.spokes.size()), {}};
  content.widestFan = std::max(content.widestFan, range.count);
  if (!fan.empty()) {
    range.first = fan.front();
    content.spokes.insert(content.spokes.end(), fan.begin() + 1, fan.end());
  }
  return range;
}

/// Law 2 at the vertices inside the cell.
void linkInside(Content& content, std::span<const LocalPoint> vertices) {
  for (const LocalPoint v : vertices) {
    if (isOnRim(v)) continue;
    radialMatch(
        fanAt(content, v, {1, 0}), InteriorSegment::kNone,
        [&](std::uint32_t s, std::uint32_t other) { content.interior[s].predecessor = other; },
        [&](std::uint32_t s, std::uint32_t other) { content.interior[s].successor = other; });
  }
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
  linkInside(content, vertices);
  for (unsigned s = 0; s < kSides; ++s) {
    content.corners[s] = storeRimFan(content, kCorners[s], kSideDirections[s]);
    for (RimPoint& point : content.sides[s].points)
      point.spokes = storeRimFan(content, pointAt(s, point.at), kSideDirections[s]);
  }
  content.facts = factsOf(content);
  return content;
}

}  // namespace lgs::detail
