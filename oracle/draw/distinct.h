// Sorts a list and drops what is in it twice.
#pragma once

#include <algorithm>
#include <vector>

namespace lgs::oracle::drawing {

template <class T>
void makeDistinct(std::vector<T>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

}  // namespace lgs::oracle::drawing
