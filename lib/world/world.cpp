// The public face of a World. It forwards to ground, outline and history, and rounds coordinates that are not lattice
// points.
#include "geometry/ring.h"
#include "ground/places.h"
#include "ground/refusal.h"
#include "outline/fetch.h"
#include "outline/read.h"
#include "world/impl.h"
#include "world/snapshot.h"
#include "world/validate.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace lgs {

using detail::refuse;
using detail::refuseAt;

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
  if (polygon.size() < 3) return {};  // an empty polygon is refused as tooFewVertices, too
  if (polygon.size() > kMaxVerticesPerCell) return refuse({.code = ErrorCode::capacity, .polygon = 0});
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const auto [x, y] = polygon[k];
    if (!std::isfinite(x) || !std::isfinite(y))
      return refuse({.code = ErrorCode::notFinite, .polygon = 0, .vertex = static_cast<std::int32_t>(k)});
    rounded.push_back({roundToLattice(x), roundToLattice(y)});
  }
  return {};
}

/// The same for a cell.
template <class Real>
Expected<void> roundIn(Cell cell, std::span<const RealPoint<Real>> polygon, std::vector<LocalPoint>& rounded) {
  if (!inRange(cell)) return refuse({.code = ErrorCode::cellOutOfRange, .cell = cell});
  if (const auto done = round(polygon, rounded); !done) return refuse(done.error(), cell);
  return {};
}

/// Why a segment can not be read: it is not there, or hidden.
Error noSegment(const World::Impl& world, SegmentId id) {
  if (!world.outline.segments.isLive(id.value)) return {.code = ErrorCode::unknownSegment, .segment = id};
  const Cell cell = world.ground.grid.cellOf(world.outline.segments[id.value].cellRef);
  return {.code = ErrorCode::unloaded, .cell = cell, .segment = id};
}

/// Writes what `convert` makes of each segment.
template <class Out, class Convert>
Expected<void> write(const World::Impl& world, std::span<const SegmentId> ids, std::span<Out> out, Convert&& convert) {
  const std::size_t count = std::min(ids.size(), out.size());
  if (count > kMaxEntries) return refuse({.code = ErrorCode::capacity});
  for (std::size_t k = 0; k < count; ++k) {
    if (!world.outline.isShown(ids[k])) return refuseAt(noSegment(world, ids[k]), &Error::index, k);
    out[k] = convert(segmentOf(world.ground.grid, world.outline, ids[k].value));
  }
  return {};
}

template <class Real>
Expected<void> writeReals(const World::Impl& world, std::span<const SegmentId> ids, Point origin,
                          std::span<RealSegment<Real>> out) {
  if (!inRange(origin)) return refuse({.code = ErrorCode::outOfReach});
  const auto cells = [&](Point p) {
    const auto part = [](std::int64_t units) { return static_cast<Real>(static_cast<double>(units) / kUnitsPerCell); };
    return RealPoint<Real>{part(p.x - origin.x), part(p.y - origin.y)};
  };
  return write(world, ids, out, [&](const Segment& s) {
    return RealSegment<Real>{s.id,        cells(s.start),  cells(s.end),    s.predecessor,
                             s.successor, cells(s.ghost1), cells(s.ghost2), s.block,
                             s.polygon,   s.cell};
  });
}

/// Before an edit of a cell: in a large world, if it is the first one since a commit. Often it is the only one.
template <class Find>
void fetch(const World::Impl& world, Find&& find) {
  if (!isLarge(world.outline) || !world.ground.changedChunks().empty()) [[likely]]
    return;
  fetchAround(world.outline, world.ground.grid, find());
}
void fetch(const World::Impl& world, Cell cell) {
  fetch(world, [&] { return world.ground.grid.refOf(cell); });
}
void fetch(const World::Impl& world, PolygonHandle polygon) {
  fetch(world, [&] { return polygon.cellRef; });
}

}  // namespace

