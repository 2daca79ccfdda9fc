// Edits. Each is checked against the cells as they are, then changes them and marks them dirty. Segments are left to
// the commit.
#include "geometry/sort.h"
#include "refusal.h"
#include "world_impl.h"

#include <algorithm>

namespace lgs {

using detail::CellAt;
using detail::ContentId;
using detail::InternedContent;
using detail::PolygonId;
using detail::PolygonView;
using detail::refuse;
using detail::Slot;

/// Makes `entries_` the polygons of a cell. Their content is `after`.
void World::Impl::apply(CellAt at, ContentId after, std::uint32_t lastSerial) {
  if (journal.isOpen()) journal.noteCell(*this, at);
  const ContentId before = grid.content(at);
  if (after != detail::kEmptyContent) catalogue.use(after);
  if (before != detail::kEmptyContent) catalogue.release(before);
  placed_.clear();
  for (const Entry& e : entries_) placed_.push_back(e.placed);
  grid.setPolygons(at, after, lastSerial, placed_, grid.mustList(at, lastSerial, placed_));
  touch(at, after);
}

/// The content of a cell with the polygons in `entries_`, which are sorted by polygon. Overlaps between them are kept
/// where the preserve relation says so.
Expected<ContentId> World::Impl::internEntries() {
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
  const InternedContent& content = contentOf(at);
  for (std::size_t slot = 0; slot < content.polygons.size(); ++slot)
    entries_.push_back({content.polygons[slot], grid.placed(at)[static_cast<Slot>(slot)], true});
}

void World::Impl::addEntries(std::span<const PolygonId> added, Block block, std::uint32_t lastSerial) {
  for (const PolygonId polygon : added) {
    const Entry entry{polygon, {++lastSerial, block}, false};
    const auto place = std::upper_bound(entries_.begin(), entries_.end(), entry,
                                        [](const Entry& a, const Entry& b) { return a.polygon < b.polygon; });
    entries_.insert(place, entry);
  }
}

/// The content of a cell with these polygons added, which get the next serials in the order given. Leaves all its
/// polygons in `entries_`.
Expected<ContentId> World::Impl::withAdded(CellAt at, std::span<const PolygonId> added, Block block) {
  const std::uint32_t lastSerial = grid.lastSerial(at);
  if (added.size() > detail::kMaxSerial - lastSerial) return refuse({.code = ErrorCode::capacity});
  readEntries(at);
  addEntries(added, block, lastSerial);
  auto content = internEntries();
  if (!content && content.error().code == ErrorCode::overlap) return refuse(overlapWith(at, added));
  return content;
}

/// Blames the first of these polygons that overlaps one of the cell, and of those the oldest. So the refusal depends on
/// what is placed, and not on how it is stored.
Error World::Impl::overlapWith(CellAt at, std::span<const PolygonId> added) {
  readEntries(at);
  detail::sort(entries_, [](const Entry& a, const Entry& b) { return a.placed.serial < b.placed.serial; });
  Error error{.code = ErrorCode::overlap};
  for (std::size_t k = 0; k < added.size(); ++k) {
    for (const Entry& old : entries_) {
      if (!catalogue.meet(old.polygon, added[k])) continue;
      error.polygon = static_cast<std::int32_t>(k);
      error.other = {at.chunk->ref(at.local), old.placed.serial};
      error.otherBlock = old.placed.block;
      return error;
    }
  }
  return error;
}

Expected<ShapeId> World::Impl::shape(std::span<const PolygonView> polygons) {
  catalogue.collect();
  std::vector<PolygonId> interned;
  for (std::size_t k = 0; k < polygons.size(); ++k) {
    const auto id = catalogue.internPolygon(polygons[k]);
    if (!id) {
      Error error = id.error();
      error.polygon = static_cast<std::int32_t>(k);
      return refuse(error);
    }
    interned.push_back(*id);
  }
  return catalogue.internShape(interned);
}

Expected<PolygonHandle> World::Impl::add(Cell cell, ShapeId shape, Block block, std::span<PolygonHandle> handles) {
  if (!inRange(cell)) return refuse({.code = ErrorCode::cellOutOfRange, .cell = cell});
  const detail::InternedShape* interned = catalogue.shape(shape);
  if (!interned) return refuse({.code = ErrorCode::unknownShape, .cell = cell});
  const CellAt at = grid.obtain(cell);
  if (!at) return refuse({.code = ErrorCode::capacity, .cell = cell});
  if (interned->polygons.size() == 1) {
    if (const PolygonHandle handle = placeSole(at, interned->content, block)) {
      if (!handles.empty()) handles[0] = handle;
      return handle;
    }
  }
  return place(at, cell, interned->polygons, block, handles);
}

Expected<PolygonHandle> World::Impl::add(Cell cell, ShapeId shape, Block block) { return add(cell, shape, block, {}); }

Expected<PolygonHandle> World::Impl::add(Cell cell, PolygonView polygon, Block block) {
  if (!inRange(cell)) return refuse({.code = ErrorCode::cellOutOfRange, .cell = cell});
  catalogue.collect();
  const auto id = catalogue.internPolygon(polygon);
  if (!id) return refuse(id.error(), cell);
  const CellAt at = grid.obtain(cell);
  if (!at) return refuse({.code = ErrorCode::capacity, .cell = cell});
  if (grid.content(at) == detail::kEmptyContent) {
    const auto content = catalogue.internSole(*id);
    if (!content) return refuse(content.error(), cell);
    if (const PolygonHandle handle = placeSole(at, *content, block)) return handle;
  }
  return place(at, cell, {&*id, 1}, block, {});
}

/// The usual case: one polygon, which has this content, into an empty cell. Null, and nothing is done, in any other
/// case.
inline PolygonHandle World::Impl::placeSole(CellAt at, ContentId content, Block block) {
  if (journal.isOpen()) {
    if (!grid.takesSole(at)) return {};
    journal.noteCell(*this, at);
  }
  const std::uint32_t serial = grid.placeSole(at, content, block);
  if (serial == 0) return {};
  catalogue.use(content);
  touch(at, content);
  return {at.chunk->ref(at.local), serial};
}

Expected<PolygonHandle> World::Impl::place(CellAt at, Cell cell, std::span<const PolygonId> polygons, Block block,
                                           std::span<PolygonHandle> handles) {
  const std::uint32_t ref = at.chunk->ref(at.local);
  const auto after = withAdded(at, polygons, block);
  if (!after) return refuse(after.error(), cell);
  const std::uint32_t first = grid.lastSerial(at) + 1;
  const auto count = static_cast<std::uint32_t>(polygons.size());
  apply(at, *after, first + count - 1);
  for (std::uint32_t k = 0; k < std::min<std::size_t>(count, handles.size()); ++k) handles[k] = {ref, first + k};
  return PolygonHandle{ref, first};
}

std::optional<Slot> World::Impl::slotOf(PolygonHandle handle) const {
  const CellAt at = grid.find(handle.cellRef);
  if (!at) return std::nullopt;
  const std::size_t count = contentOf(at).polygons.size();
  for (Slot slot = 0; slot < count; ++slot)
    if (grid.placed(at)[slot].serial == handle.serial) return slot;
  return std::nullopt;
}

Expected<void> World::Impl::remove(PolygonHandle polygon) {
  const CellAt at = grid.find(polygon.cellRef);
  if (!at) return refuse({.code = ErrorCode::staleHandle, .other = polygon});
  if (journal.isOpen() && grid.holdsSole(at, polygon.serial)) journal.noteCell(*this, at);
  if (const ContentId content = grid.removeSole(at, polygon.serial); content != detail::kEmptyContent) {
    catalogue.release(content);
    touch(at, detail::kEmptyContent);
    return {};
  }
  const auto slot = slotOf(polygon);
  if (!slot) return refuse({.code = ErrorCode::staleHandle, .other = polygon});
  readEntries(at);
  entries_.erase(entries_.begin() + *slot);
  ContentId after = detail::kEmptyContent;
  if (!entries_.empty()) {
    const auto content = internEntries();
    if (!content) return refuse(content.error(), grid.cellOf(polygon.cellRef));
    after = *content;
  }
  apply(at, after, grid.lastSerial(at));
  return {};
}

Expected<PolygonHandle> World::Impl::replace(Cell cell, ShapeId shape, Block block, std::span<PolygonHandle> handles) {
  if (!inRange(cell)) return refuse({.code = ErrorCode::cellOutOfRange, .cell = cell});
  const detail::InternedShape* interned = catalogue.shape(shape);
  if (!interned) return refuse({.code = ErrorCode::unknownShape, .cell = cell});
  const CellAt at = grid.obtain(cell);
  if (!at) return refuse({.code = ErrorCode::capacity, .cell = cell});
  const std::uint32_t ref = at.chunk->ref(at.local), last = grid.lastSerial(at);
  const auto count = static_cast<std::uint32_t>(interned->polygons.size());
  if (count > detail::kMaxSerial - last) return refuse({.code = ErrorCode::capacity, .cell = cell});
  entries_.clear();
  addEntries(interned->polygons, block, last);
  const auto content = internEntries();
  if (!content) return refuse(content.error(), cell);
  apply(at, *content, last + count);
  for (std::uint32_t k = 0; k < std::min<std::size_t>(count, handles.size()); ++k) handles[k] = {ref, last + 1 + k};
  return PolygonHandle{ref, last + 1};
}

Expected<void> World::Impl::exchange(Cell cell, std::span<const PolygonHandle> removed,
                                     std::span<const NewPolygon> added, std::span<PolygonHandle> handles) {
  if (!inRange(cell)) return refuse({.code = ErrorCode::cellOutOfRange, .cell = cell});
  catalogue.collect();
  std::vector<PolygonId> polygons;
  for (std::size_t k = 0; k < added.size(); ++k) {
    const auto id = catalogue.internPolygon(added[k].vertices);
    if (!id) {
      Error error = id.error();
      error.polygon = static_cast<std::int32_t>(k);
      return refuse(error, cell);
    }
    polygons.push_back(*id);
  }
  const CellAt at = grid.obtain(cell);
  if (!at) return refuse({.code = ErrorCode::capacity, .cell = cell});
  const std::uint32_t ref = at.chunk->ref(at.local), last = grid.lastSerial(at);
  if (added.size() > detail::kMaxSerial - last) return refuse({.code = ErrorCode::capacity, .cell = cell});
  readEntries(at);
  for (std::size_t k = 0; k < removed.size(); ++k) {
    const auto found = std::ranges::find(entries_, removed[k].serial, [](const Entry& e) { return e.placed.serial; });
    if (removed[k].cellRef != ref || found == entries_.end())
      return refuse(
          {.code = ErrorCode::staleHandle, .cell = cell, .other = removed[k], .index = static_cast<std::int32_t>(k)});
    entries_.erase(found);
  }
  for (std::uint32_t k = 0; k < polygons.size(); ++k) addEntries({&polygons[k], 1}, added[k].block, last + k);
  ContentId after = detail::kEmptyContent;
  if (!entries_.empty()) {
    const auto content = internEntries();
    if (!content)
      return refuse(content.error().code == ErrorCode::overlap ? overlapAmongEntries(ref) : content.error(), cell);
    after = *content;
  }
  const auto count = static_cast<std::uint32_t>(added.size());
  apply(at, after, last + count);
  for (std::uint32_t k = 0; k < std::min<std::size_t>(count, handles.size()); ++k) handles[k] = {ref, last + 1 + k};
  return {};
}

/// Blames the first of the new polygons in `entries_` that overlaps one before it: the oldest of these.
Error World::Impl::overlapAmongEntries(std::uint32_t cellRef) {
  detail::sort(entries_, [](const Entry& a, const Entry& b) { return a.placed.serial < b.placed.serial; });
  Error error{.code = ErrorCode::overlap};
  const auto old =
      static_cast<std::size_t>(std::count_if(entries_.begin(), entries_.end(), [](const Entry& e) { return e.isOld; }));
  for (std::size_t k = old; k < entries_.size(); ++k) {
    for (std::size_t other = 0; other < k; ++other) {
      if (!catalogue.meet(entries_[other].polygon, entries_[k].polygon)) continue;
      error.polygon = static_cast<std::int32_t>(k - old);
      if (other < old) {
        error.other = {cellRef, entries_[other].placed.serial};
        error.otherBlock = entries_[other].placed.block;
      } else {
        error.polygon2 = static_cast<std::int32_t>(other - old);
      }
      return error;
    }
  }
  return error;
}

Expected<void> World::Impl::setBlock(PolygonHandle polygon, Block block) {
  const auto slot = slotOf(polygon);
  if (!slot) return refuse({.code = ErrorCode::staleHandle, .other = polygon});
  const CellAt at = grid.find(polygon.cellRef);
  readEntries(at);
  if (entries_[*slot].placed.block == block) return {};
  entries_[*slot].placed.block = block;
  const auto content = internEntries();  // with another block another overlap may be preserved
  if (!content) return refuse(content.error(), grid.cellOf(polygon.cellRef));
  apply(at, *content, grid.lastSerial(at));
  return {};
}

Expected<std::uint64_t> World::Impl::fill(const CellRect& cells, ShapeId shape, Block block) {
  if (lgs::isEmpty(cells)) return std::uint64_t{0};
  for (const Cell corner : {cells.min, cells.max})
    if (!inRange(corner)) return refuse({.code = ErrorCode::cellOutOfRange, .cell = corner});
  const detail::InternedShape* interned = catalogue.shape(shape);
  if (!interned) return refuse({.code = ErrorCode::unknownShape, .cell = cells.min});
  const detail::ChunkRect reach(cells);
  if (reach.count() > kMaxChunks - grid.chunks().size()) {  // it may be too many: all chunks are looked at
    const auto isThere = [&](const auto& chunk) { return reach.contains(*chunk); };
    const auto there = std::count_if(grid.chunks().begin(), grid.chunks().end(), isThere);
    if (reach.count() - static_cast<std::uint64_t>(there) > kMaxChunks - grid.chunks().size())
      return refuse({.code = ErrorCode::capacity, .cell = cells.min});
  }

  // First every cell is asked, so that nothing is changed if one refuses. What is worked out stays interned. All empty
  // cells are alike, so one of them is asked for all.
  entries_.clear();
  addEntries(interned->polygons, block, 0);
  if (const auto content = internEntries(); !content) return refuse(content.error(), cells.min);
  std::optional<Error> refusal;
  grid.forEachCell(cells, [&](CellAt at, Cell cell) {
    if (grid.content(at) == detail::kEmptyContent && grid.lastSerial(at) <= detail::kMaxSerial - kMaxPolygonsPerCell)
      return;
    if (refusal && std::pair(refusal->cell.j, refusal->cell.i) < std::pair(cell.j, cell.i)) return;
    const auto after = withAdded(at, interned->polygons, block);
    if (!after) refusal = refuse(after.error(), cell).value();
  });
  if (refusal) return refuse(*refusal);

  std::uint64_t count = 0;
  for (std::int32_t cj = reach.j0; cj <= reach.j1; ++cj)
    for (std::int32_t ci = reach.i0; ci <= reach.i1; ++ci)
      grid.obtain({ci * detail::kChunkSize, cj * detail::kChunkSize});
  const bool single = interned->polygons.size() == 1;
  const detail::Facts facts = catalogue.facts(interned->content);
  grid.forEachRow(cells, [&](CellAt at, Cell cell, std::uint32_t inRow) {
    count += inRow;
    if (single && !journal.isOpen() && detail::Grid::placeRow(at, inRow, interned->content, block)) {
      touch(at, interned->content);
      at.chunk->dirty[at.row()] |= ~detail::RowMask{0} >> (detail::kChunkSize - inRow) << at.local % detail::kChunkSize;
      std::fill_n(at.chunk->facts.data() + at.local, inRow, facts);
      return;
    }
    for (; inRow != 0; --inRow, ++at.local, ++cell.i)
      if (!single || !placeSole(at, interned->content, block))
        static_cast<void>(place(at, cell, interned->polygons, block, {}));
  });
  return count;
}

Expected<std::uint64_t> World::Impl::clear(const CellRect& cells) {
  if (lgs::isEmpty(cells)) return std::uint64_t{0};
  for (const Cell corner : {cells.min, cells.max})
    if (!inRange(corner)) return refuse({.code = ErrorCode::cellOutOfRange, .cell = corner});
  std::uint64_t count = 0;
  grid.forEachCell(cells, [&](CellAt at, Cell) {
    const std::size_t polygons = contentOf(at).polygons.size();
    if (polygons == 0) return;
    entries_.clear();
    apply(at, detail::kEmptyContent, grid.lastSerial(at));
    count += polygons;
  });
  return count;
}

}  // namespace lgs
