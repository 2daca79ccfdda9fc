#include "ground/content.h"

#include "geometry/ring.h"
#include "geometry/sort.h"

#include <algorithm>
#include <bit>

namespace lgs::detail {
namespace {

/// Bit s, if a point is on side s. At a corner there are two.
std::uint8_t sidesAt(LocalPoint p) {
  return static_cast<std::uint8_t>((p.y == 0 ? 1u << kSouth : 0u) | (p.x == kUnitsPerCell ? 1u << kEast : 0u) |
                                   (p.y == kUnitsPerCell ? 1u << kNorth : 0u) | (p.x == 0 ? 1u << kWest : 0u));
}

/// The side that a point with these bits is on; of the two at a corner the one that starts there.
unsigned sideFrom(unsigned sides) {
  constexpr unsigned kSouthWest = 1u << kSouth | 1u << kWest;
  return sides == kSouthWest ? unsigned{kSouth} : static_cast<unsigned>(std::bit_width(sides)) - 1;
}

/// One interval without a rim point can only run from corner to corner.
bool isWhole(const Side& side) { return side.covered.size() == 1 && side.points.empty(); }

Facts factsOf(const Content& content) {
  const bool linkedInside = std::any_of(content.interior.begin(), content.interior.end(), [](const InteriorEdge& s) {
    return s.predecessor != InteriorEdge::kRim || s.successor != InteriorEdge::kRim;
  });
  unsigned facts = (content.interior.empty() ? 0u : kInside) | (linkedInside ? kLinkedInside : 0u);
  for (unsigned s = 0; s < kSides; ++s)
    facts |= (isWhole(content.sides[s]) ? 1u : 0u) << s | (content.sides[s].points.empty() ? 0u : kRimPoints);
  return static_cast<Facts>(facts);
}

/// The direction of each side. At a vertex on the side, the cell's interior directions follow it counter-clockwise.
constexpr std::array<Vector, 4> kSideDirections{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

template <class T>
std::size_t bytesOf(std::span<const T> list) {
  static_assert(sizeof(T) % sizeof(std::uint32_t) == 0 && alignof(T) <= alignof(std::uint32_t));
  return list.size_bytes();
}

/// Copies a list to a place in memory, and goes on to the next place.
template <class T>
void put(std::span<const T>& list, std::byte*& at) {
  T* const begin = static_cast<T*>(static_cast<void*>(at));
  std::uninitialized_copy(list.begin(), list.end(), begin);
  at += list.size_bytes();
  list = {begin, list.size()};
}

/// The content's lists, which are somewhere, become its own.
void keepLists(Content& content) {
  const auto forEachList = [&content](auto&& use) {
    for (Side& side : content.sides) use(side.covered), use(side.points);
    use(content.interior), use(content.spokes), use(content.contacts), use(content.polygons), use(content.preserved);
  };
  forEachList([&](const auto& list) { content.listBytes += bytesOf(list); });
  content.lists = std::make_unique_for_overwrite<std::byte[]>(content.listBytes);
  std::byte* at = content.lists.get();
  forEachList([&](auto& list) { put(list, at); });
}

}  // namespace

// --- The vertices, and the edges between them

void ContentBuilder::takeVertices(std::span<const PolygonView> polygons) {
  inOrder(polygons, order_);
  points_.resize(order_.size());
  sidesAt_.resize(order_.size());
  ranks_.resize(order_.size());
  std::size_t count = 0;
  for (std::size_t k = 0; k < order_.size(); ++k) {
    if (k == 0 || !isSamePoint(order_[k - 1], order_[k])) {
      points_[count] = pointOf(order_[k]);
      sidesAt_[count++] = sidesAt(pointOf(order_[k]));
    }
    ranks_[static_cast<std::size_t>(indexOf(order_[k]))] = static_cast<Rank>(count - 1);
  }
  points_.resize(count);
}

/// The polygons' edges between one vertex and the next, by start, then end.
void ContentBuilder::takeEdges(std::span<const PolygonView> polygons) {
  edges_.clear();
  if (polygons.size() == 1) {  // one edge starts in each vertex, and no vertex lies on an edge
    const std::size_t count = points_.size();
    edges_.resize(count);
    edgesAt_.resize(count + 1);
    for (std::size_t i = 0; i < count; ++i) {
      edges_[ranks_[i]] = {ranks_[i], ranks_[i + 1 == count ? 0 : i + 1], 0};
      edgesAt_[i + 1] = static_cast<std::uint32_t>(i + 1);
    }
    return;
  }
  cutEdges(polygons);
  sortByEnd(edges_, &HalfEdge::to, edgesAt_);
  sortByEnd(edges_, &HalfEdge::at, edgesAt_);
}

/// Every polygon edge, cut at every vertex on it.
void ContentBuilder::cutEdges(std::span<const PolygonView> polygons) {
  const Rank* ranks = ranks_.data();
  for (std::size_t slot = 0; slot < polygons.size(); ++slot) {
    const std::size_t count = polygons[slot].size();
    for (std::size_t i = 0; i < count; ++i) {
      Rank from = ranks[i];
      const Rank to = ranks[i + 1 == count ? 0 : i + 1], step = from < to ? 1 : ~Rank{0};
      const LocalPoint a = points_[from], b = points_[to];
      for (Rank r = from + step; r != to; r += step) {  // what lies on an edge comes between its ends in order
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

/// Sorts half-edges by one of their ends, equal ones as they are.
/// (Distribution counting: Knuth, TAOCP 3, 5.2, Algorithm D.)
void ContentBuilder::sortByEnd(std::vector<HalfEdge>& edges, Rank HalfEdge::*end, Begins& begins) {
  begins.assign(points_.size() + 2, 0);
  for (const HalfEdge& e : edges) ++begins[e.*end + std::size_t{2}];
  for (std::size_t v = 2; v < begins.size(); ++v) begins[v] += begins[v - 1];
  sorted_.resize(edges.size());
  for (const HalfEdge& e : edges) sorted_[begins[e.*end + std::size_t{1}]++] = e;
  edges.swap(sorted_);
}

/// By law 1, the edges inside the cell. Both ends of each of them become ends_, by vertex.
void ContentBuilder::placeInside(std::span<const std::pair<Slot, Slot>> preserved) {
  ends_.clear();
  keys_.clear();
  interior_.clear();
  for (const HalfEdge& edge : edges_) {
    if ((sidesAt_[edge.at] & sidesAt_[edge.to]) != 0) continue;  // it lies along a side
    const auto slot = static_cast<Slot>(edge.what);
    std::size_t reversed = edgesAt_[edge.to];
    const std::size_t last = edgesAt_[edge.to + std::size_t{1}];
    while (reversed < last && edges_[reversed].to != edge.at) ++reversed;
    if (reversed < last) {
      const std::pair<Slot, Slot> contact = std::minmax(slot, static_cast<Slot>(edges_[reversed].what));
      if (slot == contact.first) keys_.push_back(std::uint64_t{contact.first} << 16 | contact.second);
      if (!std::binary_search(preserved.begin(), preserved.end(), contact)) continue;
    }
    const auto segment = static_cast<std::uint32_t>(interior_.size());
    ends_.push_back({edge.at, edge.to, segment << 1 | 1});
    ends_.push_back({edge.to, edge.at, segment << 1});
    interior_.push_back(
        {PackedEnds::of(points_[edge.at], points_[edge.to]), InteriorEdge::kRim, InteriorEdge::kRim, slot});
  }
  sortByEnd(ends_, &HalfEdge::at, endsAt_);
  contacts_.clear();
  detail::sort(keys_);
  for (std::size_t k = 0; k < keys_.size(); ++k)
    if (k == 0 || keys_[k - 1] != keys_[k])
      contacts_.emplace_back(static_cast<Slot>(keys_[k] >> 16), static_cast<Slot>(keys_[k]));
}

// --- The fans

/// The interior half-edges at a vertex.
std::span<ContentBuilder::HalfEdge> ContentBuilder::endsAt(Rank vertex) {
  return std::span(ends_).subspan(endsAt_[vertex], endsAt_[vertex + std::size_t{1}] - endsAt_[vertex]);
}

/// The same, counter-clockwise from the direction `from`. Valid until the next call.
std::span<const Spoke> ContentBuilder::fanAt(Rank vertex, Vector from) {
  const std::span<HalfEdge> ends = endsAt(vertex);
  const auto direction = [&](const HalfEdge& e) { return points_[e.to] - points_[e.at]; };
  // The plane is turned so that `from` is the x axis.
  const auto turned = [&](Vector d) { return Vector{dot(from, d), cross(from, d)}; };
  if (ends.size() > 1)
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

/// Law 2 at the vertices inside the cell. Usually one edge arrives, and one leaves.
void ContentBuilder::linkInside() {
  const auto setPredecessor = [&](std::uint32_t s, std::uint32_t other) { interior_[s].predecessor = other; };
  const auto setSuccessor = [&](std::uint32_t s, std::uint32_t other) { interior_[s].successor = other; };
  for (Rank v = 0; v < points_.size(); ++v) {
    if (sidesAt_[v] != 0) continue;
    const std::span<const HalfEdge> ends = endsAt(v);
    if (ends.size() == 2 && ends[0].to != ends[1].to) {
      const bool leaves = (ends[0].what & 1) != 0;
      const std::uint32_t in = ends[leaves ? 1 : 0].what >> 1, out = ends[leaves ? 0 : 1].what >> 1;
      setPredecessor(out, in);
      setSuccessor(in, out);
      continue;
    }
    radialMatch(fanAt(v, {1, 0}), InteriorEdge::kNone, setPredecessor, setSuccessor);
  }
}

/// Law 2 between the cell's own half-edges at a corner. Where nothing is preserved, incoming and outgoing ones take
/// turns, and the wedge from an incoming one to the next is free. Where something is, Linking matches whole fans.
void ContentBuilder::linkAtCorner(Content& content, unsigned corner, std::span<const Spoke> fan) {
  for (std::size_t k = 1; k < fan.size(); ++k) {
    const Spoke &before = fan[k - 1], &after = fan[k];
    if (before.outgoing || !after.outgoing) continue;
    interior_[before.segment].successor = after.segment;
    interior_[after.segment].predecessor = before.segment;
  }
  const auto place = [&](const Spoke& spoke) {
    return static_cast<std::uint16_t>((spoke.segment < CornerEnds::kMaxPlace ? spoke.segment + 1 : 0) << 4 * corner);
  };
  if (fan.front().outgoing) content.cornerEnds.first |= place(fan.front());
  if (!fan.back().outgoing) content.cornerEnds.last |= place(fan.back());
}

/// Of a vertex on the rim.
SpokeRange ContentBuilder::storeFan(Content& content, std::span<const Spoke> fan) {
  SpokeRange range{static_cast<std::uint32_t>(fan.size()), static_cast<std::uint32_t>(spokes_.size()), {}};
  content.widestFan = std::max(content.widestFan, range.count);
  if (!fan.empty()) {
    range.first = fan.front();
    spokes_.insert(spokes_.end(), fan.begin() + 1, fan.end());
  }
  return range;
}

/// The profiles of the sides, and the fans at the vertices on them. The vertices of a side, and so the intervals
/// between them, are in increasing order already.
void ContentBuilder::takeSides(Content& content, bool linksCorners) {
  for (unsigned s = 0; s < kSides; ++s) {
    covered_[s].clear();
    rimPoints_[s].clear();
  }
  spokes_.clear();
  for (Rank v = 0; v < points_.size(); ++v) {
    const unsigned sides = sidesAt_[v];
    if (sides == 0) continue;
    for (std::size_t k = edgesAt_[v]; k < edgesAt_[v + std::size_t{1}]; ++k) {
      const HalfEdge& edge = edges_[k];
      if ((sides & sidesAt_[edge.to]) == 0) continue;
      const unsigned side = sideFrom(sides & sidesAt_[edge.to]);
      const std::int32_t start = along(side, points_[v]), end = along(side, points_[edge.to]);
      covered_[side].push_back({std::min(start, end), std::max(start, end), static_cast<Slot>(edge.what)});
    }
    const unsigned side = sideFrom(sides);
    const bool isCorner = (sides & (sides - 1)) != 0;
    if (!isCorner) {
      rimPoints_[side].push_back({along(side, points_[v]), storeFan(content, fanAt(v, kSideDirections[side]))});
    } else if (!endsAt(v).empty()) {
      const std::span<const Spoke> fan = fanAt(v, kSideDirections[side]);
      content.corners[side] = storeFan(content, fan);
      if (linksCorners) linkAtCorner(content, side, fan);
    }
  }
}

Content ContentBuilder::build(std::span<const PolygonId> polygons, std::span<const PolygonView> views,
                              std::span<const std::pair<Slot, Slot>> preserved) {
  takeVertices(views);
  takeEdges(views);
  placeInside(preserved);
  linkInside();
  Content content;
  takeSides(content, preserved.empty());
  for (unsigned s = 0; s < kSides; ++s) content.sides[s] = {covered_[s], rimPoints_[s]};
  content.interior = interior_;
  content.spokes = spokes_;
  content.contacts = contacts_;
  content.polygons = polygons;
  content.preserved = preserved;
  content.facts = factsOf(content);
  keepLists(content);
  return content;
}

}  // namespace lgs::detail