World::World(PreserveRelation preserve, Handles /*handles*/) noexcept
    : impl_(std::make_unique<Impl>(std::move(preserve))) {}
World::~World() noexcept = default;
World::World(const World& other) noexcept : impl_(std::make_unique<Impl>(*other.impl_)) {}
World& World::operator=(const World& other) noexcept {
  World copy(other);
  impl_.swap(copy.impl_);
  return *this;
}
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

// --- Shapes

Expected<ShapeId> World::shape(std::span<const LocalPoint> polygon) noexcept {
  return impl_->edit.shape({&polygon, 1});
}
Expected<ShapeId> World::shape(std::initializer_list<LocalPoint> polygon) noexcept {
  return shape(std::span<const LocalPoint>(polygon));
}
Expected<ShapeId> World::shape(std::span<const FloatPoint> polygon) noexcept {
  return round(polygon, impl_->rounded).and_then([&] { return shape(std::span<const LocalPoint>(impl_->rounded)); });
}
Expected<ShapeId> World::shape(std::span<const DoublePoint> polygon) noexcept {
  return round(polygon, impl_->rounded).and_then([&] { return shape(std::span<const LocalPoint>(impl_->rounded)); });
}
Expected<ShapeId> World::shape(std::span<const std::vector<LocalPoint>> polygons) noexcept {
  const std::vector<detail::PolygonView> views(polygons.begin(), polygons.end());
  return impl_->edit.shape(views);
}

Expected<std::vector<std::span<const LocalPoint>>> World::polygonsOf(ShapeId shape) const noexcept {
  const std::vector<detail::PolygonId>& polygons = impl_->ground.catalogue.shape(shape).polygons;
  if (polygons.empty()) return refuse({.code = ErrorCode::unknownShape});
  std::vector<std::span<const LocalPoint>> out;
  for (const detail::PolygonId id : polygons) out.push_back(impl_->ground.catalogue.vertices(id));
  return out;
}

Expected<LocalBox> World::boundingBox(ShapeId shape) const noexcept {
  const auto all = polygonsOf(shape);
  if (!all) return refuse(all.error());
  std::vector<LocalPoint> vertices;
  for (const auto polygon : *all) vertices.insert(vertices.end(), polygon.begin(), polygon.end());
  const auto [min, max] = detail::boundingBox(vertices);
  return LocalBox{min, max};
}

// --- Edits

