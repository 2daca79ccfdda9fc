// Whether a ring is simple, by the sweep of Shamos and Hoey ("Geometric intersection problems", FOCS 1976, section 3).
//
// A line sweeps over the ring from left to right, and the edges that it cuts are kept in their order from below. Points
// are taken by x, then y: that is a line which leans a little, so no edge lies along it and upright edges are nothing
// special. A new edge is put strictly between two others. Whenever two edges become neighbours it is made sure that
// they keep their order, without touching, until one of them ends. So no two edges ever touch, except in a vertex.
#pragma once

#include "ring.h"
#include "sort.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

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

/// Whether no edge of a ring meets another, except neighbours in their vertex. The vertices are distinct; `order` is
/// their indices, sorted by place. Cost: O(n log n) comparisons. (Edges are moved in an array where a tree would have
/// links. That is O(n·k) bytes for k edges above each other, and quicker than a tree for a ring of thousands.)
template <class Ring>
bool isSimple(const Ring& ring, std::span<const std::uint64_t> order) {
  using P = PointOf<Ring>;
  std::vector<Rising<P>> edges(ring.size());  // those that the line cuts, and free places
  Rising<P>*const bottom = edges.data(), *top = bottom;
  for (const std::uint64_t index : order) {
    const auto i = static_cast<std::size_t>(index);
    const P u = ring[(i == 0 ? ring.size() : i) - 1], v = ring[i], w = nextVertex(ring, i);
    Rising<P>* const here =
        std::lower_bound(bottom, top, v, [](const auto& e, P p) { return orientation(e.low, e.high, p) > 0; });
    Rising<P>* last = here;
    while (last != top && last->high == v) ++last;
    if (last != top && orientation(last->low, last->high, v) == 0) return false;

    // The edges from here to last end in this vertex. Those that begin in it take their places. (If they lie on each
    // other, that is seen where the shorter one ends.)
    Rising<P> begun[2];
    std::ptrdiff_t count = 0;
    for (const P to : {u, w})
      if (v < to) begun[count++] = {v, to};
    if (count == 2 && orientation(v, begun[0].high, begun[1].high) < 0) std::swap(begun[0], begun[1]);
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

/// The same for any ring. It has three vertices or more, and they are distinct, if it is simple.
template <class Ring>
bool isSimple(const Ring& ring) {
  std::vector<std::uint64_t> order(ring.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto at = [&](std::uint64_t i) { return ring[static_cast<std::size_t>(i)]; };
  detail::sort(order, [&](auto i, auto j) { return at(i) < at(j); });
  const auto isSame = [&](auto i, auto j) { return at(i) == at(j); };
  return order.size() >= 3 && std::adjacent_find(order.begin(), order.end(), isSame) == order.end() &&
         isSimple(ring, order);
}

}  // namespace lgs::detail
