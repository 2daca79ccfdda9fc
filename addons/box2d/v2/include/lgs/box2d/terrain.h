// The boundary of a lgs::World as terrain in a Box2D 2.4 world. Each chunk of cells is a static body, and each segment
// is a one-sided edge shape with its ghost vertices. After a commit sync() changes exactly those fixtures that the
// commit changed.
//
//   lgs::box2d::Terrain terrain(physics, world, {.cellSize = 0.5F});
//   …
//   if (world.remove(handle)) terrain.commit(world);
//   …
//   void BeginContact(b2Contact* contact) override {  // of a listener
//     if (auto touch = terrain.hit(*contact)) touched.push_back(touch->hit.cell);
//   }
//   …
//   terrain.beforeStep();
//   physics.Step(1.0F / 60, 8, 3);  // a listener only notes what to dig: nothing may change during the step
//   terrain.afterStep();
//   for (lgs::Cell cell : std::exchange(touched, {})) world.clear(cell);
//   terrain.commit(world);
//
// Dynamic bodies that rest on changed ground wake up, and so do those within 20 cm of where new ground appears. Nothing
// else is touched.
//
// To be called from one thread at a time, and not during b2World::Step(), but for functions that are const. Nothing
// fails, unless it is said.
#pragma once

#include <lgs/box2d/terrain_base.h>

namespace lgs::box2d {

/// The ground of one world in one physics world. The comment at the top of this file has an example; TerrainBase has
/// most of what it can do.
class Terrain : public TerrainBase {
 public:
  /// Makes the terrain of what the world held at its last commit. Both worlds must outlive it and stay where they are;
  /// resync() if `world` is assigned to. Cost: O(segments).
  Terrain(b2World& physics, const World& world, TerrainOptions options = {}) noexcept;

  using TerrainBase::fits;
  /// Whether the ground reaches into no fixture of a body by more than Box2D's slop, as if it were at another place. No
  /// edit may be pending, as in beforeStep().
  bool fits(const b2Body& body, const b2Transform& at) noexcept;

  using TerrainBase::hit;
  /// What a contact touches of the terrain; nothing if neither fixture is the terrain's, or if the contact does not
  /// touch: Box2D has contacts also of fixtures that are only near. If the edge stands for several segments, the hit is
  /// the one nearest to the centre of the contact's points; without points, as with a sensor, to the centre of the
  /// other fixture. Can be called in a b2ContactListener: in BeginContact, PreSolve and PostSolve every contact
  /// touches. In EndContact use hit(fixture), because a contact that ends does not touch any more.
  std::optional<Touch> hit(b2Contact& contact) const noexcept;

  /// The fixture that stands for a segment; null if the segment is left out, because it is too short, or is not alive.
  b2Fixture* fixture(SegmentId segment) const noexcept { return fixture(edges_.edgeOf(segment)); }
  /// The fixture of a live edge; null for the null id and for one that never was. Its userData.pointer is the EdgeId.
  b2Fixture* fixture(EdgeId edge) const noexcept { return shapes_[edge.value < shapes_.size() ? edge.value : 0]; }
};

}  // namespace lgs::box2d
