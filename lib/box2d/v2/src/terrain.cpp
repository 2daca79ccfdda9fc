#include <lgs/box2d/terrain.h>
#include "footing.h"
#include "form.h"
#include "local_edge.h"
#include "new_ground.h"
#include "to_box2d.h"

#include <cassert>

namespace lgs::box2d {

namespace {

class Waker : public b2QueryCallback {
 public:
  bool ReportFixture(b2Fixture* fixture) override {
    b2Body& body = *fixture->GetBody();
    if (body.GetType() != b2_staticBody) body.SetAwake(true);
    return true;
  }
};

}  // namespace

bool operator==(const Material& a, const Material& b) {
  return a.friction == b.friction && a.restitution == b.restitution &&
         a.restitutionThreshold == b.restitutionThreshold && a.filter.categoryBits == b.filter.categoryBits &&
         a.filter.maskBits == b.filter.maskBits && a.filter.groupIndex == b.filter.groupIndex &&
         a.isPassable == b.isPassable;
}

Terrain::Terrain(b2World& physics, const World& world, TerrainOptions options)
    : physics_(physics),
      world_(world),
      frame_{options.cellSize, options.origin, options.chunkCells},
      onCaught_(options.onCaught),
      materials_(std::move(options.material)),
      edges_({.chunkCells = options.chunkCells,
              .shortest = frame_.unitsOf(b2_linearSlop),
              .merge = options.merge,
              .material = [this](Block block) { return materials_.number(block); }}),
      footings_(std::make_unique<Footings>()) {
  apply(edges_.load(world_));
}

Terrain::~Terrain() {
  for (const Body& body : bodies_) {
    if (body.body != nullptr) physics_.DestroyBody(body.body);
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

void Terrain::materialsChanged() {
  std::vector<std::pair<EdgeId, Material>> before;
  for (const EdgeId id : edges_.edges()) before.emplace_back(id, materials_.of(edges_.edge(id).block));
  materials_.askAgain();
  resync();
  for (const auto& [id, material] : before) {
    const bool isThere = fixtures_[id.value] != nullptr;
    if (isThere && !(materials_.of(edges_.edge(id).block) == material)) remake(id);
  }
}

void Terrain::remake(EdgeId id) {
  destroy(id);
  create(id);
  if (!isAlone()) wakeAround(*fixtures_[id.value]);
}

void Terrain::moveOrigin(Cell origin) {
  assert(!physics_.IsLocked());
  frame_.origin = origin;
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    if (bodies_[k].body != nullptr) bodies_[k].body->SetTransform(positionOf(static_cast<std::uint32_t>(k)), 0);
  }
}

void Terrain::apply(const EdgeChanges& changes) {
  assert(!physics_.IsLocked());
  bodies_.resize(edges_.chunkCount());
  for (const EdgeId id : changes.removed) destroy(id);
  for (const EdgeId id : changes.added) create(id);
  for (const EdgeId id : changes.turned) {
    auto& shape = static_cast<b2EdgeShape&>(*fixtures_[id.value]->GetShape());
    const b2EdgeShape with = shapeOf(edges_.edge(id));
    shape.m_vertex0 = with.m_vertex0;
    shape.m_vertex3 = with.m_vertex3;
  }
  // Box2D itself wakes what touched a fixture that is destroyed. For the other changes the terrain has to ask what is
  // there, unless there are no bodies but its own.
  if (!isAlone()) {
    for (const EdgeId id : changes.added) wakeAround(*fixtures_[id.value]);
    for (const EdgeId id : changes.turned) wakeAround(*fixtures_[id.value]);
  }
  for (const EdgeId id : changes.removed) {
    Body& body = bodies_[edges_.edge(id).chunk];
    if (body.body == nullptr || body.fixtures != 0) continue;
    physics_.DestroyBody(body.body);
    body.body = nullptr;
    --bodyCount_;
  }
}

void Terrain::create(EdgeId id) {
  const Edge& edge = edges_.edge(id);
  Body& body = bodies_[edge.chunk];
  if (body.body == nullptr) {
    b2BodyDef definition;
    definition.position = positionOf(edge.chunk);
    body.body = physics_.CreateBody(&definition);
    ++bodyCount_;
  }
  const b2EdgeShape shape = shapeOf(edge);
  const Material& material = materials_.of(edge.block);
  b2FixtureDef definition;
  definition.shape = &shape;
  definition.userData.pointer = id.value;
  definition.friction = material.friction;
  definition.restitution = material.restitution;
  definition.restitutionThreshold = material.restitutionThreshold;
  definition.filter = material.filter;
  if (fixtures_.size() <= id.value) fixtures_.resize(id.value + std::size_t{1}, nullptr);
  fixtures_[id.value] = body.body->CreateFixture(&definition);
  ++body.fixtures;
}

void Terrain::destroy(EdgeId id) {
  Body& body = bodies_[edges_.edge(id).chunk];
  body.body->DestroyFixture(fixtures_[id.value]);
  fixtures_[id.value] = nullptr;
  --body.fixtures;
}

b2EdgeShape Terrain::shapeOf(const Edge& edge) const {
  const LocalEdge local = localEdge(edge, edges_.chunk(edge.chunk), frame_, b2_linearSlop);
  b2EdgeShape shape;
  shape.SetOneSided(toBox2D(local.ghost1), toBox2D(local.start), toBox2D(local.end), toBox2D(local.ghost2));
  return shape;
}

void Terrain::wakeAround(b2Fixture& fixture) {
  Waker waker;
  physics_.QueryAABB(&waker, fixture.GetAABB(0));
}

b2Fixture* Terrain::fixture(SegmentId segment) const {
  const EdgeId edge = edges_.edgeOf(segment);
  return edge ? fixtures_[edge.value] : nullptr;
}

b2Vec2 Terrain::position(Point p) const { return toBox2D(frame_.position(p)); }

b2Vec2 Terrain::positionOf(std::uint32_t chunk) const { return position(frame_.cornerOf(edges_.chunk(chunk))); }

Point Terrain::latticePoint(const b2Vec2& p) const { return frame_.latticePoint({p.x, p.y}); }

Cell Terrain::cellAt(const b2Vec2& p) const { return frame_.cellAt({p.x, p.y}); }

}  // namespace lgs::box2d
