// Whether a ring is simple, by the sweep of Shamos and Hoey ("Geometric intersection problems", FOCS 1976, section 3).
//
// A line sweeps over the ring from left to right, and the edges that it cuts are kept in their order from below. Points
// are taken by x, then y: that is a line which leans a little, so no edge lies along it and upright edges are nothing
// special. A new edge is put strictly between two others. Whenever two edges become neighbours it is made sure that
// they keep their order, without touching, until one of them ends. So no two edges ever touch, except in a vertex.
#pragma once

#include "ring.h"

namespace lgs::detail {

/// An edge, from its lesser end to its greater one.
template <LatticePoint P>
struct Rising {
  P low, high;
};

/// Whether an edge that is below another one now stays so, until one of them ends. They may end in the same vertex.
template <LatticePoint P>
constexpr bool staysBelow(const Rising<P>& e, const Rising<P>& f) {
  if (e.high == f.high) return true;
  return e.high < f.high ? orientation(f.low, f.high, e.high) < 0 : orientation(e.low, e.high, f.high) > 0;
}

/// Whether a ring has three vertices or more and no edge meets another, except neighbours in their vertex. Cost:
/// O(n log n) comparisons. (Edges are moved in an array where a tree would have links: that is O(n·k) bytes for k edges
/// above each other, but quicker than a tree for all rings that a map or a game has.)
template <class Ring>
bool isSimple(const Ring& ring) {
  using P = PointOf<Ring>;
  struct Corner {
    P at, before, after;
  };
  const std::size_t n = ring.size();
  if (n < 3) return false;
  std::vector<Corner> corners;
  corners.reserve(n);
  for (std::size_t i = 0; i < n; ++i) corners.push_back({ring[i], ring[i == 0 ? n - 1 : i - 1], nextVertex(ring, i)});
  detail::sort(corners, [](const Corner& a, const Corner& b) { return a.at < b.at; });

  std::vector<Rising<P>> edges(n);  // those that the line cuts, and free places
  Rising<P>*const bottom = edges.data(), *top = bottom;
  for (std::size_t k = 0; k < n; ++k) {
    const auto [v, u, w] = corners[k];
    if (k > 0 && corners[k - 1].at == v) return false;
    Rising<P>* const here =
        std::lower_bound(bottom, top, v, [](const auto& e, P p) { return orientation(e.low, e.high, p) > 0; });
    Rising<P>* last = here;
    while (last != top && last->high == v) ++last;
    if (last != top && orientation(last->low, last->high, v) == 0) return false;

    // The edges from here to last end in this vertex. Those that begin in it take their places.
    Rising<P> begun[2];
    std::ptrdiff_t count = 0;
    for (const P to : {u, w})
      if (v < to) begun[count++] = {v, to};
    if (count == 2) {
      const int turn = orientation(v, begun[0].high, begun[1].high);
      if (turn == 0) return false;
      if (turn < 0) std::swap(begun[0], begun[1]);
    }
    Rising<P>* const above = here + count;
    if (above > last) {
      std::move_backward(last, top, top + (above - last));
    } else {
      std::move(last, top, above);
    }
    top += above - last;
    std::copy(begun, begun + count, here);
    if (here != bottom && here != top && !staysBelow(here[-1], *here)) return false;
    if (count > 0 && above != top && !staysBelow(above[-1], *above)) return false;
  }
  return true;
}

}  // namespace lgs::detail
