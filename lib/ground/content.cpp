#include "ground/content.h"

#include "geometry/ring.h"
#include "geometry/sort.h"

#include <algorithm>

namespace lgs::detail {
namespace {

/// Index of a vertex among all those of the cell in order.
using Rank = std::uint32_t;

struct Vertices {
  std::vector<LocalPoint> points;  ///< in order, each once
  std::vector<Rank> ranks;         ///< of the polygons' vertices, one polygon after the other
};

Vertices verticesOf(std::span<const PolygonView> polygons) {
  const std::vector<PlacedVertex> order = inOrder(polygons);
  Vertices vertices;
  vertices.points.reserve(order.size());
  vertices.ranks.resize(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k == 0 || !isSamePoint(order[k - 1], order[k])) vertices.points.push_back(pointOf(order[k]));
    vertices.ranks[static_cast<std::size_t>(indexOf(order[k]))] = static_cast<Rank>(vertices.points.size() - 1);
  }
  return vertices;
}

/// A directed edge at one of its ends, without a vertex in between.
struct HalfEdge {
  Rank at, to;
  std::uint32_t what;  ///< the slot of its polygon, or the interior edge and whether it leaves
};

/// Sorts half-edges by one of their ends, equal ones as they are, and returns where those of each vertex begin.
/// (Distribution counting: Knuth, TAOCP 3, 5.2, Algorithm D.)
std::vector<std::uint32_t> sortByEnd(std::vector<HalfEdge>& edges, Rank HalfEdge::*end, std::size_t vertices) {
  std::vector<std::uint32_t> first(vertices + 2);
  for (const HalfEdge& e : edges) ++first[e.*end + std::size_t{2}];
  for (std::size_t v = 2; v < first.size(); ++v) first[v] += first[v - 1];
  std::vector<HalfEdge> sorted(edges.size());
  for (const HalfEdge& e : edges) sorted[first[e.*end + std::size_t{1}]++] = e;
  edges.swap(sorted);
  return first;
}

/// Every polygon edge, cut at every vertex on it.
std::vector<HalfEdge> atomicEdges(std::span<const PolygonView> polygons, const Vertices& vertices) {
  std::vector<HalfEdge> edges;
  edges.reserve(vertices.ranks.size());
  const Rank* ranks = vertices.ranks.data();
  for (std::size_t slot = 0; slot < polygons.size(); ++slot) {
    const std::size_t count = polygons[slot].size();
    for (std::size_t i = 0; i < count; ++i) {
      Rank from = ranks[i];
      const Rank to = ranks[i + 1 == count ? 0 : i + 1], step = from < to ? 1 : ~Rank{0};
      const LocalPoint a = vertices.points[from], b = vertices.points[to];
      // What lies on an edge comes between its ends in order. On an edge of a polygon that is alone lies nothing.
      for (Rank r = from + step; polygons.size() > 1 && r != to; r += step) {
        const LocalPoint p = vertices.points[r];
        if (p.y < std::min(a.y, b.y) || p.y > std::max(a.y, b.y) || !isOnOpenSegment(p, a, b)) continue;
        edges.push_back({from, r, static_cast<std::uint32_t>(slot)});
        from = r;
      }
      edges.push_back({from, to, static_cast<std::uint32_t>(slot)});
    }
    ranks += count;
  }
  return edges;
}

bool isOnSide(unsigned side, LocalPoint p) { return pointAt(side, along(side, p)) == p; }

/// The side that an edge lies along, or kSides.
unsigned sideOf(LocalPoint start, LocalPoint end) {
  for (unsigned side = 0; side < kSides; ++side)
    if (isOnSide(side, start) && isOnSide(side, end)) return side;
  return kSides;
}

bool isOnRim(LocalPoint p) { return p.x == 0 || p.y == 0 || p.x == kUnitsPerCell || p.y == kUnitsPerCell; }

void addRimPoints(Content& content, std::span<const LocalPoint> vertices) {
  for (const LocalPoint v : vertices) {
    if (!isOnRim(v)) continue;
    for (unsigned s = 0; s < kSides; ++s) {
      Side& side = content.sides[s];
      if (isOnSide(s, v) && along(s, v) > 0 && along(s, v) < kUnitsPerCell) side.points.push_back({along(s, v), {}});
    }
  }
  // `vertices` is sorted by x, then y, so the points of each side are in increasing order already.
}

/// Puts the edges on the sides or, by law 1, inside the cell. Returns both ends of each of those inside.
std::vector<HalfEdge> placeEdges(Content& content, std::vector<HalfEdge> edges, std::span<const LocalPoint> vertices,
                                 std::span<const std::pair<Slot, Slot>> preserved) {
  sortByEnd(edges, &HalfEdge::to, vertices.size());
  const std::vector<std::uint32_t> first = sortByEnd(edges, &HalfEdge::at, vertices.size());
  std::vector<HalfEdge> inside;
  std::vector<std::uint64_t> contacts;
  for (const HalfEdge& edge : edges) {
    const LocalPoint start = vertices[edge.at], end = vertices[edge.to];
    const auto slot = static_cast<Slot>(edge.what);
    if (const unsigned s = sideOf(start, end); s != kSides) {
      const std::int32_t a = along(s, start), b = along(s, end);
      content.sides[s].covered.push_back({std::min(a, b), std::max(a, b), slot});
      continue;
    }
    std::size_t reversed = first[edge.to];
    const std::size_t last = first[edge.to + std::size_t{1}];
    while (reversed < last && edges[reversed].to != edge.at) ++reversed;
    if (reversed < last) {
      const std::pair<Slot, Slot> contact = std::minmax(slot, static_cast<Slot>(edges[reversed].what));
      if (slot == contact.first) contacts.push_back(std::uint64_t{contact.first} << 16 | contact.second);
      if (!std::binary_search(preserved.begin(), preserved.end(), contact)) continue;
    }
    const auto segment = static_cast<std::uint32_t>(content.interior.size());
    inside.push_back({edge.at, edge.to, segment << 1 | 1});
    inside.push_back({edge.to, edge.at, segment << 1});
    content.interior.push_back({PackedEnds::of(start, end), InteriorEdge::kRim, InteriorEdge::kRim, slot});
  }
  for (Side& side : content.sides) detail::sort(side.covered, [](auto& a, auto& b) { return a.begin < b.begin; });
  detail::sort(contacts);
  for (std::size_t k = 0; k < contacts.size(); ++k)
    if (k == 0 || contacts[k - 1] != contacts[k])
      content.contacts.emplace_back(static_cast<Slot>(contacts[k] >> 16), static_cast<Slot>(contacts[k]));
  return inside;
}

/// The interior half-edges of a content, by vertex.
class Fans {
 public:
  Fans(std::vector<HalfEdge> inside, std::span<const LocalPoint> vertices)
      : vertices_(vertices), edges_(std::move(inside)), first_(sortByEnd(edges_, &HalfEdge::at, vertices.size())) {}

