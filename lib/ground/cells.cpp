#include "ground/cells.h"

#include "geometry/sort.h"
#include "ground/refusal.h"
#include "storage/vectors.h"

#include <algorithm>
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

Expected<Cells::Found> Cells::find(PolygonHandle handle) const {
  if (grid.border(handle.cellRef / kChunkCells))
    return refuse({.code = ErrorCode::unloaded, .cell = grid.cellOfAny(handle.cellRef), .other = handle});
  const CellAt at = grid.find(handle.cellRef);
  const Held held = this->held(at);
  for (Slot slot = 0; slot < held.size(); ++slot)
    if (held[slot].serial == handle.serial) return Found{at, slot};
  return refuse({.code = ErrorCode::staleHandle, .other = handle});
}

void Cells::read(std::uint32_t ref, const Held& held, std::vector<PlacedPolygon>& out) const {
  const std::span<const PolygonId> polygons = catalogue.content(held.content()).polygons;
  const std::size_t first = out.size();
  for (std::size_t slot = 0; slot < polygons.size(); ++slot)
    out.push_back({{ref, held[slot].serial}, held[slot].block, catalogue.vertices(polygons[slot])});
  detail::sort(std::span(out).subspan(first), [](const auto& a, const auto& b) { return a.handle < b.handle; });
}

// --- What changed

std::vector<Cells::ChangedCells> Cells::changedCells() const {
  std::vector<ChangedCells> changed;
  for (const Chunk* chunk : changed_) changed.push_back({chunk->index, chunk->dirtyRows, chunk->dirty});
  return changed;
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

void Cells::setChangedCells(const std::vector<ChangedCells>& changed) {
  assert(changed_.empty());
  for (const ChangedCells& of : changed) {
    Chunk& chunk = grid.wake(of.chunk);
    changed_.push_back(&chunk);
    chunk.dirtyRows = of.rows;
    chunk.dirty = of.cells;
  }
}

// --- Words

CellWord Cells::makeList(ContentId content, std::uint32_t lastSerial, std::span<const Placed> polygons) {
  const RecordArena::Ref ref = lists_.allocate(static_cast<std::uint32_t>(2 + 2 * polygons.size()));
  std::uint32_t* out = lists_.at(ref);
  *out++ = wordOf(content, static_cast<std::uint32_t>(polygons.size()));
  *out++ = lastSerial;
  for (const Placed& placed : polygons) {
    *out++ = placed.serial;
    *out++ = placed.block;
  }
  return kListBit | ref;
}

void Cells::releaseList(CellWord word) {
  lists_.release(word & ~kListBit, static_cast<std::uint32_t>(held(word).list().size()));
}

void Cells::lay(CellAt at, CellWord word, Block block) {
  at.word() = word;
  if (hasSole(word)) at.chunk->setBlock(at.local, block);
  const Facts facts = catalogue.facts(held(word).content());
  at.chunk->facts[at.local] = facts;
  at.chunk->everFacts |= facts;
}

CellWord Cells::moveOut(CellWord word, Journal& journal) {
  if (!isListed(word)) return word;
  const CellWord moved = kListBit | journal.keep(held(word).list());
  releaseList(word);
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

std::uint64_t Cells::bytes() const { return grid.bytes() + catalogue.bytes() + lists_.bytes() + heldBytes(changed_); }

}  // namespace lgs::detail
