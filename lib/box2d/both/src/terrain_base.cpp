#include <lgs/box2d/terrain_base.h>
#include "calls.h"
#include "find_hit.h"
#include "footing.h"
#include "new_ground.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace lgs::box2d {

TerrainBase::TerrainBase(Physics physics, const World& world, TerrainOptions options)
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

TerrainBase::~TerrainBase() {
  if (!isThere(physics_)) return;
  for (const ChunkBody& chunk : bodies_) {
    if (isThere(chunk.body)) destroyBody(physics_, chunk.body);
  }
}

tl::expected<void, SyncError> TerrainBase::commit(World& world) {
  if (&world != &world_) return tl::unexpected(SyncError::notTheLast);
  return sync(world.commit());
}

tl::expected<void, SyncError> TerrainBase::sync(const Changes& changes) { return sync(changes, onCaught_); }

tl::expected<void, SyncError> TerrainBase::sync(const Changes& changes, OnCaught onCaught) {
  if (const auto misfit = edges_.misfit(world_, changes)) return tl::unexpected(*misfit);
  const NewGround ground = isAlone() ? NewGround(world_) : NewGround(world_, edges_, changes);
  caught_ = onCaught == OnCaught::leave ? std::vector<Caught>() : find(ground);
  apply(edges_.update(world_, changes));
  settle(ground.box(), onCaught);
  return {};
}

void TerrainBase::resync() {
  const NewGround ground = isAlone() ? NewGround(world_) : NewGround(world_, edges_);
  caught_ = onCaught_ == OnCaught::leave ? std::vector<Caught>() : findAll(ground);
  apply(edges_.load(world_));
  settle(kEverywhere, onCaught_);
  noteAll();
}

void TerrainBase::materialsChanged() {
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
  if (!isAlone()) wakeAround({&id, 1});
}

void TerrainBase::moveOrigin(Cell origin) {
  assertUnlocked(physics_);
  frame_.origin = origin;
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    if (isThere(bodies_[k].body)) moveTo(bodies_[k].body, positionOf(static_cast<std::uint32_t>(k)));
  }
  afterMovingOf(physics_);
  if (!isAlone()) afterRounding();
}

// Whether there are no bodies but the terrain's.
bool TerrainBase::isAlone() const { return bodyCountOf(physics_) <= bodyCount_; }

void TerrainBase::apply(const EdgeChanges& changes) {
  assertUnlocked(physics_);
  bodies_.resize(edges_.chunkCount());
  if (!isAlone()) wakeAround(changes);
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

// Where many edges of a square of cells change, as when much is undone, Box2D is asked first whether anybody is there.
void TerrainBase::wakeAround(const EdgeChanges& changes) {
  constexpr std::int64_t kSquare = 4 * kUnitsPerCell;
  std::vector<std::pair<std::uint64_t, EdgeId>> bySquare;
  const auto add = [&](const std::vector<EdgeId>& ids) {
    for (const EdgeId id : ids) {
      const Edge& edge = edges_.edge(id);
      const Point corner = frame_.cornerOf(edges_.chunk(edge.chunk));
      const auto column = static_cast<std::uint64_t>((edge.start.x - corner.x) / kSquare);
      const auto row = static_cast<std::uint64_t>((edge.start.y - corner.y) / kSquare);
      bySquare.emplace_back(std::uint64_t{edge.chunk} << 32 | row << 16 | column, id);
    }
  };
  if (!kDestroyingWakes) add(changes.removed);
  add(changes.added);
  add(changes.turned);
  std::sort(bySquare.begin(), bySquare.end());
  std::vector<EdgeId> square;
  for (std::size_t k = 0; k < bySquare.size(); ++k) {
    square.push_back(bySquare[k].second);
    if (k + 1 < bySquare.size() && bySquare[k + 1].first == bySquare[k].first) continue;
    wakeAround(square);
    square.clear();
  }
}

void TerrainBase::wakeAround(std::span<const EdgeId> ids) {
  constexpr std::size_t kFew = 4;
  bool isSomebodyThere = ids.size() <= kFew;
  if (!isSomebodyThere) forEachBodyAround(ids, [&](BodyHandle /*body*/) { isSomebodyThere = true; });
  if (!isSomebodyThere) return;
  for (const EdgeId& id : ids) forEachBodyAround({&id, 1}, [](BodyHandle body) { wakeUp(body); });
}

// The edges are of one chunk.
template <class Call>
void TerrainBase::forEachBodyAround(std::span<const EdgeId> ids, const Call& call) {
  const std::uint32_t chunk = edges_.edge(ids.front()).chunk;
  constexpr float kMost = std::numeric_limits<float>::max();
  b2Vec2 lower{kMost, kMost}, upper{-kMost, -kMost};
  for (const EdgeId id : ids) {
    const Edge& edge = edges_.edge(id);
    for (const Point p : {edge.start, edge.end}) {
      const Metres m = frame_.local(p, edges_.chunk(chunk));
      lower = {std::min(lower.x, m.x), std::min(lower.y, m.y)};
      upper = {std::max(upper.x, m.x), std::max(upper.y, m.y)};
    }
  }
  const float around = wakingDistance();
  forEachShapeIn(physics_, positionOf(chunk), {lower.x - around, lower.y - around},
                 {upper.x + around, upper.y + around}, [&](ShapeHandle shape) {
                   if (!isStatic(bodyOf(shape))) call(bodyOf(shape));
                 });
}

std::optional<Hit> TerrainBase::hit(const Shape& shape) const {
  const EdgeId id = edgeOf(shape);
  return id ? firstHit(world_, edges_, id) : std::nullopt;
}

std::optional<Hit> TerrainBase::hit(const Shape& shape, const Position& point) const {
  const EdgeId id = edgeOf(shape);
  return id ? nearestHit(world_, edges_, id, frame_, {point.x, point.y}) : std::nullopt;
}

std::optional<NearestHit> TerrainBase::nearest(const Position& point, float radius) const {
  const auto found = nearestTo(world_, frame_, {point.x, point.y}, radius);
  if (!found) return {};
  return NearestHit{found->hit, toBox2D(found->point), toBox2D(found->normal), found->distance};
}

std::optional<GroundRayHit> TerrainBase::rayCast(const Position& from, const Position& to) const {
  const auto ray = box2d::rayCast(world_, frame_, {from.x, from.y}, {to.x, to.y});
  if (!ray) return {};
  return GroundRayHit{ray->hit, toBox2D(ray->point), toBox2D(ray->normal), ray->fraction};
}

Position TerrainBase::position(Point p) const { return toBox2D(frame_.position(p)); }

Position TerrainBase::positionOf(std::uint32_t chunk) const { return position(frame_.cornerOf(edges_.chunk(chunk))); }

Point TerrainBase::latticePoint(const Position& p) const { return frame_.latticePoint({p.x, p.y}); }

Cell TerrainBase::cellAt(const Position& p) const { return frame_.cellAt({p.x, p.y}); }

}  // namespace lgs::box2d