  /// Those at a vertex, counter-clockwise from the direction `from`. They are valid until the next call.
  std::span<const Spoke> at(Rank vertex, Vector from) {
    const std::uint32_t first = first_[vertex];
    const auto ends = std::span(edges_).subspan(first, first_[vertex + std::size_t{1}] - first);
    const auto direction = [&](const HalfEdge& e) { return vertices_[e.to] - vertices_[e.at]; };
    // The plane is turned so that `from` is the x axis.
    const auto turned = [&](Vector d) { return Vector{dot(from, d), cross(from, d)}; };
    detail::sort(ends, [&](const HalfEdge& a, const HalfEdge& b) {
      return a.to == b.to ? a.what < b.what : angleLess(turned(direction(a)), turned(direction(b)));
    });
    fan_.clear();
    std::uint32_t rank = 0;
    for (std::size_t k = 0; k < ends.size(); ++k) {
      if (k > 0 && ends[k - 1].to != ends[k].to) ++rank;
      fan_.push_back({ends[k].what >> 1, rank & kMaxDirection, ends[k].what & 1});
    }
    return fan_;
  }
  std::span<const Spoke> at(LocalPoint point, Vector from) {
    const auto found = std::ranges::lower_bound(vertices_, point);
    if (found == vertices_.end() || *found != point) return {};
    return at(static_cast<Rank>(found - vertices_.begin()), from);
  }

 private:
  std::span<const LocalPoint> vertices_;
  std::vector<HalfEdge> edges_;
  std::vector<std::uint32_t> first_;  ///< of each vertex
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
  for (Rank v = 0; v < vertices.size(); ++v) {
    if (isOnRim(vertices[v])) continue;
    radialMatch(
        fans.at(v, {1, 0}), InteriorEdge::kNone,
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
  const bool linkedInside = std::any_of(content.interior.begin(), content.interior.end(), [](const InteriorEdge& s) {
    return s.predecessor != InteriorEdge::kRim || s.successor != InteriorEdge::kRim;
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
  const Vertices vertices = verticesOf(polygons);
  Content content;
  addRimPoints(content, vertices.points);
  Fans fans(placeEdges(content, atomicEdges(polygons, vertices), vertices.points, preserved), vertices.points);
  linkInside(content, vertices.points, fans);
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
