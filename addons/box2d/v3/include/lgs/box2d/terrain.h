// The boundary of a lgs::World as terrain in a world of Box2D 3.1 or later. Each chunk of cells is a static body, and
// each segment is a chain segment with its ghost vertices. After a commit sync() changes exactly those shapes that the
// commit changed.
//
//   lgs::box2d::Terrain terrain(physics, world, {.cellSize = 0.5});
//   …
//   if (world.remove(handle)) terrain.commit(world);
//   …
//   const int count = b2Body_GetContactData(body, contacts, capacity);  // after a step
//   for (int k = 0; k < count; ++k)
//     if (auto touch = terrain.hit(contacts[k])) world.clear(touch->hit.cell);
//   terrain.commit(world);
//
// From Box2D 3.2 on the chain segments are loose (b2CreateChainSegmentShape), and a ghost that changes is written in
// place. Before 3.2 each is an open chain of four points, which is made again when a ghost changes.
//
// Dynamic bodies that rest on changed ground wake up, and so do those within 20 cm of where new ground appears. Nothing
// else is touched.
//
// To be called from one thread at a time, and not during b2World_Step(), but for functions that are const, which Box2D's
// callbacks may call from several. Nothing fails, unless it is said.
#pragma once

#include <lgs/box2d/terrain_base.h>

#include <memory>
#include <optional>
#include <type_traits>

namespace lgs::box2d {

/// With which precision a file was compiled. It is a parameter of Terrain's constructor that is never given: where a
/// game and the terrain's library disagree about BOX2D_DOUBLE_PRECISION, they do not link.
enum class PositionsInFloat : bool {};
enum class PositionsInDouble : bool {};
using Precision = std::conditional_t<std::is_same_v<decltype(Position::x), float>, PositionsInFloat, PositionsInDouble>;

/// The ground of one world in one physics world. The comment at the top of this file has an example; TerrainBase has
/// most of what it can do.
class Terrain : public TerrainBase {
 public:
  /// Makes the terrain of what the world held at its last commit. `world` must outlive it and stay where it is;
  /// resync() if it is assigned to. When the physics world is destroyed, nothing but the terrain's destructor may be
  /// called. Cost: O(segments).
  Terrain(b2WorldId physics, const World& world, TerrainOptions options = {}, Precision = {}) noexcept;

  using TerrainBase::fits;
  /// Whether the ground reaches into no shape of a body by more than Box2D's slop, as if it were at another place. No
  /// edit may be pending, as in beforeStep().
  bool fits(b2BodyId body, Position at, b2Rot rotation) noexcept;

  /// What recall() needs to bring the terrain back to now. For this terrain alone.
  class Memory;
  using MemoryPtr = std::shared_ptr<const Memory>;

  /// b2World_Restore() brings back the shapes of the terrain, but not what they stand for. So remember beside a
  /// snapshot of the physics and a mark of the world, all three between two steps and with nothing left to sync; and
  /// recall when both are back:
  ///
  ///   const lgs::Mark mark = world.mark();
  ///   const auto memory = terrain.remember();            // beside b2World_Snapshot()
  ///   …
  ///   b2World_Restore(physics, image, size);
  ///   world.rollBack(mark);
  ///   terrain.recall(memory);                            // and no sync
  ///
  /// From then on all goes on as it did, to the last bit. User data of the game's own bodies and shapes are not
  /// brought back: Box2D sets them to null. Cost: O(segments), 10 to 20 µs for a thousand.
  MemoryPtr remember() const noexcept;
  void recall(const MemoryPtr& memory) noexcept;  ///< see remember()

  using TerrainBase::hit;
  /// What a contact touches of the terrain; nothing if it is none of the terrain's, or has no points. If the edge
  /// stands for several segments, the hit is the one nearest to the centre of the points. Box2D gives out the data of
  /// contacts that touch, and of no others. But it looks ahead: what is less than four slops (2 cm) away touches for
  /// it, and a point's `separation` is greater than 0 then.
  std::optional<Touch> hit(const b2ContactData& contact) const noexcept;

  /// The same by the id of a contact, which Box2D's events have from 3.2 on; nothing if the contact is no more.
  template <class ContactId>
  requires requires(ContactId contact) { b2Contact_GetData(contact); }
  std::optional<Touch> hit(ContactId contact) const noexcept {
    return b2Contact_IsValid(contact) ? hit(b2Contact_GetData(contact)) : std::nullopt;
  }

  /// The shape that stands for a segment; null if the segment is left out, because it is too short, or is not alive.
  b2ShapeId shape(SegmentId segment) const noexcept { return shape(edges_.edgeOf(segment)); }
  /// The shape of a live edge; null for the null id and for one that never was.
  b2ShapeId shape(EdgeId edge) const noexcept { return shapes_[edge.value < shapes_.size() ? edge.value : 0].shape; }
};

}  // namespace lgs::box2d
