#include "triangulation.h"

#include "geometry/predicates.h"
#include "geometry/sort.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <utility>

namespace lgs::pieces {
namespace {

/// Goes through the points from left to right, and from below on a vertical line. The edges that the sweep line meets
/// divide the cell into areas. What of an area is behind the line is triangulated as far as its points allow: its right
/// rim, the *chain*, bulges to the right. A point joins all that it sees of the chains beside it.
class Sweep {
 public:
  explicit Sweep(std::span<const Ring> polygons) {
    constexpr std::int32_t U = kUnitsPerCell;
    const Ring cell{{0, 0}, {U, 0}, {U, U}, {0, U}};
    out_.points = cell;
    for (const Ring& polygon : polygons) out_.points.insert(out_.points.end(), polygon.begin(), polygon.end());
    detail::sort(out_.points);
    out_.points.erase(std::unique(out_.points.begin(), out_.points.end()), out_.points.end());
    firstAt_.assign(out_.points.size(), kNone);
    addEdges(cell, kFree);
    for (Label k = 0; k < polygons.size(); ++k) addEdges(polygons[k], k);
  }

  Triangulation run() {
    for (Index v = 0; v < out_.points.size(); ++v) step(v);
    assert(active_.empty());
    return std::move(out_);
  }

 private:
  /// From a point to a later one.
  struct Edge {
    Index to = 0;
    Label above = kFree;  ///< what is above it
    Index next = kNone;   ///< another edge that starts in the same point
  };
  /// An edge that the sweep line meets, and the area above it.
  struct Active {
    Index from = 0;
    Index to = 0;
    Label above = kFree;
    std::vector<Index> chain;  ///< upwards: from the start of this edge to that of the next one
  };

  const LocalPoint& at(Index v) const { return out_.points[v]; }
  int orientation(Index a, Index b, Index c) const { return detail::orientation(at(a), at(b), at(c)); }

  Index indexOf(LocalPoint p) const {
    return static_cast<Index>(std::lower_bound(out_.points.begin(), out_.points.end(), p) - out_.points.begin());
  }

  void addEdges(const Ring& ring, Label inside) {
    Index a = indexOf(ring.back());
    for (const LocalPoint p : ring) {
      const Index b = indexOf(p);
      addEdge(std::min(a, b), std::max(a, b), a < b ? inside : kFree);
      a = b;
    }
  }

  void addEdge(Index from, Index to, Label above) {
    edges_.push_back({to, above, firstAt_[from]});
    firstAt_[from] = static_cast<Index>(edges_.size() - 1);
  }

  void emit(Index a, Index b, Index c, Label label) {
    assert(orientation(a, b, c) > 0);
    out_.triangles.push_back({{a, b, c}, label});
  }

  /// Joins a point to what it sees of a chain below it, from the upper end on. What it hides is no longer on the rim.
  void joinBelow(Index v, std::vector<Index>& chain, Label label) {
    for (std::size_t n = chain.size(); n > 1 && orientation(chain[n - 2], v, chain[n - 1]) > 0; --n) {
      emit(chain[n - 2], v, chain[n - 1], label);
      chain.pop_back();
    }
  }

  /// The same for a chain above it, from the lower end on.
  void joinAbove(Index v, std::vector<Index>& chain, Label label) {
    std::size_t k = 0;
    for (; k + 1 < chain.size() && orientation(chain[k], v, chain[k + 1]) > 0; ++k)
      emit(chain[k], v, chain[k + 1], label);
    chain.erase(chain.begin(), chain.begin() + static_cast<std::ptrdiff_t>(k));
  }

  /// The edges from a point on, from below. Of those that run along each other the shortest is taken; the others start
  /// anew where it ends. So edges are cut where they overlap, and step() cuts them where a point lies on them.
  std::vector<Active> edgesFrom(Index v, std::size_t first, std::size_t last) {
    std::vector<Active> edges;
    for (std::size_t k = first; k < last; ++k)
      if (active_[k].to != v) edges.push_back({v, active_[k].to, active_[k].above, {}});
    for (Index k = firstAt_[v]; k != kNone; k = edges_[k].next) edges.push_back({v, edges_[k].to, edges_[k].above, {}});
    detail::sort(edges, [&](const Active& a, const Active& b) {
      const int turn = orientation(v, a.to, b.to);
      return turn != 0 ? turn > 0 : a.to < b.to;
    });
    std::size_t kept = 0;
    for (std::size_t k = 1; k < edges.size(); ++k) {
      if (orientation(v, edges[kept].to, edges[k].to) != 0) {
        edges[++kept] = std::move(edges[k]);
        continue;
      }
      if (edges[k].above != kFree) edges[kept].above = edges[k].above;
      if (edges[k].to != edges[kept].to) addEdge(edges[kept].to, edges[k].to, edges[k].above);
    }
    edges.resize(edges.empty() ? 0 : kept + 1);
    return edges;
  }

  void step(Index v) {
    // The edges that end in the point or run through it.
    const auto isBelow = [&](const Active& e) { return orientation(e.from, e.to, v) > 0; };
    const auto isOn = [&](const Active& e) { return orientation(e.from, e.to, v) == 0; };
    const auto begin = std::partition_point(active_.begin(), active_.end(), isBelow);
    const auto end = std::partition_point(begin, active_.end(), isOn);
    const auto first = static_cast<std::size_t>(begin - active_.begin());
    const auto last = static_cast<std::size_t>(end - active_.begin());
    std::vector<Active> edges = edgesFrom(v, first, last);

    // Areas between two edges that end here are done. There is none below the lowest edge and above the highest one.
    for (std::size_t k = first; k + 1 < last; ++k) joinAbove(v, active_[k].chain, active_[k].above);
    const bool isInside = first == last && first > 0;  // of an area
    std::vector<Index> below, above;
    if (isInside) {  // its latest point sees this one
      std::vector<Index>& chain = active_[first - 1].chain;
      const auto latest = std::max_element(chain.begin(), chain.end());
      above.assign(latest, chain.end());
      chain.erase(latest + 1, chain.end());
    } else if (last > first && last < active_.size()) {
      above = std::move(active_[last - 1].chain);
    }
    if (first > 0) {
      below = std::move(active_[first - 1].chain);
      joinBelow(v, below, active_[first - 1].above);
    }
    if (!above.empty()) joinAbove(v, above, active_[isInside ? first - 1 : last - 1].above);

    below.push_back(v);
    for (Active& edge : edges) edge.chain = {v};
    std::vector<Index>& top = edges.empty() ? below : edges.back().chain;
    top.insert(top.end(), above.begin(), above.end());
    if (first > 0) active_[first - 1].chain = std::move(below);
    replace(first, last, edges);
  }

  void replace(std::size_t first, std::size_t last, std::vector<Active>& edges) {
    const auto at = [&](std::size_t k) { return active_.begin() + static_cast<std::ptrdiff_t>(k); };
    const std::size_t both = std::min(last - first, edges.size());
    std::move(edges.begin(), edges.begin() + static_cast<std::ptrdiff_t>(both), at(first));
    active_.erase(at(first + both), at(last));
    active_.insert(at(first + both), std::make_move_iterator(edges.begin() + static_cast<std::ptrdiff_t>(both)),
                   std::make_move_iterator(edges.end()));
  }

  Triangulation out_;
  std::vector<Edge> edges_;
  std::vector<Index> firstAt_;  ///< by point: an edge that starts there
  std::vector<Active> active_;  ///< from below
};

}  // namespace

Triangulation triangulate(std::span<const Ring> polygons) { return Sweep(polygons).run(); }

}  // namespace lgs::pieces
