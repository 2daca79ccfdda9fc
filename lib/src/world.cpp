// The public face of a World. It forwards to the parts of Impl, and rounds coordinates that are not lattice points.
#include "geometry/ring.h"
#include "refusal.h"
#include "world_impl.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lgs {

using detail::refuse;

namespace {

std::int32_t roundToLattice(double cells) {
  const double units = std::round(cells * kUnitsPerCell);
  // Outside the cell one value is as wrong as another, so two that fit an int stand for all of them. What is not
  // a number compares false, and so counts as too great.
  if (units < 0) return -1;
  if (!(units <= kUnitsPerCell)) return kUnitsPerCell + 1;
  return static_cast<std::int32_t>(units);
}

/// Finds the errors that rounding would hide, and only if no earlier one in the order of ErrorCode applies. The rest is
/// left to the engine.
template <class Real>
Expected<void> round(std::span<const RealPoint<Real>> polygon, std::vector<LocalPoint>& rounded) {
  rounded.clear();
  if (polygon.size() < 3) {
    rounded.resize(polygon.size());
    return {};
  }
  if (polygon.size() > kMaxVerticesPerCell) return refuse({.code = ErrorCode::capacity, .polygon = 0});
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const auto [x, y] = polygon[k];
    if (!std::isfinite(x) || !std::isfinite(y))
      return refuse({.code = ErrorCode::notFinite, .polygon = 0, .vertex = static_cast<std::int32_t>(k)});
    rounded.push_back({roundToLattice(x), roundToLattice(y)});
  }
  return {};
}

template <class Real>
Expected<ShapeId> shapeOfReals(World::Impl& world, std::span<const RealPoint<Real>> polygon) {
  if (const auto done = round(polygon, world.rounded); !done) return refuse(done.error());
  const detail::PolygonView view = world.rounded;
  return world.shape({&view, 1});
}

template <class Real>
Expected<PolygonHandle> addReals(World::Impl& world, Cell cell, std::span<const RealPoint<Real>> polygon, Block block) {
  if (!inRange(cell)) return refuse({.code = ErrorCode::cellOutOfRange, .cell = cell});
  if (const auto done = round(polygon, world.rounded); !done) return refuse(done.error(), cell);
  return world.add(cell, world.rounded, block);
}

}  // namespace

World::World(PreserveRelation preserve) : impl_(std::make_unique<Impl>(std::move(preserve))) {}
World::~World() = default;
World::World(const World& other) : impl_(std::make_unique<Impl>(*other.impl_)) {
  impl_->useOwnChunks();
  impl_->journal.forgetGroups(*impl_);
}
World& World::operator=(const World& other) {
  World copy(other);
  impl_.swap(copy.impl_);
  return *this;
}
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

void World::Impl::useOwnChunks() {
  for (detail::Chunk*& chunk : dirtyChunks) chunk = grid.chunks()[chunk->index - 1].get();
}

Expected<ShapeId> World::shape(std::span<const LocalPoint> polygon) { return impl_->shape({&polygon, 1}); }
Expected<ShapeId> World::shape(std::initializer_list<LocalPoint> polygon) {
  return shape(std::span<const LocalPoint>(polygon));
}
Expected<ShapeId> World::shape(std::span<const FloatPoint> polygon) { return shapeOfReals(*impl_, polygon); }
Expected<ShapeId> World::shape(std::span<const DoublePoint> polygon) { return shapeOfReals(*impl_, polygon); }

Expected<ShapeId> World::shape(std::span<const std::vector<LocalPoint>> polygons) {
  const std::vector<detail::PolygonView> views(polygons.begin(), polygons.end());
  return impl_->shape(views);
}

Expected<PolygonHandle> World::add(Cell cell, ShapeId shape, Block block) {
  if (const PolygonHandle handle = impl_->addQuickly(cell, shape, block)) return handle;
  return impl_->add(cell, shape, block);
}
Expected<PolygonHandle> World::add(Cell cell, ShapeId shape, Block block, std::span<PolygonHandle> handles) {
  return impl_->add(cell, shape, block, handles);
}
Expected<PolygonHandle> World::add(Cell cell, std::span<const LocalPoint> polygon, Block block) {
  return impl_->add(cell, polygon, block);
}
Expected<PolygonHandle> World::add(Cell cell, std::initializer_list<LocalPoint> polygon, Block block) {
  return impl_->add(cell, polygon, block);
}
Expected<PolygonHandle> World::add(Cell cell, std::span<const FloatPoint> polygon, Block block) {
  return addReals(*impl_, cell, polygon, block);
}
Expected<PolygonHandle> World::add(Cell cell, std::span<const DoublePoint> polygon, Block block) {
  return addReals(*impl_, cell, polygon, block);
}
Expected<void> World::remove(PolygonHandle polygon) { return impl_->remove(polygon); }
Expected<std::uint64_t> World::fill(const CellRect& cells, ShapeId shape, Block block) {
  return impl_->fill(cells, shape, block);
}
Expected<std::uint64_t> World::clear(const CellRect& cells) { return impl_->clear(cells); }
Expected<PolygonHandle> World::replace(Cell cell, ShapeId shape, Block block, std::span<PolygonHandle> handles) {
  return impl_->replace(cell, shape, block, handles);
}
Expected<void> World::exchange(Cell cell, std::span<const PolygonHandle> removed, std::span<const NewPolygon> added,
                               std::span<PolygonHandle> handles) {
  return impl_->exchange(cell, removed, added, handles);
}
Expected<void> World::setBlock(PolygonHandle polygon, Block block) { return impl_->setBlock(polygon, block); }
const Changes& World::commit() { return impl_->commit({}); }
const Changes& World::commit(const Executor& executor) { return impl_->commit(executor); }

