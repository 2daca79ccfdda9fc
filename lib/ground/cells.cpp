#include "ground/cells.h"

#include "geometry/sort.h"
#include "storage/vectors.h"

#include <algorithm>
#include <bit>
#include <cassert>

namespace lgs::detail {

Cells::Cells(const Cells& other)
    : preserve(other.preserve),
      catalogue(other.catalogue),
      grid(other.grid),
      lists_(other.lists_),
      changed_(other.changed_) {
  for (Chunk*& chunk : changed_) chunk = &grid.chunk(chunk->index);
}

// --- Reading

std::optional<Slot> Cells::slotOf(PolygonHandle handle) const {
  const CellAt at = grid.find(handle.cellRef);
  if (at && at.chunk->isUnloaded) return std::nullopt;
  const std::size_t count = content(at).polygons.size();
  for (Slot slot = 0; slot < count; ++slot)
    if (placed(at)[slot].serial == handle.serial) return slot;
  return std::nullopt;
}

Error Cells::noPolygon(PolygonHandle handle) const {
  const Border* border = grid.border(handle.cellRef / kChunkCells);
  if (!border) return {.code = ErrorCode::staleHandle, .other = handle};
  return {.code = ErrorCode::unloaded, .cell = grid.cellOfAny(handle.cellRef), .other = handle};
}

void Cells::read(const Held& held, std::vector<PlacedPolygon>& out) const {
  const bool hasList = held.list != nullptr;
  const PolygonList listed(held.list);
  const ContentId content = hasList ? listed.content() : held.word >> kLowBits;
  const std::span<const PolygonId> polygons = catalogue.content(content).polygons;
  const std::size_t first = out.size();
  for (std::size_t slot = 0; slot < polygons.size(); ++slot) {
    const Placed placed = hasList ? listed[static_cast<Slot>(slot)] : Placed{held.word & kLowMask, held.block};
    out.push_back({{held.ref, placed.serial}, placed.block, catalogue.vertices(polygons[slot])});
  }
  detail::sort(std::span(out).subspan(first), [](const auto& a, const auto& b) { return a.handle < b.handle; });
}

// --- What changed

Cells::ChangedCells Cells::changedCells() const {
  ChangedCells cells;
  for (const Chunk* chunk : changed_) {
    cells.insert(cells.end(), {chunk->index, chunk->dirtyRows});
    for (const RowMask row : chunk->dirty)
      if (row != 0) cells.push_back(row);
  }
  return cells;
}

void Cells::setClean(CellAt at) {
  Chunk& chunk = *at.chunk;
  RowMask& row = chunk.dirty[at.row()];
  assert((row & at.bit()) != 0);
  row &= ~at.bit();
  if (row == 0) chunk.dirtyRows &= ~(RowMask{1} << at.row());
  if (chunk.dirtyRows != 0) return;
  assert(changed_.back() == &chunk);
  changed_.pop_back();
}

void Cells::setChangedCells(const ChangedCells& cells) {
  assert(changed_.empty());
  for (std::size_t k = 0; k < cells.size();) {
    Chunk& chunk = grid.wake(cells[k++]);
    changed_.push_back(&chunk);
    chunk.dirtyRows = cells[k++];
    for (RowMask rows = chunk.dirtyRows; rows != 0; rows &= rows - 1)
      chunk.dirty[static_cast<std::size_t>(std::countr_zero(rows))] = cells[k++];
  }
}

// --- Words

CellWord Cells::makeList(ContentId content, std::uint32_t lastSerial, std::span<const Placed> polygons) {
  const RecordArena::Ref ref = lists_.allocate(PolygonList::sizeOf(polygons.size()));
  std::uint32_t* out = lists_.at(ref);
  *out++ = wordOf(content, static_cast<std::uint32_t>(polygons.size()));
  *out++ = lastSerial;
  for (const Placed& placed : polygons) {
    *out++ = placed.serial;
    *out++ = placed.block;
  }
  return kListBit | ref;
}

CellWord Cells::copyOf(CellWord word) {
  if (word <= kLowMask) return word;
  if (!isListed(word)) {
    catalogue.use(word >> kLowBits);
    return word;
  }
  const PolygonList old = list(word);
  catalogue.use(old.content());
  const std::uint32_t size = PolygonList::sizeOf(old.size());
  const RecordArena::Ref ref = lists_.allocate(size);
  std::copy_n(lists_.at(word & ~kListBit), size, lists_.at(ref));
  return kListBit | ref;
}

void Cells::dropList(CellWord word) {
  const PolygonList old = list(word);
  catalogue.release(old.content());
  lists_.release(word & ~kListBit, PolygonList::sizeOf(old.size()));
}

CellWord Cells::emptyWord(std::uint32_t lastSerial) {
  return fitsWord(lastSerial, {}) ? wordOf(kEmptyContent, lastSerial) : makeList(kEmptyContent, lastSerial, {});
}

void Cells::lay(CellAt at, CellWord word, Block block) {
  at.word() = word;
  if (hasSole(word)) at.chunk->setBlock(at.local, block);
  const Facts facts = catalogue.facts(contentOf(word));
  at.chunk->facts[at.local] = facts;
  at.chunk->everFacts |= facts;
}

CellWord Cells::moveOut(CellWord word, Journal& journal) {
  if (!isListed(word)) return word;
  const RecordArena::Ref ref = word & ~kListBit;
  const std::uint32_t size = PolygonList::sizeOf(list(word).size());
  const CellWord moved = kListBit | journal.keep({lists_.at(ref), size});
  lists_.release(ref, size);
  return moved;
}

CellWord Cells::moveIn(CellWord moved, Journal& journal) {
  if (!isListed(moved)) return moved;
  const std::span<const std::uint32_t> words = journal.kept(moved & ~kListBit);
  const RecordArena::Ref ref = lists_.allocate(static_cast<std::uint32_t>(words.size()));
  std::ranges::copy(words, lists_.at(ref));
  journal.release(moved & ~kListBit);
  return kListBit | ref;
}

void Cells::dropMoved(CellWord moved, Journal& journal) {
  if (!isListed(moved)) return drop(moved);
  catalogue.release(PolygonList(journal.kept(moved & ~kListBit).data()).content());
  journal.release(moved & ~kListBit);
}

std::uint64_t Cells::bytes() const { return grid.bytes() + catalogue.bytes() + lists_.bytes() + heldBytes(changed_); }

}  // namespace lgs::detail