Expected<PolygonHandle> World::add(Cell cell, ShapeId shape, Block block) noexcept {
  if (PolygonHandle handle; impl_->edit.addSole(cell, shape, block, handle)) return handle;
  return add(cell, shape, block, std::span<PolygonHandle>());
}
// Where it is inlined into the one above, the usual case is slower.
[[gnu::noinline]] Expected<PolygonHandle> World::add(Cell cell, ShapeId shape, Block block,
                                                     std::span<PolygonHandle> handles) noexcept {
  fetch(*impl_, cell);
  return impl_->edit.add(cell, shape, block, handles);
}
Expected<PolygonHandle> World::add(Cell cell, std::span<const LocalPoint> polygon, Block block) noexcept {
  fetch(*impl_, cell);
  return impl_->edit.add(cell, polygon, block);
}
Expected<PolygonHandle> World::add(Cell cell, std::initializer_list<LocalPoint> polygon, Block block) noexcept {
  return add(cell, std::span<const LocalPoint>(polygon), block);
}
Expected<PolygonHandle> World::add(Cell cell, std::span<const FloatPoint> polygon, Block block) noexcept {
  return roundIn(cell, polygon, impl_->rounded).and_then([&] { return impl_->edit.add(cell, impl_->rounded, block); });
}
Expected<PolygonHandle> World::add(Cell cell, std::span<const DoublePoint> polygon, Block block) noexcept {
  return roundIn(cell, polygon, impl_->rounded).and_then([&] { return impl_->edit.add(cell, impl_->rounded, block); });
}
Expected<void> World::addMany(std::span<const Placement> placements, std::span<PolygonHandle> handles) noexcept {
  return impl_->edit.addMany(placements, handles);
}
Expected<void> World::remove(PolygonHandle polygon) noexcept {
  fetch(*impl_, polygon);
  return impl_->edit.remove(polygon);
}
Expected<void> World::removeMany(std::span<const PolygonHandle> polygons) noexcept {
  return impl_->edit.removeMany(polygons);
}
Expected<PolygonHandle> World::replace(Cell cell, ShapeId shape, Block block,
                                       std::span<PolygonHandle> handles) noexcept {
  fetch(*impl_, cell);
  return impl_->edit.replace(cell, shape, block, handles);
}
Expected<void> World::exchange(Cell cell, std::span<const PolygonHandle> removed, std::span<const NewPolygon> added,
                               std::span<PolygonHandle> handles) noexcept {
  fetch(*impl_, cell);
  return impl_->edit.exchange(cell, removed, added, handles);
}
Expected<void> World::setBlock(PolygonHandle polygon, Block block) noexcept {
  fetch(*impl_, polygon);
  return impl_->edit.setBlock(polygon, block);
}
Expected<std::uint64_t> World::fill(const CellRect& cells, ShapeId shape, Block block,
                                    std::span<PolygonHandle> handles) noexcept {
  return impl_->edit.fill(cells, shape, block, handles);
}
Expected<std::uint64_t> World::clearRect(const CellRect& cells) noexcept { return impl_->edit.clear(cells); }

