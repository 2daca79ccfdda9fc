#include "ground/edit.h"

#include "geometry/sort.h"
#include "ground/refusal.h"

#include <algorithm>
#include <utility>

namespace lgs::detail {

// --- One cell

/// Begins with the polygons that the cell has. It may be without chunk.
void Edit::open(Cell cell) {
  cell_ = cell;
  at_ = ground_.grid.seek(cell);
  const Held held = ground_.held(at_);
  lastSerial_ = held.lastSerial();
  newOnes_ = 0;
  entries_.clear();
  const std::span<const PolygonId> polygons = ground_.content(at_).polygons;
  for (std::size_t slot = 0; slot < polygons.size(); ++slot) entries_.push_back({polygons[slot], held[slot]});
}

/// One polygon more, with the next serial.
void Edit::place(PolygonId polygon, Block block) {
  ++newOnes_;
  const auto after = std::ranges::upper_bound(entries_, polygon, {}, &Entry::polygon);
  entries_.insert(after, {polygon, {lastSerial_ + newOnes_, block}, true});
}

/// All of a shape.
void Edit::place(ShapeId shape, Block block) {
  for (const PolygonId polygon : ground_.catalogue.shape(shape).polygons) place(polygon, block);
}

/// Whether the cell can hold `entries_`. Overlaps between them are kept where the preserve relation says so.
Expected<void> Edit::check() {
  if (ground_.grid.isUnloaded(cell_)) return refuse({.code = ErrorCode::unloaded}, cell_);
  if (newOnes_ > kMaxSerial - lastSerial_ || (!at_ && ground_.grid.isFull()))
    return refuse({.code = ErrorCode::capacity}, cell_);
  content_ = kEmptyContent;
  if (entries_.empty()) return {};
  auto content = this->content();
  if (!content) return refuse(content.error().code == ErrorCode::overlap ? overlap() : content.error(), cell_);
  content_ = *content;
  return {};
}

Expected<ContentId> Edit::content() {
  ids_.clear();
  known_.clear();
  for (const Entry& e : entries_) {
    ids_.push_back(e.polygon);
    known_.push_back(!e.isNew);
  }
  const auto content = ground_.catalogue.internContent(ids_, known_, {});
  if (!content || !ground_.preserve) return content;
  kept_.clear();
  for (const auto& [a, b] : ground_.catalogue.content(*content).contacts)
    if (ground_.keeps(entries_[a].placed.block, entries_[b].placed.block)) kept_.emplace_back(a, b);
  if (kept_.empty()) return content;
  known_.assign(known_.size(), 1);
  return ground_.catalogue.internContent(ids_, known_, kept_);
}

/// Blames the first new polygon that overlaps one before it, and of those the oldest. So the refusal depends on what is
/// placed, and not on how it is stored.
Error Edit::overlap() {
  detail::sort(entries_, [](const Entry& a, const Entry& b) { return a.placed.serial < b.placed.serial; });
  const std::size_t old = entries_.size() - newOnes_;
  Error error{.code = ErrorCode::overlap};
  for (std::size_t k = old; k < entries_.size(); ++k) {
    for (std::size_t other = 0; other < k; ++other) {
      if (!ground_.catalogue.overlap(entries_[other].polygon, entries_[k].polygon)) continue;
      error.polygon = static_cast<std::int32_t>(k - old);
      if (other >= old) {
        error.polygon2 = static_cast<std::int32_t>(other - old);
      } else {
        error.other = {at_.ref(), entries_[other].placed.serial};
        error.otherBlock = entries_[other].placed.block;
      }
      return error;
    }
  }
  return error;
}

/// Sets the cell to `entries_`, if it can hold them. Returns the handle of the first new one.
Expected<PolygonHandle> Edit::close(std::span<PolygonHandle> handles) {
  if (const auto done = check(); !done) return refuse(done.error());
  at_ = ground_.obtain(cell_);
  placed_.clear();
  for (const Entry& e : entries_) placed_.push_back(e.placed);
  ground_.set(at_, content_, lastSerial_ + newOnes_, placed_);
  for (std::uint32_t k = 0; k < std::min<std::size_t>(newOnes_, handles.size()); ++k)
    handles[k] = {at_.ref(), lastSerial_ + 1 + k};
  return PolygonHandle{at_.ref(), lastSerial_ + 1};
}

// --- The doors

Expected<ShapeId> Edit::shape(std::span<const PolygonView> polygons) {
  ground_.catalogue.collect();
  std::vector<PolygonId> interned;
  for (std::size_t k = 0; k < polygons.size(); ++k) {
    const auto id = ground_.catalogue.internPolygon(polygons[k]);
    if (!id) return refuseAt(id.error(), &Error::polygon, k);
    interned.push_back(*id);
  }
  return ground_.catalogue.internShape(interned);
}

/// Whether there are such a cell and such a shape.
Expected<void> Edit::check(Cell cell, ShapeId shape) const {
  if (!inRange(cell)) return refuse({.code = ErrorCode::cellOutOfRange, .cell = cell});
  if (ground_.catalogue.shape(shape).polygons.empty()) return refuse({.code = ErrorCode::unknownShape, .cell = cell});
  if (ground_.grid.isUnloaded(cell)) return refuse({.code = ErrorCode::unloaded, .cell = cell});
  return {};
}

Expected<PolygonHandle> Edit::add(Cell cell, ShapeId shape, Block block, std::span<PolygonHandle> handles) {
  if (const auto done = check(cell, shape); !done) return refuse(done.error());
  const InternedShape& interned = ground_.catalogue.shape(shape);
  const CellAt at = ground_.grid.seek(cell);
  if (at && takesSole(at, interned)) {
    const PolygonHandle handle{at.ref(), at.word() + 1};
    ground_.setSole(at, interned, {handle.serial, block});
    if (!handles.empty()) handles[0] = handle;
    return handle;
  }
  open(cell);
  place(shape, block);
  return close(handles);
}

Expected<PolygonHandle> Edit::add(Cell cell, PolygonView polygon, Block block) {
  if (!inRange(cell)) return refuse({.code = ErrorCode::cellOutOfRange, .cell = cell});
  ground_.catalogue.collect();
  const auto id = ground_.catalogue.internPolygon(polygon);
  if (!id) return refuse(id.error(), cell);
  const ContentId sole = ground_.catalogue.sole(*id);
  const CellAt at = ground_.grid.findLast(cell);
  if (at && sole != kEmptyContent && at.word() < kLowMask) {  // the cell has nothing, and gets what others have
    const Placed placed{at.word() + 1, block};
    ground_.set(at, sole, placed.serial, {&placed, 1});
    return PolygonHandle{at.ref(), placed.serial};
  }
  open(cell);
  place(*id, block);
  return close();
}

Expected<void> Edit::remove(PolygonHandle polygon) {
  const auto found = ground_.find(polygon);
  if (!found) return refuse(found.error());
  const CellAt at = found->at;
  const Held held = ground_.held(at);
  if (held.size() == 1) {  // what is left needs no content
    ground_.set(at, kEmptyContent, held.lastSerial(), {});
    return {};
  }
  open(at.cell());
  entries_.erase(entries_.begin() + found->slot);
  return close().map([](PolygonHandle) {});
}

Expected<PolygonHandle> Edit::replace(Cell cell, ShapeId shape, Block block, std::span<PolygonHandle> handles) {
  if (const auto done = check(cell, shape); !done) return refuse(done.error());
  open(cell);
  entries_.clear();
  place(shape, block);
  return close(handles);
}

Expected<void> Edit::exchange(Cell cell, std::span<const PolygonHandle> removed, std::span<const NewPolygon> added,
                              std::span<PolygonHandle> handles) {
  if (!inRange(cell)) return refuse({.code = ErrorCode::cellOutOfRange, .cell = cell});
  if (ground_.grid.isUnloaded(cell)) return refuse({.code = ErrorCode::unloaded, .cell = cell});
  ground_.catalogue.collect();
  open(cell);
  for (std::size_t k = 0; k < removed.size(); ++k) {
    const auto found = std::ranges::find_if(entries_, [&](const Entry& e) {
      return removed[k] == PolygonHandle{at_.ref(), e.placed.serial};
    });
    if (found == entries_.end())
      return refuseAt({.code = ErrorCode::staleHandle, .cell = cell, .other = removed[k]}, &Error::index, k);
    entries_.erase(found);
  }
  if (added.size() > kMaxPolygonsPerCell - entries_.size()) return refuse({.code = ErrorCode::capacity}, cell);
  for (std::size_t k = 0; k < added.size(); ++k) {
    const auto id = ground_.catalogue.internPolygon(added[k].vertices);
    if (!id) return refuse(refuseAt(id.error(), &Error::polygon, k).value(), cell);
    place(*id, added[k].block);
  }
  if (removed.empty() && added.empty()) return {};
  return close(handles).map([](PolygonHandle) {});
}

Expected<void> Edit::setBlock(PolygonHandle polygon, Block block) {
  const auto found = ground_.find(polygon);
  if (!found) return refuse(found.error());
  open(found->at.cell());
  if (entries_[found->slot].placed.block == block) return {};
  entries_[found->slot].placed.block = block;  // another overlap may be preserved now
  return close().map([](PolygonHandle) {});
}

/// Whether each cell of a rectangle can take a shape; a refusal blames the first one, by rows. Cells that have a chunk and
/// polygons, or few serials left, are asked one by one. All others are alike, so one of them is asked for all.
Expected<void> Edit::checkFill(const CellRect& cells, ShapeId shape, Block block) {
  if (const auto done = checkCorners(cells); !done) return done;
  if (const auto done = check(cells.min, shape); !done) return done;
  std::uint64_t missing = ChunkRect(cells).count();
  ground_.grid.forEachChunk(cells, [&](const Chunk&) { --missing; });
  if (missing > kMaxChunks - ground_.grid.count()) return refuse({.code = ErrorCode::capacity, .cell = cells.min});

  entries_.clear();
  place(shape, block);
  if (const auto content = this->content(); !content) return refuse(content.error(), cells.min);
  std::optional<Error> refusal;
  if (const auto cell = ground_.firstUnloaded(cells)) refusal = {.code = ErrorCode::unloaded, .cell = *cell};
  ground_.grid.forEachCell(cells, [&](CellAt at, Cell cell) {
    if (at.word() < kLowMask || (refusal && std::pair(refusal->cell.j, refusal->cell.i) < std::pair(cell.j, cell.i)))
      return;
    open(cell);
    place(shape, block);
    if (const auto done = check(); !done) refusal = done.error();
  });
  if (refusal) return refuse(*refusal);
  return {};
}

Expected<std::uint64_t> Edit::fill(const CellRect& cells, ShapeId shape, Block block,
                                   std::span<PolygonHandle> handles) {
  if (lgs::isEmpty(cells)) return std::uint64_t{0};
  if (const auto done = checkFill(cells, shape, block); !done) return refuse(done.error());
  const InternedShape& interned = ground_.catalogue.shape(shape);
  ChunkRect(cells).forEach([this](std::int32_t ci, std::int32_t cj) {
    ground_.obtain({ci * kChunkSize, cj * kChunkSize});
  });
  const std::int64_t width = std::int64_t{cells.max.i} - cells.min.i + 1;
  const std::int64_t height = std::int64_t{cells.max.j} - cells.min.j + 1;
  ground_.grid.forEachCell(cells, [&](CellAt at, Cell cell) {
    PolygonHandle handle{at.ref(), at.word() + 1};
    if (takesSole(at, interned))
      ground_.setSole(at, interned, {handle.serial, block});
    else
      handle = *add(cell, shape, block, {});
    const std::int64_t k = (std::int64_t{cell.j} - cells.min.j) * width + cell.i - cells.min.i;
    if (std::cmp_less(k, handles.size())) handles[static_cast<std::size_t>(k)] = handle;
  });
  return static_cast<std::uint64_t>(width * height);
}

Expected<std::uint64_t> Edit::clear(const CellRect& cells) {
  if (lgs::isEmpty(cells)) return std::uint64_t{0};
  if (const auto done = checkCorners(cells); !done) return refuse(done.error());
  if (const auto cell = ground_.firstUnloaded(cells)) return refuse({.code = ErrorCode::unloaded, .cell = *cell});
  std::uint64_t count = 0;
  ground_.grid.forEachCell(cells, [&](CellAt at, Cell) {
    const Held held = ground_.held(at);
    count += held.size();
    if (held.size() != 0) ground_.set(at, kEmptyContent, held.lastSerial(), {});
  });
  return count;
}

}  // namespace lgs::detail
