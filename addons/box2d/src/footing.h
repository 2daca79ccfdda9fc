// Where bodies were free last. It knows no Box2D.
#pragma once

#include <lgs/lattice.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace lgs::box2d {

/// Where a body is: in lattice units, so that the origin of the physics world may move.
struct Footing {
  DoublePoint at;
  float cosine = 1;
  float sine = 0;
  friend bool operator==(const Footing& a, const Footing& b) {
    return a.at.x == b.at.x && a.at.y == b.at.y && a.cosine == b.cosine && a.sine == b.sine;
  }
};

inline double distance(DoublePoint a, DoublePoint b) { return std::hypot(a.x - b.x, a.y - b.y); }

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
  std::size_t size() const { return known_.size(); }
  /// The numbers of all bodies that are there. Forgets those that are gone.
  template <class IsThere>
  std::vector<std::uint64_t> allOf(const IsThere& isThere) {
    std::erase_if(known_, [&](const auto& entry) { return !isThere(entry.first); });
    std::vector<std::uint64_t> bodies;
    for (const auto& entry : known_) bodies.push_back(entry.first);
    return bodies;
  }

 private:
  std::unordered_map<std::uint64_t, Footing> known_;
};

}  // namespace lgs::box2d
