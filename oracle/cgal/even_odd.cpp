#include "oracle/cgal/even_odd.h"

#include "oracle/cgal/plane.h"

#include <algorithm>

namespace lgs::oracle {

std::optional<std::vector<Rings>> asEvenOdd(const std::vector<RuledRings>& regions) {
  std::vector<Rings> together(1), byRegion, byRing;
  std::vector<std::size_t> regionOf;  // of each ring
  plane::Curves curves;
  for (const RuledRings& region : regions) {
    byRegion.push_back(region.rings);
    for (const auto& ring : region.rings) {
      curves.addRing(regionOf.size(), ring);
      regionOf.push_back(byRegion.size() - 1);
      together[0].push_back(ring);
      byRing.push_back({ring});
    }
  }
  bool isTogether = true, isByRegion = true, isByRing = true;
  for (const std::vector<int>& windings : plane::facesOf(curves, regionOf.size()).windings) {
    std::vector<int> sums(regions.size(), 0);
    for (std::size_t k = 0; k < windings.size(); ++k) sums[regionOf[k]] += windings[k];
    const auto isOdd = [](int n) { return n % 2 != 0; };
    int all = 0;
    bool isSolid = false;
    for (std::size_t k = 0; k < sums.size(); ++k) {
      all += sums[k];
      isSolid = isSolid || regions[k].isInside(sums[k]);
    }
    isTogether = isTogether && isOdd(all) == isSolid;
    isByRegion = isByRegion && std::ranges::any_of(sums, isOdd) == isSolid;
    isByRing = isByRing && std::ranges::any_of(windings, isOdd) == isSolid;
  }
  if (isTogether) return together;
  if (isByRegion) return byRegion;
  return isByRing ? std::optional(byRing) : std::nullopt;
}

}  // namespace lgs::oracle
