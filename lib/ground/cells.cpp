#include "ground/cells.h"

#include "geometry/sort.h"
#include "storage/held_bytes.h"

#include <algorithm>

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
  const std::uint32_t local = handle.cellRef % kChunkCells;
  const Cell cell{border->ci * kChunkSize + static_cast<std::int32_t>(local % kChunkSize),
                  border->cj * kChunkSize + static_cast<std::int32_t>(local / kChunkSize)};
  return {.code = ErrorCode::unloaded, .cell = cell, .other = handle};
}

void Cells::read(const Held& held, std::vector<PlacedPolygon>& out) const {
  const bool hasList = isListed(held.word);
  const PolygonList listed = hasList ? list(held.word, *held.lists) : PolygonList(nullptr);
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

void Cells::setChanged(Chunk& chunk, std::uint32_t row, RowMask cells) {
  const RowMask bit = RowMask{1} << row;
  if (chunk.dirtyRows == 0) changed_.push_back(&chunk);
  chunk.dirty[row] = cells;
  chunk.dirtyRows = cells != 0 ? chunk.dirtyRows | bit : chunk.dirtyRows & ~bit;
  if (chunk.dirtyRows == 0) changed_.pop_back();
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

void Cells::dropList(CellWord word, RecordArena& lists) {
  const PolygonList old = list(word, lists);
  catalogue.release(old.content());
  lists.release(word & ~kListBit, PolygonList::sizeOf(old.size()));
}

/// The same word, with its list, if it has one, in another arena.
CellWord Cells::moveList(CellWord word, RecordArena& from, RecordArena& to) {
  if (!isListed(word)) return word;
  const std::uint32_t size = PolygonList::sizeOf(list(word, from).size());
  const RecordArena::Ref ref = to.allocate(size);
  std::copy_n(from.at(word & ~kListBit), size, to.at(ref));
  from.release(word & ~kListBit, size);
  return kListBit | ref;
}

void Cells::moveIn(CellAt at, CellWord word, Block block, RecordArena& lists) {
  at.word() = moveList(word, lists, lists_);
  if (hasSole(word)) at.chunk->setBlock(at.local, block);
  const Facts facts = catalogue.facts(contentId(at));
  at.chunk->facts[at.local] = facts;
  at.chunk->everFacts |= facts;
}

// --- Chunks that are not in memory

Cells::Turning Cells::turn(const Turning& to) {
  Chunk& chunk = grid.chunk(to.number);
  if (!chunk.isUnloaded) {
    grid.unload(chunk, borderOf(chunk, to));
    return {.number = to.number};
  }
  const Border border = grid.load(chunk);
  for (const Border::Run& run : border.runs) drop(run.word);
  return {to.number, border.checksum, border.lastSerial};
}

/// What the cells at the rim hold.
Border Cells::borderOf(const Chunk& chunk, const Turning& turning) {
  Border border;
  border.checksum = turning.checksum;
  border.lastSerial = turning.lastSerial;
  for (std::uint32_t k = 0; k < kRimCells; ++k) {
    const std::uint32_t local = rimCell(k);
    const CellWord word = holdsNothing(chunk.cells[local]) ? 0 : chunk.cells[local];
    const Block block = hasSole(word) ? chunk.block(local) : 0;
    if (!border.runs.empty() && !isListed(word)) {
      Border::Run& last = border.runs.back();
      if (last.word == word && last.block == block) {
        ++last.cells;
        continue;
      }
    }
    border.runs.push_back({1, chunk.facts[local], copyOf(word), block});
  }
  border.runs.shrink_to_fit();
  return border;
}

std::uint64_t Cells::bytes() const { return grid.bytes() + catalogue.bytes() + lists_.bytes() + heldBytes(changed_); }

}  // namespace lgs::detail
