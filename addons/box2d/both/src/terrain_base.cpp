#include <lgs/box2d/terrain_base.h>
#include "calls.h"
#include "find_hit.h"
#include "footing.h"
#include "new_ground.h"
#include "way_out.h"

#include <algorithm>
#include <utility>

namespace lgs::box2d {

TerrainBase::TerrainBase(Physics physics, const World& world, TerrainOptions options) noexcept
    : physics_(physics),
      world_(world),
      frame_{options.cellSize, options.origin, options.chunkCells},
      onOverlap_(options.onOverlap),
      materials_(std::move(options.material)),
      edges_({.chunkCells = options.chunkCells,
              .shortest = frame_.unitsOf(slop()),
              .merge = options.merge,
              .material = [this](Block block) { return materials_.number(block); }}),
      disabled_(physics),
      footings_(std::make_unique<Footings>()) {
  loadEdges();
}

TerrainBase::~TerrainBase() noexcept {
  if (!isThere(physics_)) return;
  for (const ChunkBody& chunk : bodies_) {
    if (isThere(chunk.body)) destroyBody(physics_, chunk.body);
  }
}

tl::expected<void, SyncError> TerrainBase::commit(World& world) noexcept {
  if (&world != &world_) return tl::unexpected(SyncError::notTheLast);
  return sync(world.commit());
}

tl::expected<void, SyncError> TerrainBase::sync(const Changes& changes) noexcept {
  return sync(changes, onOverlap_, {});
}

tl::expected<void, SyncError> TerrainBase::sync(const Changes& changes, OnOverlap onOverlap) noexcept {
  return sync(changes, onOverlap, {});
}

tl::expected<void, SyncError> TerrainBase::sync(const Changes& changes, std::span<const BodyHandle> coming) noexcept {
  return sync(changes, onOverlap_, coming);
}

tl::expected<void, SyncError> TerrainBase::sync(const Changes& changes, OnOverlap onOverlap,
                                                std::span<const BodyHandle> coming) {
  if (const auto misfit = edges_.misfit(world_, changes)) return tl::unexpected(*misfit);
  assertUnlocked(physics_);
  const bool catches = onOverlap != OnOverlap::leave && !isAlone();
  const NewGround ground = isAlone() ? NewGround(world_) : NewGround(world_, edges_, changes);
  const EdgeChanges& edges = edges_.update(world_, changes);
  std::vector<BodyHandle> near = wakeAround(edges, catches ? ground.boxes() : std::vector<Box>());
  std::erase_if(near, [&](BodyHandle body) {
    return std::ranges::any_of(coming, [&](BodyHandle one) { return numberOf(one) == numberOf(body); });
  });
  overlaps_ = catches ? find(near, ground, Whose::free) : std::vector<Overlap>();
  if (catches)
    for (const BodyHandle body : coming) addIfOverlapping(body, ground, Whose::all, overlaps_);
  apply(edges);
  settle(ground.box(), onOverlap);
  return {};
}

void TerrainBase::resync() noexcept {
  assertUnlocked(physics_);
  const NewGround ground = isAlone() ? NewGround(world_) : NewGround(world_, edges_);
  overlaps_ =
      onOverlap_ == OnOverlap::leave ? std::vector<Overlap>() : find(catchableIn(kEverywhere), ground, Whose::all);
  loadEdges();
  settle(kEverywhere, onOverlap_);
  noteAll();
}

void TerrainBase::loadEdges() {
  const EdgeChanges& edges = edges_.load(world_);
  wakeAround(edges, {});
  apply(edges);
}

void TerrainBase::materialsChanged() noexcept {
  std::vector<std::pair<EdgeId, Material>> before;
  for (const EdgeId id : edges_.edges()) before.emplace_back(id, materials_.of(edges_.edge(id).block));
  materials_.askAgain();
  resync();
  for (const auto& [id, material] : before) {
    if (isMade(shapes_[id.value]) && !(materials_.of(edges_.edge(id).block) == material)) remake(id);
  }
}

void TerrainBase::remake(EdgeId id) {
  destroy(id);
  create(id);
  wakeAround({.removed = {}, .added = {id}, .relinked = {}, .turned = {}}, {});
}

void TerrainBase::moveOrigin(Cell origin) noexcept {
  assertUnlocked(physics_);
  frame_.origin = origin;
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    if (isThere(bodies_[k].body)) moveTo(bodies_[k].body, positionOf(static_cast<std::uint32_t>(k)));
  }
  afterMovingOf(physics_);
  if (!isAlone()) afterRounding();
}

