#include "bench/published/tests/departures.h"

#include "bench/published/published_engine.h"
#include "bench/published/published_lattice.h"
#include "oracle/engine/play.h"
#include "oracle/engine/table_engine.h"
#include "oracle/reference/naive.h"
#include "oracle/reference/vector.h"
#include "oracle/trace/player.h"

#include <algorithm>
#include <cstdlib>
#include <set>

namespace lgs::bench {
namespace {

using oracle::operator-;
using oracle::Outline;
using oracle::OutlineSegment;
using oracle::Scene;
using oracle::ScenePolygon;

constexpr std::int64_t kCell = kUnitsPerCell;

struct Edge {
  Point start;
  Point end;
  friend auto operator<=>(const Edge&, const Edge&) = default;
};

std::vector<Edge> edgesOf(const Scene& scene) {
  std::vector<Edge> edges;
  for (const ScenePolygon& p : scene.polygons)
    for (std::size_t k = 0; k < p.vertices.size(); ++k)
      edges.push_back({toWorld(p.cell, p.vertices[k]), toWorld(p.cell, p.vertices[(k + 1) % p.vertices.size()])});
  return edges;
}

/// Whether p lies inside the edge a–b. An edge is at most a cell long, so the products of isOnSegment() can overflow
/// only where p is far away.
bool isInside(Point p, Point a, Point b) {
  const bool isNear = std::abs(p.x - a.x) <= kCell && std::abs(p.y - a.y) <= kCell;
  return isNear && p != a && p != b && oracle::isOnSegment(p, a, b);
}

bool isOnEdge(Point p, Edge e) { return p == e.start || p == e.end || isInside(p, e.start, e.end); }

bool isOnRim(Point a, Point b) { return (a.x == b.x && a.x % kCell == 0) || (a.y == b.y && a.y % kCell == 0); }

/// Whether an edge lies along a rim, on the same side of a cell as the rim edge a–b.
bool shareSide(Edge e, Point a, Point b) {
  const auto side = [&](Point p, Point q) {
    const bool vertical = p.x == q.x && p.x % kCell == 0;
    return vertical ? std::tuple(vertical, p.x, oracle::cellIndex(std::min(p.y, q.y)))
                    : std::tuple(vertical, p.y, oracle::cellIndex(std::min(p.x, q.x)));
  };
  return isOnRim(e.start, e.end) && side(e.start, e.end) == side(a, b);
}

template <class Predicate>
bool anyUncut(const PublishedRun& run, Predicate&& predicate) {
  const std::vector<Edge> edges = edgesOf(run.scene);
  return std::ranges::any_of(run.published, [&](const OutlineSegment& s) {
    return std::ranges::any_of(edges, [&](Edge e) { return isInside(e.start, s.start, s.end); }) && predicate(s, edges);
  });
}

bool uncutOnRim(const PublishedRun& run, bool single) {
  return anyUncut(run, [&](const OutlineSegment& s, const std::vector<Edge>& edges) {
    return isOnRim(s.start, s.end) &&
           (std::ranges::count_if(edges, [&](Edge e) { return shareSide(e, s.start, s.end); }) == 1) == single;
  });
}

std::multiset<Edge> endsOf(const Outline& outline) {
  std::multiset<Edge> ends;
  for (const OutlineSegment& s : outline) ends.insert({s.start, s.end});
  return ends;
}

bool hasReverse(const std::multiset<Edge>& ends, Edge e) { return ends.contains({e.end, e.start}); }

/// Whether one of the two outlines has an overlap on a rim, both ways, and the other has no piece of it. With `alone`,
/// only these two edges may lie on that side of the cell; without it there must be more. (No third edge can lie on the
/// overlap itself.)
bool overlapDiffers(const PublishedRun& run, bool alone) {
  const std::vector<Edge> edges = edgesOf(run.scene);
  const auto differs = [&](const Outline& with, const Outline& without) {
    const std::multiset<Edge> ends = endsOf(with);
    return std::ranges::any_of(ends, [&](const Edge& e) {
      return isOnRim(e.start, e.end) && hasReverse(ends, e) &&
             std::ranges::none_of(without, [&](auto& s) { return isOnEdge(s.start, e) && isOnEdge(s.end, e); }) &&
             (std::ranges::count_if(edges, [&](Edge o) { return shareSide(o, e.start, e.end); }) == 2) == alone;
    });
  };
  return differs(run.expected, run.published) || (!alone && differs(run.published, run.expected));
}

/// Whether two outlines have the same segments, but not the same ghosts.
bool ghostsDiffer(const Outline& one, const Outline& other) {
  if (one.size() != other.size()) return false;
  bool differ = false;
  for (std::size_t k = 0; k < one.size(); ++k) {
    const OutlineSegment &a = one[k], &b = other[k];
    if (a.start != b.start || a.end != b.end || a.block != b.block) return false;
    differ |= a != b;
  }
  return differ;
}

/// Whether the laws demand the same without the preserve relation.
bool preservesNothing(const PublishedRun& run) {
  return run.scene.preserve.empty() || oracle::naiveOutline({run.scene.polygons, {}}) == run.expected;
}

/// Whether a segment is shorter than the algorithm's ε of 10⁻³ cells.
bool isShort(const OutlineSegment& s) {
  constexpr std::int64_t kEpsilon = kCell / 1000 + 1;
  return std::abs(s.start.x - s.end.x) < kEpsilon && std::abs(s.start.y - s.end.y) < kEpsilon;
}

Block blockOf(const OutlineSegment& s) { return s.block; }

/// Whether a vertex of the polygon comes back as another lattice point after it was a float.
bool movesAsFloats(const ScenePolygon& polygon) {
  const std::vector<Vec2> floats = floatVertices(polygon);
  return !std::ranges::equal(floats, polygon.vertices,
                             [&](Vec2 f, LocalPoint v) { return toLattice(f) == toWorld(polygon.cell, v); });
}

}  // namespace

std::string_view nameOf(Departure departure) {
  constexpr std::array<std::string_view, kDepartures.size()> kNames{
      "uncut-single", "uncut-swept",   "uncut-in-cell", "kept-in-cell",  "preserved-pair", "preserved-side",
      "other-block",  "near-vertices", "small-angle",   "removed-other", "stale-ghosts",   "coarse-floats"};
  return kNames[static_cast<std::size_t>(departure)];
}

Outline publishedOutline(const oracle::Trace& trace) {
  const auto engine = oracle::TableEngine::make(publishedEngine());
  return oracle::play(trace, **engine).value();
}

tl::expected<PublishedRun, oracle::TraceError> runPublished(const oracle::Trace& trace) {
  oracle::Player player(trace.preserve);
  if (const auto played = play(trace, player); !played) return tl::unexpected(played.error());
  PublishedRun run;
  run.scene = player.scene();
  run.expected = naiveOutline(run.scene);
  run.published = publishedOutline(trace);
  oracle::Trace scene{trace.preserve, {}};
  for (const ScenePolygon& polygon : run.scene.polygons)
    scene.calls.push_back(oracle::Call::add(std::to_string(scene.calls.size()), polygon));
  run.afresh = publishedOutline(scene);
  return run;
}

bool shows(const PublishedRun& run, Departure departure) {
  const auto& published = run.published;
  const bool hasShort = std::ranges::any_of(run.expected, isShort);
  switch (departure) {
    case Departure::uncutSingle:
      return uncutOnRim(run, true);
    case Departure::uncutSwept:
      return uncutOnRim(run, false);
    case Departure::uncutInCell:
      return anyUncut(run, [](const OutlineSegment& s, const auto&) { return !isOnRim(s.start, s.end); });
    case Departure::keptInCell: {
      const auto ends = endsOf(published), right = endsOf(run.expected);
      return std::ranges::any_of(published, [&](const OutlineSegment& s) {
        const Edge e{s.start, s.end};
        return !isOnRim(s.start, s.end) && hasReverse(ends, e) && !right.contains(e);
      });
    }
    case Departure::preservedPair:
      return overlapDiffers(run, true);
    case Departure::preservedSide:
      return !run.scene.preserve.empty() && overlapDiffers(run, false);
    case Departure::otherBlock:
      return endsOf(published) == endsOf(run.expected) &&
             !std::ranges::equal(published, run.expected, {}, blockOf, blockOf);
    case Departure::nearVertices:
      return hasShort && ghostsDiffer(run.expected, published);
    case Departure::smallAngle:
      return !hasShort && ghostsDiffer(run.expected, published) && run.afresh == published && preservesNothing(run);
    case Departure::removedOther: {
      const std::vector<Edge> edges = edgesOf(run.scene);
      return std::ranges::any_of(published, [&](const OutlineSegment& s) {
        const auto has = [&](Edge e) {
          return isOnEdge(s.start, e) && isOnEdge(s.end, e) && oracle::dot(s.end - s.start, e.end - e.start) > 0;
        };
        return isShort(s) && std::ranges::none_of(edges, has);
      });
    }
    case Departure::staleGhosts:
      return !hasShort && ghostsDiffer(run.afresh, published);
    case Departure::coarseFloats:
      return published != run.expected && std::ranges::any_of(run.scene.polygons, movesAsFloats);
  }
  return false;
}

bool isWithinItsReach(const Scene& scene) {
  if (!scene.preserve.empty()) return false;
  const std::vector<Edge> edges = edgesOf(scene);
  for (const ScenePolygon& p : scene.polygons) {
    if (p.block != scene.polygons[0].block) return false;
    if (std::abs(p.cell.i) >= 127 || std::abs(p.cell.j) >= 127) return false;
    for (const LocalPoint v : p.vertices)
      if (v.x % (kCell / 8) != 0 || v.y % (kCell / 8) != 0) return false;
  }
  for (const Edge& e : edges) {
    const bool rim = isOnRim(e.start, e.end);
    for (const Edge& other : edges) {
      if (!rim && other.start == e.end && other.end == e.start) return false;
      if (!isInside(other.start, e.start, e.end)) continue;
      const auto endsThere = [&](Edge o) {
        return (o.start == other.start || o.end == other.start) && shareSide(o, e.start, e.end);
      };
      if (!rim || std::ranges::none_of(edges, endsThere)) return false;
    }
  }
  return true;
}

}  // namespace lgs::bench
