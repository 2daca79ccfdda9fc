// Where bodies were free last. It knows no Box2D.
#pragma once

#include <lgs/lattice.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>

namespace lgs::box2d {

/// Where a body is: in lattice units, so that the origin of the physics world may move.
struct Footing {
  DoublePoint at;
  float cosine = 1;
  float sine = 0;
};

/// Whether a body is so far from there that it may have come through something thin. It is for a quick look.
inline bool isFar(const Footing& footing, DoublePoint at) {
  constexpr double kFar = kUnitsPerCell / 16.0;
  return std::abs(at.x - footing.at.x) > kFar || std::abs(at.y - footing.at.y) > kFar;
}

/// The last free place of each body, by a number of the body's.
class Footings {
 public:
  void set(std::uint64_t body, const Footing& footing) { known_[body] = footing; }
  std::optional<Footing> of(std::uint64_t body) const {
    const auto known = known_.find(body);
    return known == known_.end() ? std::nullopt : std::optional(known->second);
  }
  void forget(std::uint64_t body) { known_.erase(body); }
  /// Forgets bodies that are gone, if there are more than so many.
  template <class IsThere>
  void prune(std::size_t most, const IsThere& isThere) {
    if (known_.size() <= most) return;
    std::erase_if(known_, [&](const auto& entry) { return !isThere(entry.first); });
  }

 private:
  std::unordered_map<std::uint64_t, Footing> known_;
};

}  // namespace lgs::box2d
