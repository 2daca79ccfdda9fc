// Bodies of Box2D 3 that are remembered. In 2.4 there is more to it; here an id names no other body later.
#pragma once

#include <lgs/box2d/physics.h>

#include <cstddef>
#include <vector>

namespace lgs::detail {

/// Bodies that may be destroyed meanwhile.
class KnownBodies {
 public:
  explicit KnownBodies(b2WorldId /*physics*/) {}

  /// Those that are not gone.
  std::vector<b2BodyId> there() const {
    std::vector<b2BodyId> there = bodies_;
    std::erase_if(there, [](b2BodyId body) { return !b2Body_IsValid(body); });
    return there;
  }
  const std::vector<b2BodyId>& all() const { return bodies_; }  ///< some may be gone
  std::size_t ownCount() const { return 0; }                    ///< bodies that this made

  void add(b2BodyId body) { bodies_.push_back(body); }
  /// Forgets those that are gone, and of the others those that are not to be kept: isOut(body), each once.
  template <class IsOut>
  void eraseIf(const IsOut& isOut) {
    std::erase_if(bodies_, [&](b2BodyId body) { return !b2Body_IsValid(body) || isOut(body); });
  }

 private:
  std::vector<b2BodyId> bodies_;
};

}  // namespace lgs::detail
