// Edits: each is checked against the cells as they are, then changes them and marks them dirty. Nothing here looks at
// segments.
#include "world_impl.h"

#include <algorithm>

namespace lgs {

using detail::CellAt;
using detail::ContentId;
using detail::InternedContent;
using detail::Placed;
using detail::PolygonId;
using detail::PolygonView;
using detail::Slot;

namespace {

tl::unexpected<Error> refuse(ErrorCode code) {
  Error error;
  error.code = code;
  return tl::unexpected(error);
}

tl::unexpected<Error> refuse(ErrorCode code, Cell cell) {
  auto refusal = refuse(code);
  refusal.value().cell = cell;
  refusal.value().hasCell = true;
  return refusal;
}

tl::unexpected<Error> refuse(Error error, Cell cell) {
  error.cell = cell;
  error.hasCell = true;
  return tl::unexpected(error);
}

tl::unexpected<Error> refuseHandle(PolygonHandle handle) {
  auto refusal = refuse(ErrorCode::staleHandle);
  refusal.value().other = handle;
  return refusal;
}

}  // namespace

/// A cell's polygons after an edit, by slot.
struct World::Impl::Contents {
  ContentId content = detail::kEmptyContent;
  std::vector<Placed> polygons;
  std::uint32_t lastSerial = 0;
};

void World::Impl::apply(CellAt at, const Contents& after) {
  const ContentId before = grid.content(at);
  if (after.content != detail::kEmptyContent) catalogue.use(after.content);
  if (before != detail::kEmptyContent) catalogue.release(before);
  grid.setPolygons(at, after.content, after.lastSerial, after.polygons);
  touch(at, after.content);
}

void World::Impl::touch(CellAt at, ContentId content) {
  detail::Chunk& chunk = *at.chunk;
  if (chunk.dirtyRows == 0) dirtyChunks.push_back(&chunk);
  chunk.dirtyRows |= detail::RowMask{1} << at.row();
  chunk.dirty[at.row()] |= at.bit();
  const InternedContent& now = catalogue.content(content);
  detail::RowMask& covered = chunk.covered[at.row()];
  covered = now.coversCell ? covered | at.bit() : covered & ~at.bit();
  chunk.hadRimPoints |= now.hasRimPoints;
}

/// Interns `entries_`, which are sorted by polygon, as one cell's content; overlaps between them that the relation keeps
/// are kept.
Expected<ContentId> World::Impl::contentOf() {
  ids_.clear();
  known_.clear();
  for (const Entry& e : entries_) {
    ids_.push_back(e.polygon);
    known_.push_back(e.isOld);
  }
  const auto content = catalogue.internContent(ids_, known_, {});
  if (!content || !preserve) return content;
  kept_.clear();
  for (const auto& [a, b] : catalogue.content(*content).contacts)
    if (keeps(entries_[a].placed.block, entries_[b].placed.block)) kept_.emplace_back(a, b);
  if (kept_.empty()) return content;
  known_.assign(known_.size(), 1);
  return catalogue.internContent(ids_, known_, kept_);
}

void World::Impl::readEntries(CellAt at) {
  entries_.clear();
  const InternedContent& content = catalogue.content(grid.content(at));
  for (std::size_t slot = 0; slot < content.polygons.size(); ++slot)
    entries_.push_back({content.polygons[slot], grid.placed(at, static_cast<Slot>(slot)), true, 0});
}

/// What the cell holds once these polygons are added too. The new ones get the next serials, in the order given.
Expected<World::Impl::Contents> World::Impl::withAdded(CellAt at, std::span<const PolygonId> added, Block block) {
  const std::uint32_t lastSerial = grid.lastSerial(at);
  if (added.size() > detail::kMaxSerial - lastSerial) return refuse(ErrorCode::capacity);
  readEntries(at);
  for (std::size_t k = 0; k < added.size(); ++k) {
    const auto number = static_cast<std::uint32_t>(k);
    entries_.push_back({added[k], {lastSerial + 1 + number, block}, false, static_cast<std::int32_t>(k)});
  }
  std::stable_sort(entries_.begin(), entries_.end(),
                   [](const Entry& a, const Entry& b) { return a.polygon < b.polygon; });
  const auto content = contentOf();
  if (!content) {
    Error error = content.error();
    if (error.code == ErrorCode::overlap) {
      Entry a = entries_[static_cast<std::size_t>(error.polygon)],
            b = entries_[static_cast<std::size_t>(error.polygon2)];
      if (a.isOld) std::swap(a, b);
      error.polygon = a.index;
      error.polygon2 = b.isOld ? -1 : b.index;
      if (b.isOld) error.other = {at.chunk->ref(at.local), b.placed.serial};
    }
    return tl::unexpected(error);
  }
  Contents after{*content, {}, lastSerial + static_cast<std::uint32_t>(added.size())};
  for (const Entry& e : entries_) after.polygons.push_back(e.placed);
  return after;
}

Expected<ShapeId> World::Impl::shape(std::span<const PolygonView> polygons) {
  catalogue.collect();
  std::vector<PolygonId> interned;
  for (std::size_t k = 0; k < polygons.size(); ++k) {
    const auto id = catalogue.internPolygon(polygons[k]);
    if (!id) {
      Error error = id.error();
      error.polygon = static_cast<std::int32_t>(k);
      return tl::unexpected(error);
    }
    interned.push_back(*id);
  }
  return catalogue.internShape(interned);
}

Expected<PolygonHandle> World::Impl::add(Cell cell, ShapeId shape, Block block, std::span<PolygonHandle> handles) {
  if (!inRange(cell)) return refuse(ErrorCode::cellOutOfRange, cell);
  const detail::InternedShape* interned = catalogue.shape(shape);
  if (!interned) return refuse(ErrorCode::unknownShape, cell);
  const CellAt at = grid.obtain(cell);
  if (!at) return refuse(ErrorCode::capacity, cell);
  return place(at, cell, interned->polygons, interned->content, block, handles);
}

Expected<PolygonHandle> World::Impl::add(Cell cell, PolygonView polygon, Block block) {
  if (!inRange(cell)) return refuse(ErrorCode::cellOutOfRange, cell);
  catalogue.collect();
  const auto id = catalogue.internPolygon(polygon);
  if (!id) return refuse(id.error(), cell);
  const auto sole = catalogue.internSole(*id);
  if (!sole) return refuse(sole.error(), cell);
  const CellAt at = grid.obtain(cell);
  if (!at) return refuse(ErrorCode::capacity, cell);
  return place(at, cell, {&*id, 1}, *sole, block, {});
}

/// `content` is that of a cell with just these polygons and nothing preserved.
Expected<PolygonHandle> World::Impl::place(CellAt at, Cell cell, std::span<const PolygonId> polygons, ContentId content,
                                           Block block, std::span<PolygonHandle> handles) {
  const std::uint32_t ref = at.chunk->ref(at.local);
  if (polygons.size() == 1) {
    if (const std::uint32_t serial = grid.placeSole(at, content, block)) {
      catalogue.use(content);
      touch(at, content);
      if (!handles.empty()) handles[0] = {ref, serial};
      return PolygonHandle{ref, serial};
    }
  }
  const auto after = withAdded(at, polygons, block);
  if (!after) return refuse(after.error(), cell);
  apply(at, *after);
  const auto first = static_cast<std::uint32_t>(after->lastSerial - polygons.size() + 1);
  for (std::size_t k = 0; k < handles.size(); ++k) handles[k] = {ref, first + static_cast<std::uint32_t>(k)};
  return PolygonHandle{ref, first};
}

std::optional<Slot> World::Impl::slotOf(PolygonHandle handle) const {
  const CellAt at = grid.find(handle.cellRef);
  if (!at) return std::nullopt;
  const std::size_t count = catalogue.content(grid.content(at)).polygons.size();
  for (Slot slot = 0; slot < count; ++slot)
    if (grid.placed(at, slot).serial == handle.serial) return slot;
  return std::nullopt;
}

Expected<void> World::Impl::remove(PolygonHandle polygon) {
  const auto slot = slotOf(polygon);
  if (!slot) return refuseHandle(polygon);
  const CellAt at = grid.find(polygon.cellRef);
  Contents after{detail::kEmptyContent, {}, grid.lastSerial(at)};
  if (catalogue.content(grid.content(at)).polygons.size() > 1) {
    readEntries(at);
    entries_.erase(entries_.begin() + *slot);
    const auto content = contentOf();
    if (!content) return refuse(content.error(), grid.cellOf(polygon.cellRef));
    after.content = *content;
    for (const Entry& e : entries_) after.polygons.push_back(e.placed);
  }
  apply(at, after);
  return {};
}

Expected<std::uint64_t> World::Impl::fill(const CellRect& cells, ShapeId shape, Block block) {
  if (isEmpty(cells)) return 0;
  for (const Cell corner : {cells.min, cells.max})
    if (!inRange(corner)) return refuse(ErrorCode::cellOutOfRange, corner);
  const detail::InternedShape* interned = catalogue.shape(shape);
  if (!interned) return refuse(ErrorCode::unknownShape, cells.min);
  const detail::ChunkRect reach(cells);
  if (reach.count() > kMaxChunks - grid.chunks().size()) return refuse(ErrorCode::capacity, cells.min);

  // First every cell is asked, so that a refusal finds nothing changed; what is worked out stays interned.
  for (std::int32_t j = cells.min.j; j <= cells.max.j; ++j) {
    for (std::int32_t i = cells.min.i; i <= cells.max.i; ++i) {
      const CellAt at = grid.find({i, j});
      if (!at) {
        i |= detail::kChunkSize - 1;  // on to the next chunk
        continue;
      }
      if (grid.content(at) == detail::kEmptyContent && grid.lastSerial(at) < detail::kMaxSerial - kMaxPolygonsPerCell)
        continue;
      const auto after = withAdded(at, interned->polygons, block);
      if (!after) return refuse(after.error(), {i, j});
    }
  }

  std::uint64_t count = 0;
  for (std::int32_t cj = reach.j0; cj <= reach.j1; ++cj)
    for (std::int32_t ci = reach.i0; ci <= reach.i1; ++ci)
      grid.obtain({ci * detail::kChunkSize, cj * detail::kChunkSize});
  grid.forEachCell(cells, [&](CellAt at, Cell cell) {
    static_cast<void>(place(at, cell, interned->polygons, interned->content, block, {}));
    ++count;
  });
  return count;
}

Expected<std::uint64_t> World::Impl::clear(const CellRect& cells) {
  if (isEmpty(cells)) return 0;
  for (const Cell corner : {cells.min, cells.max})
    if (!inRange(corner)) return refuse(ErrorCode::cellOutOfRange, corner);
  std::uint64_t count = 0;
  grid.forEachCell(cells, [&](CellAt at, Cell) {
    const std::size_t polygons = catalogue.content(grid.content(at)).polygons.size();
    if (polygons == 0) return;
    apply(at, {detail::kEmptyContent, {}, grid.lastSerial(at)});
    count += polygons;
  });
  return count;
}

}  // namespace lgs
