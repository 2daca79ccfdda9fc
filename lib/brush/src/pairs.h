// Which of many edges can meet: those whose boxes do.
#pragma once

#include "geometry/ring.h"
#include "geometry/sort.h"
#include "scratch.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace lgs::brush {

/// Whether a test holds for any two edges whose boxes meet, the one of less index first. The test may end the search
/// so, and collect what it wants. `endsOf` gives the two ends of one. Cost: O(n log n), a look at each two whose boxes
/// meet by x, and the tests.
template <class Edges, class EndsOf, class Test>
bool anyPair(const Edges& edges, EndsOf&& endsOf, Test&& test) {
  struct Item {
    detail::Box<Point> box;
    std::size_t index;
  };
  List<Item> order;
  order.reserve(edges.size());
  for (std::size_t k = 0; k < edges.size(); ++k) order.push_back({detail::boundingBox(endsOf(edges[k])), k});
  detail::sort(order, [](const Item& a, const Item& b) { return a.box.min.x < b.box.min.x; });
  for (std::size_t k = 0; k < order.size(); ++k) {
    const auto [box, index] = order[k];
    for (std::size_t l = k + 1; l < order.size() && order[l].box.min.x <= box.max.x; ++l) {
      if (order[l].box.min.y > box.max.y || order[l].box.max.y < box.min.y) continue;
      if (test(edges[std::min(index, order[l].index)], edges[std::max(index, order[l].index)])) return true;
    }
  }
  return false;
}

}  // namespace lgs::brush
