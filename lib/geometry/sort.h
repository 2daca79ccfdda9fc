// Sorting. Elements that compare equal come in any order: no result may depend on it.
#pragma once

#include <algorithm>
#include <functional>
#include <utility>

namespace lgs::detail {

/// Sorts a vector, an array or a span. In WebAssembly more than a third of the engine's code was libc++'s std::sort,
/// made anew for each type. Where LGS_SMALL_CODE is defined, insertion and a heap do it: a tenth of that code.
template <class Range, class Less = std::less<>>
void sort(Range&& range, Less less = {}) {
#ifdef LGS_SMALL_CODE
  const auto first = range.begin();
  const auto last = range.end();
  if (last - first > 24) {
    std::make_heap(first, last, less);
    std::sort_heap(first, last, less);
    return;
  }
  for (auto next = first; next != last; ++next) {
    auto value = std::move(*next);
    auto to = next;
    for (; to != first && less(value, to[-1]); --to) *to = std::move(to[-1]);
    *to = std::move(value);
  }
#else
  std::sort(range.begin(), range.end(), less);
#endif
}

}  // namespace lgs::detail