// Whether there are no bodies but the terrain's.
bool TerrainBase::isAlone() const { return bodyCountOf(physics_) <= bodyCount_ + disabled_.ownCount(); }

void TerrainBase::apply(const EdgeChanges& changes) {
  bodies_.resize(edges_.chunkCount());
  for (const EdgeId id : changes.removed) destroy(id);
  for (const EdgeId id : changes.added) create(id);
  for (const EdgeId id : changes.turned) {
    const Edge& edge = edges_.edge(id);
    turnSegment(shapes_[id.value], bodies_[edge.chunk].body, id, materials_.of(edge.block), localEdge(id));
  }
  for (const EdgeId id : changes.removed) {
    ChunkBody& chunk = bodies_[edges_.edge(id).chunk];
    if (!isThere(chunk.body) || chunk.shapes != 0) continue;
    destroyBody(physics_, chunk.body);
    chunk.body = {};
    --bodyCount_;
  }
}

void TerrainBase::create(EdgeId id) {
  const Edge& edge = edges_.edge(id);
  ChunkBody& chunk = bodies_[edge.chunk];
  if (!isThere(chunk.body)) {
    chunk.body = makeStaticBody(physics_, positionOf(edge.chunk));
    ++bodyCount_;
  }
  if (shapes_.size() <= id.value) shapes_.resize(id.value + std::size_t{1});
  shapes_[id.value] = makeSegment(chunk.body, id, materials_.of(edge.block), localEdge(id));
  ++chunk.shapes;
}

void TerrainBase::destroy(EdgeId id) {
  destroySegment(shapes_[id.value]);
  shapes_[id.value] = {};
  --bodies_[edges_.edge(id).chunk].shapes;
}

LocalEdge TerrainBase::localEdge(EdgeId id) const {
  const Edge& edge = edges_.edge(id);
  return box2d::localEdge(edge, edges_.chunk(edge.chunk), frame_, slop());
}

std::optional<Hit> TerrainBase::hit(const Shape& shape) const noexcept {
  const EdgeId id = edgeOf(shape);
  return id ? firstHit(world_, edges_, id) : std::nullopt;
}

std::optional<Hit> TerrainBase::hit(const Shape& shape, const Position& point) const noexcept {
  const EdgeId id = edgeOf(shape);
  return id ? nearestHit(world_, edges_, id, frame_, {point.x, point.y}) : std::nullopt;
}

std::optional<NearestHit> TerrainBase::nearest(const Position& point, float radius) const noexcept {
  const auto found = nearestTo(world_, frame_, {point.x, point.y}, radius);
  if (!found) return {};
  return NearestHit{found->hit, toBox2D(found->point), toBox2D(found->normal), found->distance};
}

std::optional<GroundRayHit> TerrainBase::rayCast(const Position& from, const Position& to) const noexcept {
  const auto ray = box2d::rayCast(world_, frame_, {from.x, from.y}, {to.x, to.y});
  if (!ray) return {};
  return GroundRayHit{ray->hit, toBox2D(ray->point), toBox2D(ray->normal), ray->fraction};
}

Position TerrainBase::position(Point p) const noexcept { return toBox2D(frame_.position(p)); }

Position TerrainBase::positionOf(std::uint32_t chunk) const { return position(frame_.cornerOf(edges_.chunk(chunk))); }

Point TerrainBase::latticePoint(const Position& p) const noexcept { return frame_.latticePoint({p.x, p.y}); }

Cell TerrainBase::cellAt(const Position& p) const noexcept { return frame_.cellAt({p.x, p.y}); }

}  // namespace lgs::box2d
