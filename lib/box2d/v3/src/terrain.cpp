#include <lgs/box2d/terrain.h>
#include "footing.h"
#include "form.h"
#include "local_edge.h"
#include "new_ground.h"
#include "segment_shape.h"
#include "to_box2d.h"

#include <algorithm>

namespace lgs::box2d {

namespace {

void* userDataOf(EdgeId id) {
  return reinterpret_cast<void*>(static_cast<std::uintptr_t>(id.value));  // NOLINT(performance-no-int-to-ptr)
}

bool wake(b2ShapeId shape, void* /*context*/) {
  const b2BodyId body = b2Shape_GetBody(shape);
  if (b2Body_GetType(body) != b2_staticBody) b2Body_SetAwake(body, true);
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
  std::vector<Body> bodies;
  std::size_t bodyCount;
  std::vector<b2BodyId> held;
  Footings footings;
};

Terrain::Terrain(b2WorldId physics, const World& world, TerrainOptions options, Precision /*precision*/)
    : physics_(physics),
      world_(world),
      frame_{options.cellSize, options.origin, options.chunkCells},
      onCaught_(options.onCaught),
      materials_(std::move(options.material)),
      edges_({.chunkCells = options.chunkCells,
              .shortest = frame_.unitsOf(slop()),
              .merge = options.merge,
              .material = [this](Block block) { return materials_.number(block); }}),
      footings_(std::make_unique<Footings>()) {
  apply(edges_.load(world_));
}

Terrain::~Terrain() {
  for (const Body& body : bodies_) {
    if (B2_IS_NON_NULL(body.body)) b2DestroyBody(body.body);
  }
}

tl::expected<void, SyncError> Terrain::commit(World& world) {
  if (&world != &world_) return tl::unexpected(SyncError::notTheLast);
  return sync(world.commit());
}

tl::expected<void, SyncError> Terrain::sync(const Changes& changes) { return sync(changes, onCaught_); }

tl::expected<void, SyncError> Terrain::sync(const Changes& changes, OnCaught onCaught) {
  if (const auto misfit = edges_.misfit(world_, changes)) return tl::unexpected(*misfit);
  const NewGround ground = isAlone() ? NewGround(world_) : NewGround(world_, edges_, changes);
  caught_ = onCaught == OnCaught::leave ? std::vector<Caught>() : find(ground);
  apply(edges_.update(world_, changes));
  settle(ground.box(), onCaught);
  return {};
}

void Terrain::resync() {
  const NewGround ground = isAlone() ? NewGround(world_) : NewGround(world_, edges_);
  caught_ = onCaught_ == OnCaught::leave ? std::vector<Caught>() : findAll(ground);
  apply(edges_.load(world_));
  settle(kEverywhere, onCaught_);
  noteAll();
}

Terrain::MemoryPtr Terrain::remember() const {
  return std::make_shared<Memory>(Memory{frame_, edges_, shapes_, bodies_, bodyCount_, held_, *footings_});
}

// Going back over commits that come to nothing leaves the world another version than the mark's.
void Terrain::recall(const MemoryPtr& memory) {
  frame_ = memory->frame;
  edges_ = memory->edges;
  shapes_ = memory->shapes;
  bodies_ = memory->bodies;
  bodyCount_ = memory->bodyCount;
  held_ = memory->held;
  *footings_ = memory->footings;
  caught_.clear();
  for (const EdgeId id : edges_.edges()) b2Shape_SetUserData(shapes_[id.value].shape, userDataOf(id));
  if (!isCurrent()) resync();
}

void Terrain::materialsChanged() {
  std::vector<std::pair<EdgeId, Material>> before;
  for (const EdgeId id : edges_.edges()) before.emplace_back(id, materials_.of(edges_.edge(id).block));
  materials_.askAgain();
  resync();
  for (const auto& [id, material] : before) {
    const bool isThere = B2_IS_NON_NULL(shapes_[id.value].shape);
    if (isThere && !(materials_.of(edges_.edge(id).block) == material)) remake(id);
  }
}

void Terrain::remake(EdgeId id) {
  destroy(id);
  create(id);
  if (!isAlone()) wakeAround(id);
}

void Terrain::moveOrigin(Cell origin) {
  frame_.origin = origin;
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    if (B2_IS_NON_NULL(bodies_[k].body))
      b2Body_SetTransform(bodies_[k].body, positionOf(static_cast<std::uint32_t>(k)), b2Rot_identity);
  }
  // Box2D puts shapes that move back into its tree one by one. After some moves the tree would be so deep that Box2D
  // does not find all of them.
  b2World_RebuildStaticTree(physics_);
}

bool Terrain::isAlone() const {
  return static_cast<std::size_t>(b2World_GetCounters(physics_).bodyCount) <= bodyCount_;
}

void Terrain::apply(const EdgeChanges& changes) {
  bodies_.resize(edges_.chunkCount());
  if (!isAlone()) {
    for (const EdgeId id : changes.removed) wakeAround(id);
    for (const EdgeId id : changes.added) wakeAround(id);
    for (const EdgeId id : changes.turned) wakeAround(id);
  }
  for (const EdgeId id : changes.removed) destroy(id);
  for (const EdgeId id : changes.added) create(id);
  for (const EdgeId id : changes.turned) relink(id);
  for (const EdgeId id : changes.removed) {
    Body& body = bodies_[edges_.edge(id).chunk];
    if (B2_IS_NULL(body.body) || body.shapes != 0) continue;
    b2DestroyBody(body.body);
    body.body = b2_nullBodyId;
    --bodyCount_;
  }
}

void Terrain::create(EdgeId id) {
  const std::uint32_t number = edges_.edge(id).chunk;
  Body& body = bodies_[number];
  if (B2_IS_NULL(body.body)) {
    b2BodyDef definition = b2DefaultBodyDef();
    definition.position = positionOf(number);
    body.body = b2CreateBody(physics_, &definition);
    ++bodyCount_;
  }
  if (shapes_.size() <= id.value) shapes_.resize(id.value + std::size_t{1});
  shapes_[id.value] = makeSegment(body.body, definitionOf(id), segmentOf(id));
  ++body.shapes;
}

void Terrain::destroy(EdgeId id) {
  destroySegment(shapes_[id.value]);
  shapes_[id.value] = {};
  --bodies_[edges_.edge(id).chunk].shapes;
}

void Terrain::relink(EdgeId id) {
  changeSegment(shapes_[id.value], bodies_[edges_.edge(id).chunk].body, definitionOf(id), segmentOf(id));
}

b2ShapeDef Terrain::definitionOf(EdgeId id) {
  const Material& material = materials_.of(edges_.edge(id).block);
  b2ShapeDef definition = b2DefaultShapeDef();
  definition.userData = userDataOf(id);
  definition.material = material.surface;
  definition.filter = material.filter;
  definition.enableSensorEvents = material.enableSensorEvents;
  definition.enableContactEvents = material.enableContactEvents;
  definition.enableHitEvents = material.enableHitEvents;
  definition.enablePreSolveEvents = material.enablePreSolveEvents;
  setCustomFiltering(definition, material.enableCustomFiltering);
  return definition;
}

b2ChainSegment Terrain::segmentOf(EdgeId id) const {
  const Edge& edge = edges_.edge(id);
  const LocalEdge local = localEdge(edge, edges_.chunk(edge.chunk), frame_, slop());
  return {toBox2D(local.ghost1), {toBox2D(local.start), toBox2D(local.end)}, toBox2D(local.ghost2), 0};
}

void Terrain::wakeAround(EdgeId id) {
  const Edge& edge = edges_.edge(id);
  const Chunk chunk = edges_.chunk(edge.chunk);
  const Metres a = frame_.local(edge.start, chunk);
  const Metres b = frame_.local(edge.end, chunk);
  const float margin = 0.1F * b2GetLengthUnitsPerMeter();
  const b2AABB box{{std::min(a.x, b.x) - margin, std::min(a.y, b.y) - margin},
                   {std::max(a.x, b.x) + margin, std::max(a.y, b.y) + margin}};
  // The filter must find every body. The default has one category, which the mask of a body may leave out.
  b2QueryFilter all = b2DefaultQueryFilter();
  all.categoryBits = UINT64_MAX;
  all.maskBits = UINT64_MAX;
  forEachShapeIn(physics_, positionOf(edge.chunk), box, all, wake, nullptr);
}

b2ShapeId Terrain::shape(SegmentId segment) const {
  const EdgeId edge = edges_.edgeOf(segment);
  return edge ? shapes_[edge.value].shape : b2_nullShapeId;
}

Position Terrain::position(Point p) const { return toBox2D(frame_.position(p)); }

Position Terrain::positionOf(std::uint32_t chunk) const { return position(frame_.cornerOf(edges_.chunk(chunk))); }

Point Terrain::latticePoint(Position p) const { return frame_.latticePoint({p.x, p.y}); }

Cell Terrain::cellAt(Position p) const { return frame_.cellAt({p.x, p.y}); }

}  // namespace lgs::box2d
