// Which of many things can meet: by their extent along the x axis.
#pragma once

#include "geometry/sort.h"
#include "scratch.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace lgs::brush {

struct Extent {
  std::int64_t min, max;
};

/// Whether a test holds for any two items whose extents meet, the one of less index first. The test may end the search
/// so, and collect what it wants. Cost: O(n log n) and a call for each such pair.
template <class Items, class ExtentOf, class Test>
bool anyPair(const Items& items, ExtentOf&& extentOf, Test&& test) {
  struct Item {
    Extent extent;
    std::size_t index;
  };
  List<Item> order;
  order.reserve(items.size());
  for (std::size_t k = 0; k < items.size(); ++k) order.push_back({extentOf(items[k]), k});
  detail::sort(order, [](const Item& a, const Item& b) { return a.extent.min < b.extent.min; });
  for (std::size_t k = 0; k < order.size(); ++k)
    for (std::size_t l = k + 1; l < order.size() && order[l].extent.min <= order[k].extent.max; ++l)
      if (test(items[std::min(order[k].index, order[l].index)], items[std::max(order[k].index, order[l].index)]))
        return true;
  return false;
}

}  // namespace lgs::brush
