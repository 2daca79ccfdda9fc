#include "convex.h"

#include "geometry/predicates.h"
#include "geometry/sort.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace lgs::pieces {
namespace {

/// Half-edges: number 3t + k leaves corner k of triangle t. They are linked to rings, one for each piece.
class Mesh {
 public:
  explicit Mesh(const Triangulation& triangulation)
      : points_(triangulation.points),
        triangles_(triangulation.triangles),
        next_(3 * triangles_.size()),
        previous_(next_.size()),
        twin_(next_.size(), kNone),
        parent_(triangles_.size()),
        corners_(triangles_.size(), 3) {
    for (Index h = 0; h < next_.size(); ++h) {
      next_[h] = h % 3 == 2 ? h - 2 : h + 1;
      previous_[next_[h]] = h;
    }
    std::iota(parent_.begin(), parent_.end(), Index{0});
    findTwins();
  }

  /// Removing a diagonal can only lower the number of corners of a piece where it leaves flat vertices. That can make
  /// room for another merge, so it goes on until nothing changes.
  void removeDiagonals(std::size_t maxVertices) {
    for (bool goesOn = true; goesOn;) {
      goesOn = false;
      for (Index h = 0; h < next_.size(); ++h)
        if (twin_[h] != kNone && h < twin_[h] && remove(h, maxVertices)) goesOn = true;
    }
  }

  ConvexParts parts() {
    std::vector<Index> roots;
    ConvexParts out;
    for (Index h = 0; h < next_.size(); h += 3)
      if (pieceOf(h) == h / 3) roots.push_back(h / 3);
    std::vector<Index> start(triangles_.size(), kNone);  // a half-edge that is still there, by root
    for (Index h = 0; h < next_.size(); ++h)
      if (!isRemoved(h)) start[pieceOf(h)] = h;
    std::vector<std::pair<ConvexParts::Part, Index>> found;
    for (const Index root : roots) found.push_back({{triangles_[root].label, corners(start[root])}, root});
    detail::sort(found, [](const auto& a, const auto& b) {
      return std::tie(a.first.label, a.first.vertices) < std::tie(b.first.label, b.first.vertices);
    });
    std::vector<Index> number(triangles_.size(), kNone);
    for (auto& [part, root] : found) {
      number[root] = static_cast<Index>(out.parts.size());
      out.parts.push_back(std::move(part));
    }
    for (Index h = 0; h < next_.size(); ++h)
      if (twin_[h] != kNone && !isRemoved(h))
        out.contacts.push_back({number[pieceOf(h)], number[pieceOf(twin_[h])], start_(h), start_(twin_[h])});
    detail::sort(out.contacts, [](const Contact& a, const Contact& b) {
      return std::tie(a.piece, a.from) < std::tie(b.piece, b.from);
    });
    return out;
  }

 private:
  Index origin(Index h) const { return triangles_[h / 3].corners[h % 3]; }
  LocalPoint start_(Index h) const { return points_[origin(h)]; }
  bool isRemoved(Index h) const { return next_[h] == kNone; }

  Index pieceOf(Index h) {
    Index k = h / 3;
    while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
    return k;
  }

  /// Edges with one label on both sides are diagonals; all others are edges of polygons or of the cell.
  void findTwins() {
    struct Keyed {
      Index low, high, half;
    };
    std::vector<Keyed> all;
    for (Index h = 0; h < next_.size(); ++h) {
      const auto [low, high] = std::minmax({origin(h), origin(next_[h])});
      all.push_back({low, high, h});
    }
    detail::sort(all, [](const Keyed& a, const Keyed& b) {
      return std::tie(a.low, a.high, a.half) < std::tie(b.low, b.high, b.half);
    });
    for (std::size_t k = 1; k < all.size(); ++k) {
      const Keyed &a = all[k - 1], &b = all[k];
      if (a.low != b.low || a.high != b.high || triangles_[a.half / 3].label != triangles_[b.half / 3].label) continue;
      twin_[a.half] = b.half;
      twin_[b.half] = a.half;
    }
  }

  /// Removes a diagonal if the piece that it leaves is convex and small enough.
  bool remove(Index h, std::size_t maxVertices) {
    if (isRemoved(h)) return false;
    const Index t = twin_[h];
    const int atStart = turn(previous_[h], next_[t]), atEnd = turn(previous_[t], next_[h]);
    if (atStart < 0 || atEnd < 0) return false;
    const Index a = pieceOf(h), b = pieceOf(t);
    // Both ends were corners of both: else the angles there would add up to more than a straight one.
    const std::size_t left = corners_[a] + corners_[b] - 4 + (atStart > 0 ? 1 : 0) + (atEnd > 0 ? 1 : 0);
    if (left > maxVertices) return false;
    link(previous_[h], next_[t]);
    link(previous_[t], next_[h]);
    next_[h] = next_[t] = kNone;
    parent_[b] = a;
    corners_[a] = left;
    return true;
  }

  void link(Index h, Index following) {
    next_[h] = following;
    previous_[following] = h;
  }

  /// How the way turns from a half-edge to one that leaves its end.
  int turn(Index h, Index following) const {
    return detail::orientation(start_(h), start_(following), start_(next_[following]));
  }

  Ring corners(Index start) const {
    Ring ring;
    Index h = start;
    do {
      if (turn(previous_[h], h) > 0) ring.push_back(start_(h));
      h = next_[h];
    } while (h != start);
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
    return ring;
  }

  const std::vector<LocalPoint>& points_;
  const std::vector<Triangle>& triangles_;
  std::vector<Index> next_;  ///< kNone once it is removed
  std::vector<Index> previous_;
  std::vector<Index> twin_;           ///< kNone if it is no diagonal
  std::vector<Index> parent_;         ///< of triangles: a forest, each tree a piece
  std::vector<std::size_t> corners_;  ///< of the piece whose root a triangle is
};

}  // namespace

ConvexParts convexParts(const Triangulation& triangulation, std::size_t maxVertices) {
  Mesh mesh(triangulation);
  mesh.removeDiagonals(maxVertices);
  return mesh.parts();
}

}  // namespace lgs::pieces
