// Regions by other rules than even-odd, as regions by that rule: exactly, or not at all.
#pragma once

#include <lgs/lattice.h>
#include <functional>
#include <optional>
#include <vector>

namespace lgs::oracle {

using Rings = std::vector<std::vector<Point>>;

/// Rings, and where they are solid, by how often all of them together run around a place.
struct RuledRings {
  Rings rings;
  std::function<bool(int winding)> isInside;
};

/// The union of some regions as a union of as few even-odd ones: of all rings at once, of each region's, or of each ring
/// by itself. Nothing if none of these is the same region.
std::optional<std::vector<Rings>> asEvenOdd(const std::vector<RuledRings>& regions);

}  // namespace lgs::oracle