Mark World::checkpoint() { return impl_->journal.mark(*impl_); }

Expected<void> World::rollBack(Mark mark) {
  if (!impl_->journal.knows(mark)) return refuse({.code = ErrorCode::unknownMark});
  impl_->journal.rollBack(*impl_, mark, impl_->changesOfRollBack);
  return {};
}

const Changes& World::changesOfRollBack() const { return impl_->changesOfRollBack; }

Expected<void> World::forget(Mark mark) {
  if (!impl_->journal.knows(mark)) return refuse({.code = ErrorCode::unknownMark});
  impl_->journal.forget(*impl_, mark);
  return {};
}

Transaction::Transaction(World& world) : world_(&world), mark_(world.impl_->journal.mark(*world.impl_, true)) {}

void Transaction::keep() {
  if (mark_) static_cast<void>(world_->forget(std::exchange(mark_, {})));
}

// A commit has handed out what was edited before it, so that can not be taken back in silence.
Transaction::~Transaction() {
  if (!mark_ || !world_->impl_->journal.knows(mark_)) return;  // kept; or the world went back to a moment before it
  detail::Journal& journal = world_->impl_->journal;
  Changes none;  // there was no commit; and changesOfRollBack() stays as it is
  if (!journal.committedSince(mark_)) journal.rollBack(*world_->impl_, mark_, none);
  journal.forget(*world_->impl_, mark_);
}

std::vector<PlacedPolygon> World::polygons(Cell cell) const {
  std::vector<PlacedPolygon> out;
  polygons(cell, out);
  return out;
}
void World::polygons(Cell cell, std::vector<PlacedPolygon>& out) const { impl_->polygons(cell, out); }

bool World::isEmpty(Cell cell) const {
  const detail::CellAt at = impl_->grid.find(cell);
  return !at || impl_->grid.content(at) == detail::kEmptyContent;
}
void World::forEachPolygon(const PolygonVisitor& visit) const {
  impl_->forEachPolygon({{-kMaxCell, -kMaxCell}, {kMaxCell, kMaxCell}}, visit);
}
void World::forEachPolygon(const CellRect& cells, const PolygonVisitor& visit) const {
  impl_->forEachPolygon(cells, visit);
}
std::optional<CellRect> World::bounds() const { return impl_->bounds(); }

Expected<std::vector<std::span<const LocalPoint>>> World::polygonsOf(ShapeId shape) const {
  const detail::InternedShape* interned = impl_->catalogue.shape(shape);
  if (!interned) return refuse({.code = ErrorCode::unknownShape});
  std::vector<std::span<const LocalPoint>> out;
  for (const detail::PolygonId id : interned->polygons) out.push_back(impl_->catalogue.vertices(id));
  return out;
}

Expected<LocalBox> World::boundingBox(ShapeId shape) const {
  const auto all = polygonsOf(shape);
  if (!all) return refuse(all.error());
  LocalBox box{all->front().front(), all->front().front()};
  for (const auto polygon : *all) {
    const detail::Box<LocalPoint> one = detail::boundingBox(polygon);
    box.min = {std::min(box.min.x, one.min.x), std::min(box.min.y, one.min.y)};
    box.max = {std::max(box.max.x, one.max.x), std::max(box.max.y, one.max.y)};
  }
  return box;
}

bool samePolygons(const World& a, const World& b) {
  return a.impl_->holdsPolygonsOf(*b.impl_) && b.impl_->holdsPolygonsOf(*a.impl_);
}

Spot World::at(Point point) const { return impl_->at(point); }
Expected<Nearest> World::nearest(Point point, double radius) const { return impl_->nearest(point, radius); }
Expected<RayHit> World::rayCast(Point from, Point to) const { return impl_->rayCast(from, to); }

Expected<PlacedPolygon> World::polygon(PolygonHandle handle) const {
  if (const auto found = impl_->polygon(handle)) return *found;
  return refuse({.code = ErrorCode::staleHandle, .other = handle});
}

Expected<Cell> World::cellOf(PolygonHandle handle) const {
  return polygon(handle).map([&](const PlacedPolygon&) { return impl_->grid.cellOf(handle.cellRef); });
}

Expected<Segment> World::segment(SegmentId id) const {
  if (impl_->segments.isLive(id.value)) return impl_->segment(id.value);
  return refuse({.code = ErrorCode::unknownSegment, .segment = id});
}

std::vector<SegmentId> World::segments() const { return impl_->liveSegments(); }
std::vector<SegmentId> World::segments(const CellRect& cells) const { return impl_->segmentsIn(cells); }
std::vector<Loop> World::loops(Collinear collinear) const { return impl_->loops(collinear); }
const PreserveRelation& World::preserveRelation() const { return impl_->preserve; }
std::uint64_t World::version() const { return impl_->version; }
std::uint32_t World::maxSegmentId() const { return impl_->segments.maxId(); }
Stats World::stats() const { return impl_->stats(); }

}  // namespace lgs
