#include "ground/content.h"

#include "geometry/ring.h"
#include "geometry/sort.h"

#include <algorithm>

namespace lgs::detail {
namespace {

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

SpokeRange storeRimFan(Content& content, std::span<const Spoke> fan) {
  SpokeRange range{static_cast<std::uint32_t>(fan.size()), static_cast<std::uint32_t>(content.spokes.size()), {}};
  content.widestFan = std::max(content.widestFan, range.count);
  if (!fan.empty()) {
    range.first = fan.front();
    content.spokes.insert(content.spokes.end(), fan.begin() + 1, fan.end());
  }
  return range;
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

// --- The vertices, and the edges between them

void ContentBuilder::takeVertices(std::span<const PolygonView> polygons) {
  inOrder(polygons, order_);
  points_.clear();
  ranks_.resize(order_.size());
  for (std::size_t k = 0; k < order_.size(); ++k) {
    if (k == 0 || !isSamePoint(order_[k - 1], order_[k])) points_.push_back(pointOf(order_[k]));
    ranks_[static_cast<std::size_t>(indexOf(order_[k]))] = static_cast<Rank>(points_.size() - 1);
  }
}

/// Every polygon edge, cut at every vertex on it.
void ContentBuilder::cutEdges(std::span<const PolygonView> polygons) {
  edges_.clear();
  const Rank* ranks = ranks_.data();
  for (std::size_t slot = 0; slot < polygons.size(); ++slot) {
    const std::size_t count = polygons[slot].size();
    for (std::size_t i = 0; i < count; ++i) {
      Rank from = ranks[i];
      const Rank to = ranks[i + 1 == count ? 0 : i + 1], step = from < to ? 1 : ~Rank{0};
      const LocalPoint a = points_[from], b = points_[to];
      // What lies on an edge comes between its ends in order. On an edge of a polygon that is alone lies nothing.
      for (Rank r = from + step; polygons.size() > 1 && r != to; r += step) {
        const LocalPoint p = points_[r];
        if (p.y < std::min(a.y, b.y) || p.y > std::max(a.y, b.y) || !isOnOpenSegment(p, a, b)) continue;
        edges_.push_back({from, r, static_cast<std::uint32_t>(slot)});
        from = r;
      }
      edges_.push_back({from, to, static_cast<std::uint32_t>(slot)});
    }
    ranks += count;
  }
}

/// Sorts half-edges by one of their ends, equal ones as they are. first_ says where those of each vertex begin.
/// (Distribution counting: Knuth, TAOCP 3, 5.2, Algorithm D.)
void ContentBuilder::sortByEnd(std::vector<HalfEdge>& edges, Rank HalfEdge::*end) {
  first_.assign(points_.size() + 2, 0);
  for (const HalfEdge& e : edges) ++first_[e.*end + std::size_t{2}];
  for (std::size_t v = 2; v < first_.size(); ++v) first_[v] += first_[v - 1];
  sorted_.resize(edges.size());
  for (const HalfEdge& e : edges) sorted_[first_[e.*end + std::size_t{1}]++] = e;
  edges.swap(sorted_);
}

/// Puts the edges on the sides or, by law 1, inside the cell. Both ends of each of those become ends_, by vertex.
void ContentBuilder::placeEdges(Content& content, std::span<const std::pair<Slot, Slot>> preserved) {
  sortByEnd(edges_, &HalfEdge::to);
  sortByEnd(edges_, &HalfEdge::at);
  ends_.clear();
  contacts_.clear();
  interior_.clear();
  for (const HalfEdge& edge : edges_) {
    const LocalPoint start = points_[edge.at], end = points_[edge.to];
    const auto slot = static_cast<Slot>(edge.what);
    if (const unsigned s = sideOf(start, end); s != kSides) {
      const std::int32_t a = along(s, start), b = along(s, end);
      content.sides[s].covered.push_back({std::min(a, b), std::max(a, b), slot});
      continue;
    }
    std::size_t reversed = first_[edge.to];
    const std::size_t last = first_[edge.to + std::size_t{1}];
    while (reversed < last && edges_[reversed].to != edge.at) ++reversed;
    if (reversed < last) {
      const std::pair<Slot, Slot> contact = std::minmax(slot, static_cast<Slot>(edges_[reversed].what));
      if (slot == contact.first) contacts_.push_back(std::uint64_t{contact.first} << 16 | contact.second);
      if (!std::binary_search(preserved.begin(), preserved.end(), contact)) continue;
    }
    const auto segment = static_cast<std::uint32_t>(interior_.size());
    ends_.push_back({edge.at, edge.to, segment << 1 | 1});
    ends_.push_back({edge.to, edge.at, segment << 1});
    interior_.push_back({PackedEnds::of(start, end), InteriorEdge::kRim, InteriorEdge::kRim, slot});
  }
  content.interior.assign(interior_.begin(), interior_.end());
  for (Side& side : content.sides) detail::sort(side.covered, [](auto& a, auto& b) { return a.begin < b.begin; });
  detail::sort(contacts_);
  for (std::size_t k = 0; k < contacts_.size(); ++k)
    if (k == 0 || contacts_[k - 1] != contacts_[k])
      content.contacts.emplace_back(static_cast<Slot>(contacts_[k] >> 16), static_cast<Slot>(contacts_[k]));
  sortByEnd(ends_, &HalfEdge::at);
}

// --- The fans

/// The interior half-edges at a vertex, counter-clockwise from the direction `from`. Valid until the next call.
std::span<const Spoke> ContentBuilder::fanAt(Rank vertex, Vector from) {
  const std::uint32_t first = first_[vertex];
  const auto ends = std::span(ends_).subspan(first, first_[vertex + std::size_t{1}] - first);
  const auto direction = [&](const HalfEdge& e) { return points_[e.to] - points_[e.at]; };
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

std::span<const Spoke> ContentBuilder::fanAt(LocalPoint point, Vector from) {
  const auto found = std::ranges::lower_bound(points_, point);
  if (found == points_.end() || *found != point) return {};
  return fanAt(static_cast<Rank>(found - points_.begin()), from);
}

/// Law 2 at the vertices inside the cell.
void ContentBuilder::linkInside(Content& content) {
  for (Rank v = 0; v < points_.size(); ++v) {
    if (isOnRim(points_[v])) continue;
    radialMatch(
        fanAt(v, {1, 0}), InteriorEdge::kNone,
        [&](std::uint32_t s, std::uint32_t other) { content.interior[s].predecessor = other; },
        [&](std::uint32_t s, std::uint32_t other) { content.interior[s].successor = other; });
  }
}

Content ContentBuilder::build(std::span<const PolygonView> polygons, std::span<const std::pair<Slot, Slot>> preserved) {
  takeVertices(polygons);
  cutEdges(polygons);
  Content content;
  addRimPoints(content, points_);
  placeEdges(content, preserved);
  linkInside(content);
  for (unsigned s = 0; s < kSides; ++s) {
    const std::span<const Spoke> fan = fanAt(kCorners[s], kSideDirections[s]);
    content.corners[s] = storeRimFan(content, fan);
    if (preserved.empty()) linkAtCorner(content, s, fan);
    for (RimPoint& point : content.sides[s].points)
      point.spokes = storeRimFan(content, fanAt(pointAt(s, point.at), kSideDirections[s]));
  }
  content.facts = factsOf(content);
  return content;
}

}  // namespace lgs::detail