const Changes& World::commit() noexcept { return commit({}); }
const Changes& World::commit(const Executor& executor) noexcept {
  impl_->history.commit(executor);
#ifndef NDEBUG
  // Now and then, as it looks at everything; not for ever, as it takes memory, and tests count what a long game takes.
  const std::uint64_t commits = ++impl_->commits;
  assert(commits > 1'024 || (commits & (commits - 1)) != 0 || detail::isValid(*impl_));
#endif
  return impl_->outline.changes();
}

// --- Roll-back

Mark World::mark() noexcept { return impl_->history.mark(); }

Expected<void> World::rollBack(Mark mark, Undone undone) noexcept {
  if (!impl_->history.knows(mark)) return refuse({.code = ErrorCode::unknownMark});
  impl_->history.rollBack(mark, undone, impl_->changesOfRollBack);
  return {};
}

Expected<void> World::redo(Mark mark) noexcept {
  if (!impl_->history.isAhead(mark)) return refuse({.code = ErrorCode::unknownMark});
  impl_->history.redo(mark, impl_->changesOfRollBack);
  return {};
}

const Changes& World::changesOfRollBack() const noexcept { return impl_->changesOfRollBack; }

Expected<void> World::forget(Mark mark) noexcept {
  if (!impl_->history.knows(mark)) return refuse({.code = ErrorCode::unknownMark});
  impl_->history.forget(mark);
  return {};
}

Transaction::Transaction(World& world) noexcept
    : world_(&world), mark_(world.impl_->history.mark(detail::History::Of::group)) {}

void Transaction::keep() noexcept {
  detail::History& history = world_->impl_->history;
  if (history.knows(mark_, detail::History::Of::group)) history.forget(mark_);
  mark_ = {};
}

// A commit has handed out what was edited before it, so that can not be taken back in silence.
Transaction::~Transaction() noexcept {
  if (!mark_) return;  // kept
  detail::History& history = world_->impl_->history;
  if (!history.knows(mark_, detail::History::Of::group)) return;  // the world rolled back to a moment before it
  if (!history.committedSince(mark_)) history.takeBack(mark_);
  history.forget(mark_);
}

// --- Leaving places

Expected<std::uint64_t> World::forgetChunks(const CellRect& cells) noexcept {
  if (lgs::isEmpty(cells)) return std::uint64_t{0};
  if (const auto done = detail::checkCorners(cells); !done) return refuse(done.error());
  if (impl_->ground.hasChanged() || impl_->history.hasMarks()) return refuse({.code = ErrorCode::uncommitted});
  const std::vector<std::uint32_t> gone = impl_->ground.forgetChunks(cells);
  for (const std::uint32_t chunk : gone) impl_->outline.forget(chunk);
  impl_->outline.giveBackPages();
  return gone.size();
}

Expected<std::uint64_t> World::unload(const CellRect& cells, const ChunkSink& sink) noexcept {
  if (lgs::isEmpty(cells)) return std::uint64_t{0};
  if (const auto done = detail::checkCorners(cells); !done) return refuse(done.error());
  const std::vector<std::uint32_t> chunks = impl_->ground.chunksWithin(cells, false);
  for (const std::uint32_t number : chunks) {
    const detail::Chunk& chunk = impl_->ground.grid.chunk(number);
    const std::vector<std::byte> bytes = detail::saveChunk(impl_->ground, chunk);
    if (sink) sink(chunk.cell(0), bytes);
    impl_->history.leaves(number);
    impl_->ground.unload(number, detail::checksumOf(bytes));
  }
  return chunks.size();
}

tl::expected<Cell, SnapshotError> World::reload(std::span<const std::byte> chunk) noexcept {
  const std::size_t unloaded = impl_->ground.grid.unloadedCount();
  const auto corner = detail::loadChunk(chunk, impl_->ground);
  const bool isBack = corner && impl_->ground.grid.unloadedCount() < unloaded;
  if (isBack) impl_->history.comesBack(impl_->ground.grid.find(*corner).chunk->index);
  return corner;
}

Expected<std::uint64_t> World::reloadEmpty(const CellRect& cells) noexcept {
  if (lgs::isEmpty(cells)) return std::uint64_t{0};
  if (const auto done = detail::checkCorners(cells); !done) return refuse(done.error());
  const std::vector<std::uint32_t> chunks = impl_->ground.chunksWithin(cells, true);
  for (const std::uint32_t number : chunks) {
    impl_->ground.loadEmpty(number);
    impl_->history.comesBack(number);
  }
  return chunks.size();
}

std::optional<Cell> World::firstUnloaded(const CellRect& cells) const noexcept {
  if (lgs::isEmpty(cells)) return std::nullopt;
  return impl_->ground.firstUnloaded(cells);
}

// --- Following the ground

Expected<void> World::followCells(bool follow) noexcept {
  if (impl_->ground.hasChanged() || impl_->history.hasMarks()) return refuse({.code = ErrorCode::uncommitted});
  impl_->history.follow(follow);
  return {};
}

bool World::followsCells() const noexcept { return impl_->history.isFollowed(); }
bool World::hasUncommitted() const noexcept { return impl_->ground.hasChanged(); }

std::span<const CellChange> World::cellChanges() const noexcept { return impl_->history.cellChanges().all(); }
std::uint64_t World::versionBeforeCellChanges() const noexcept { return impl_->history.versionBeforeCellChanges(); }

// --- Saving

Expected<void> World::save(const ByteSink& sink) const noexcept {
  if (impl_->ground.hasChanged()) return refuse({.code = ErrorCode::uncommitted});
  if (const auto cell = firstUnloaded(detail::kWholeWorld)) return refuse({.code = ErrorCode::unloaded, .cell = *cell});
  detail::save(impl_->ground, impl_->outline, sink);
  return {};
}

tl::expected<World, SnapshotError> World::load(std::span<const std::byte> snapshot,
                                               PreserveRelation preserve) noexcept {
  World world(std::move(preserve));
  if (const auto error = detail::load(snapshot, world.impl_->ground, world.impl_->outline))
    return tl::unexpected(*error);
  return world;
}

// --- Reading the ground

std::vector<PlacedPolygon> World::polygons(Cell cell) const noexcept {
  std::vector<PlacedPolygon> out;
  polygons(cell, out);
  return out;
}
void World::polygons(Cell cell, std::vector<PlacedPolygon>& out) const noexcept {
  detail::polygonsOf(impl_->ground, cell, out);
}
bool World::isEmpty(Cell cell) const noexcept {
  const detail::CellAt at = impl_->ground.grid.find(cell);
  return !at || at.chunk->isUnloaded || impl_->ground.held(at).size() == 0;
}
void World::forEachPolygon(const PolygonVisitor& visit) const noexcept { forEachPolygon(detail::kWholeWorld, visit); }
void World::forEachPolygon(const CellRect& cells, const PolygonVisitor& visit) const noexcept {
  detail::forEachPolygon(impl_->ground, cells, visit);
}
std::optional<CellRect> World::bounds() const noexcept { return boundsOf(impl_->ground); }
Spot World::at(Point point) const noexcept { return spotAt(impl_->ground, point); }

Expected<PlacedPolygon> World::polygon(PolygonHandle handle) const noexcept { return polygonOf(impl_->ground, handle); }

Expected<Cell> World::cellOf(PolygonHandle handle) const noexcept {
  return polygon(handle).map([&](const PlacedPolygon&) { return impl_->ground.grid.cellOf(handle.cellRef); });
}

bool samePolygons(const World& a, const World& b) noexcept {
  return holdsPolygonsOf(a.impl_->ground, b.impl_->ground) && holdsPolygonsOf(b.impl_->ground, a.impl_->ground);
}

const PreserveRelation& World::preserveRelation() const noexcept { return impl_->ground.preserve; }

// --- Reading the outline

Expected<Segment> World::segment(SegmentId id) const noexcept {
  if (!impl_->outline.isShown(id)) return refuse(noSegment(*impl_, id));
  return segmentOf(impl_->ground.grid, impl_->outline, id.value);
}
Expected<void> World::segments(std::span<const SegmentId> ids, std::span<Segment> out) const noexcept {
  return write(*impl_, ids, out, [](const Segment& s) { return s; });
}
Expected<void> World::segments(std::span<const SegmentId> ids, Point origin,
                               std::span<FloatSegment> out) const noexcept {
  return writeReals(*impl_, ids, origin, out);
}
Expected<void> World::segments(std::span<const SegmentId> ids, Point origin,
                               std::span<DoubleSegment> out) const noexcept {
  return writeReals(*impl_, ids, origin, out);
}
std::vector<SegmentId> World::segments() const noexcept { return liveSegments(impl_->outline); }
std::vector<SegmentId> World::segments(const CellRect& cells) const noexcept {
  return segmentsIn(impl_->ground.grid, impl_->outline, cells);
}
std::vector<Loop> World::loops(Collinear collinear) const noexcept {
  return loopsOf(impl_->ground.grid, impl_->outline, collinear);
}
Expected<Nearest> World::nearest(Point point, double radius) const noexcept {
  return detail::nearest(impl_->ground.grid, impl_->outline, point, radius);
}
Expected<RayHit> World::rayCast(Point from, Point to) const noexcept {
  return detail::rayCast(impl_->ground.grid, impl_->outline, from, to);
}
std::uint64_t World::version() const noexcept { return impl_->outline.version(); }
std::uint32_t World::maxSegmentId() const noexcept { return impl_->outline.segments.maxId(); }

Stats World::stats() const noexcept {
  Stats stats;
  count(impl_->ground, stats);
  stats.segments = impl_->outline.liveCount(impl_->ground.grid);
  stats.bytes += sizeof(World) + sizeof(Impl) + impl_->outline.bytes() + impl_->history.bytes() + impl_->edit.bytes() +
                 detail::bytesOf(impl_->changesOfRollBack) + impl_->rounded.capacity() * sizeof(LocalPoint);
  return stats;
}

}  // namespace lgs
