// Calls that take many at once. Edits are all made or none: they are a group, which the journal undoes.
#include "refusal.h"
#include "world_impl.h"

#include <algorithm>

namespace lgs {

using detail::CellAt;
using detail::refuse;

namespace {

tl::unexpected<Error> refuseAt(Error error, std::size_t index) {
  error.index = static_cast<std::int32_t>(index);
  return tl::unexpected(error);
}

/// The entry that placed a polygon, or -1 if it was there before them. The last serials of a cell are of the last
/// entries that placed something in it.
std::int32_t entryThatPlaced(const World::Impl& world, std::span<const Placement> placed, PolygonHandle polygon) {
  const detail::CellAt at = world.grid.find(polygon.cellRef);
  const Cell cell = world.grid.cellOf(polygon.cellRef);
  std::size_t before = world.grid.lastSerial(at);
  for (std::size_t k = placed.size(); k-- != 0;) {
    if (placed[k].cell != cell) continue;
    before -= world.catalogue.shape(placed[k].shape)->polygons.size();
    if (polygon.serial > before) return static_cast<std::int32_t>(k);
  }
  return -1;
}

/// Nobody keeps the handle of a polygon that this call placed and takes back: the entry that placed it says which.
void nameEntry(const World::Impl& world, std::span<const Placement> placed, Error& error) {
  if (!error.other) return;
  error.index2 = entryThatPlaced(world, placed, error.other);
  if (error.index2 >= 0) error.other = {};
}

/// Writes what `convert` makes of each segment.
template <class Out, class Convert>
Expected<void> write(const World::Impl& world, std::span<const SegmentId> ids, std::span<Out> out, Convert&& convert) {
  const std::size_t count = std::min(ids.size(), out.size());
  if (count > kMaxEntries) return refuse({.code = ErrorCode::capacity});
  for (std::size_t k = 0; k < count; ++k) {
    if (!world.segments.isLive(ids[k].value))
      return refuseAt({.code = ErrorCode::unknownSegment, .segment = ids[k]}, k);
    out[k] = convert(world.segment(ids[k].value));
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

}  // namespace

/// The usual case of addMany(): each entry puts one polygon into a cell that is empty and has no record. First all
/// cells get their states, and then what can not fail. Whether it was done; if not, all is as it was.
bool World::Impl::addManyQuickly(std::span<const Placement> placements, std::span<PolygonHandle> handles) {
#ifdef LGS_SMALL_CODE
  return false;  // the general way does the same
#endif
  if (journal.isOpen()) return false;
  const std::size_t chunks = grid.chunks().size();
  const auto stake = [&](const Placement& p) {
    const detail::SoleContent& sole = catalogue.soleContent(p.shape);
    CellAt at = grid.findQuickly(p.cell);
    if (!at && inRange(p.cell)) at = grid.obtain(p.cell);
    return at && sole.id != detail::kEmptyContent && detail::Grid::stake(at, sole.id);
  };
  std::size_t staked = 0;
  while (staked < placements.size() && stake(placements[staked])) ++staked;
  if (staked < placements.size()) {
    while (staked-- > 0) detail::Grid::takeBackStake(grid.find(placements[staked].cell));
    grid.forgetChunks(chunks);
    return false;
  }
  for (std::size_t k = 0; k < placements.size(); ++k) {
    const auto& [cell, shape, block] = placements[k];
    const CellAt at = grid.obtain(cell);
    const std::uint32_t serial = detail::Grid::setStakedBlock(at, block);
    if (at.chunk->dirtyRows == 0) dirtyChunks.push_back(at.chunk);
    mark(at, static_cast<detail::Facts>(catalogue.soleContent(shape).facts));
    if (k < handles.size()) handles[k] = {at.chunk->ref(at.local), serial};
  }
  return true;
}

Expected<void> World::addMany(std::span<const Placement> placements, std::span<PolygonHandle> handles) {
  if (placements.size() > kMaxEntries) return refuse({.code = ErrorCode::capacity});
  if (impl_->addManyQuickly(placements, handles)) return {};
  Transaction group = edit();
  for (std::size_t k = 0; k < placements.size(); ++k) {
    const auto& [cell, shape, block] = placements[k];
    auto handle = impl_->add(cell, shape, block);
    if (!handle) {
      nameEntry(*impl_, placements.first(k), handle.error());
      std::fill(handles.begin(), handles.end(), PolygonHandle{});
      return refuseAt(handle.error(), k);
    }
    if (k < handles.size()) handles[k] = *handle;
  }
  group.keep();
  return {};
}

Expected<void> World::removeMany(std::span<const PolygonHandle> polygons) {
  if (polygons.size() > kMaxEntries) return refuse({.code = ErrorCode::capacity});
  Transaction group = edit();
  for (std::size_t k = 0; k < polygons.size(); ++k) {
    auto done = impl_->remove(polygons[k]);
    if (done) continue;
    const auto twin = std::ranges::find(polygons.first(k), polygons[k]);
    if (twin != polygons.first(k).end()) done.error().index2 = static_cast<std::int32_t>(twin - polygons.begin());
    return refuseAt(done.error(), k);
  }
  group.keep();
  return {};
}

Expected<void> World::segments(std::span<const SegmentId> ids, std::span<Segment> out) const {
  return write(*impl_, ids, out, [](const Segment& s) { return s; });
}
Expected<void> World::segments(std::span<const SegmentId> ids, Point origin, std::span<FloatSegment> out) const {
  return writeReals(*impl_, ids, origin, out);
}
Expected<void> World::segments(std::span<const SegmentId> ids, Point origin, std::span<DoubleSegment> out) const {
  return writeReals(*impl_, ids, origin, out);
}

}  // namespace lgs
