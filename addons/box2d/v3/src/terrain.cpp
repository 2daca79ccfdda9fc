// What is done in Box2D 3 in its own way. The rest is the same for both generations (both/src/).
#include <lgs/box2d/terrain.h>
#include "calls.h"
#include "find_hit.h"
#include "footing.h"

#include <algorithm>
#include <utility>

namespace lgs::box2d {

namespace {

bool isThereStill(std::uint64_t body) { return b2Body_IsValid(b2LoadBodyId(body)); }

bool collect(b2ShapeId shape, void* shapes) {
  static_cast<std::vector<b2ShapeId>*>(shapes)->push_back(shape);
  return true;
}

}  // namespace

bool operator==(const Material& a, const Material& b) {
  return a.surface.friction == b.surface.friction && a.surface.restitution == b.surface.restitution &&
         a.surface.rollingResistance == b.surface.rollingResistance &&
         a.surface.tangentSpeed == b.surface.tangentSpeed && a.surface.userMaterialId == b.surface.userMaterialId &&
         a.surface.customColor == b.surface.customColor && a.filter.categoryBits == b.filter.categoryBits &&
         a.filter.maskBits == b.filter.maskBits && a.filter.groupIndex == b.filter.groupIndex &&
         a.enableSensorEvents == b.enableSensorEvents && a.enableContactEvents == b.enableContactEvents &&
         a.enableHitEvents == b.enableHitEvents && a.enablePreSolveEvents == b.enablePreSolveEvents &&
         a.enableCustomFiltering == b.enableCustomFiltering && a.isPassable == b.isPassable;
}

class Terrain::Memory {
 public:
  Frame frame;
  EdgeSet edges;
  std::vector<SegmentShape> shapes;
  std::vector<ChunkBody> bodies;
  std::size_t bodyCount;
  detail::KnownBodies disabled;
  Footings footings;
};

Terrain::Terrain(b2WorldId physics, const World& world, TerrainOptions options, Precision /*precision*/) noexcept
    : TerrainBase(physics, world, std::move(options)) {}

Terrain::MemoryPtr Terrain::remember() const noexcept {
  return std::make_shared<Memory>(Memory{frame_, edges_, shapes_, bodies_, bodyCount_, disabled_, *footings_});
}

// After chunks left or came back the world has another version than the mark's.
void Terrain::recall(const MemoryPtr& memory) noexcept {
  frame_ = memory->frame;
  edges_ = memory->edges;
  shapes_ = memory->shapes;
  bodies_ = memory->bodies;
  bodyCount_ = memory->bodyCount;
  disabled_ = memory->disabled;
  *footings_ = memory->footings;
  overlaps_.clear();
  for (const EdgeId id : edges_.edges()) b2Shape_SetUserData(shapes_[id.value].shape, userDataOf(id));
  if (!isCurrent()) resync();
}

bool Terrain::fits(b2BodyId body, Position at, b2Rot rotation) noexcept { return fitsAt(body, {at, rotation}); }

EdgeId TerrainBase::edgeOf(const b2ShapeId& shape) const {
  if (!b2Shape_IsValid(shape)) return {};
  const auto id = reinterpret_cast<std::uintptr_t>(b2Shape_GetUserData(shape));
  if (id >= shapes_.size() || !B2_ID_EQUALS(shapes_[id].shape, shape)) return {};
  return EdgeId{static_cast<std::uint32_t>(id)};
}

// In Box2D a chain segment is always shape A: it is after all others in the order of types.
std::optional<Touch> Terrain::hit(const b2ContactData& contact) const noexcept {
  const EdgeId id = edgeOf(contact.shapeIdA);
  const b2Manifold& manifold = contact.manifold;
  if (!id || manifold.pointCount == 0) return {};
  const Edge& edge = edges_.edge(id);
  Place middle = frame_.position(frame_.cornerOf(edges_.chunk(edge.chunk)));
  for (int k = 0; k < manifold.pointCount; ++k) {
    const b2Vec2 point = manifold.points[k].anchorA;  // relative to the chunk's body
    middle.x += static_cast<double>(point.x) / manifold.pointCount;
    middle.y += static_cast<double>(point.y) / manifold.pointCount;
  }
  const std::optional<Hit> found = nearestHit(world_, edges_, id, frame_, middle);
  if (!found) return {};
  return Touch{*found, toBox2D(normalOf(edge)), contact.shapeIdB};
}

std::vector<b2BodyId> TerrainBase::bodiesInRect(const CellRect& cells) const noexcept {
  if (isEmpty(cells)) return {};
  const auto metres = [&](std::int32_t from, std::int32_t to) {
    return static_cast<float>((1.0 + to - from) * frame_.cellSize);
  };
  const float skin = std::min(slop(), metres(0, 0) / 4);
  const float right = metres(cells.min.i, cells.max.i) - skin, top = metres(cells.min.j, cells.max.j) - skin;
  const b2Vec2 corners[] = {{skin, skin}, {right, skin}, {right, top}, {skin, top}};
  std::vector<b2ShapeId> shapes;
  overlapShape(physics_, position(toWorld(cells.min, {})), b2MakeProxy(corners, 4, 0), everyShape(), collect, &shapes);
  std::vector<b2BodyId> bodies;
  for (const b2ShapeId shape : shapes) {
    if (b2Shape_IsSensor(shape) || edgeOf(shape)) continue;
    const b2BodyId body = b2Shape_GetBody(shape);
    const auto isSame = [&](b2BodyId other) { return B2_ID_EQUALS(body, other); };
    if (std::none_of(bodies.begin(), bodies.end(), isSame)) bodies.push_back(body);
  }
  return bodies;
}

// Box2D lists no bodies, but counts them. If there are as many as before that are not known, none has come.
void TerrainBase::beforeStep() noexcept {
  const std::vector<std::uint64_t> known = footings_->allOf(isThereStill);
  for (const std::uint64_t number : known) {
    const b2BodyId body = b2LoadBodyId(number);
    if (canOverlap(body)) noteIfElsewhere(body);
  }
  const std::size_t all = bodyCountOf(physics_);
  if (all == bodyCount_ + known.size() + others_) return;
  for (const b2BodyId body : catchableIn(kEverywhere)) {
    if (!footings_->of(numberOf(body))) noteIfElsewhere(body);
  }
  others_ = all - bodyCount_ - footings_->size();
}

const std::vector<b2BodyId>& TerrainBase::afterStep() noexcept {
  putBack_.clear();
  const b2BodyEvents events = b2World_GetBodyEvents(physics_);
  for (int k = 0; k < events.moveCount; ++k) {
    const b2BodyId body = events.moveEvents[k].bodyId;
    if (b2Body_IsValid(body) && canOverlap(body)) lookAt(body, footings_->of(numberOf(body)));
  }
  if (footings_->size() > 2 * bodyCountOf(physics_) + 64) footings_->allOf(isThereStill);
  return putBack_;
}

}  // namespace lgs::box2d
