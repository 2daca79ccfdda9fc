// Bodies of Box2D 2.4 that are remembered, distinguished from later ones that have their address.
#pragma once

#include <box2d/box2d.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace lgs::detail {

/// Box2D gives the address of a body that is destroyed to the next one, and puts each new body in front of its list. So
/// a body without shapes that was made after these have been added has them all behind it, and later ones before it. It
/// is there as long as some are known.
class KnownBodies {
 public:
  /// The physics world must outlive it.
  explicit KnownBodies(b2World& physics) : physics_(&physics) {}
  ~KnownBodies() { drop(); }
  KnownBodies(const KnownBodies&) = delete;
  KnownBodies& operator=(const KnownBodies&) = delete;

  const std::vector<b2Body*>& all() const { return bodies_; }  ///< some may be gone
  /// Those that are not gone.
  std::vector<b2Body*> there() const {
    std::vector<const b2Body*> behind;
    for (const b2Body* body = mark_; body != nullptr; body = body->GetNext()) behind.push_back(body);
    std::ranges::sort(behind);
    std::vector<b2Body*> there = bodies_;
    std::erase_if(there, [&](const b2Body* body) { return !std::ranges::binary_search(behind, body); });
    return there;
  }
  std::size_t ownCount() const { return mark_ == nullptr ? 0U : 1U; }  ///< bodies that this made

  /// Not in a step.
  void add(b2Body* body) {
    bodies_.push_back(body);
    drop();
    const b2BodyDef definition;
    mark_ = physics_->CreateBody(&definition);
  }
  /// Forgets those that are gone, and of the others those that are not to be kept: isOut(body), each once.
  template <class IsOut>
  void eraseIf(const IsOut& isOut) {
    if (bodies_.empty()) return;
    bodies_ = there();
    std::erase_if(bodies_, isOut);
    if (bodies_.empty()) drop();
  }

 private:
  void drop() {
    if (mark_ != nullptr) physics_->DestroyBody(mark_);
    mark_ = nullptr;
  }

  b2World* physics_;
  std::vector<b2Body*> bodies_;
  b2Body* mark_ = nullptr;
};

}  // namespace lgs::detail
