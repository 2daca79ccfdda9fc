// A commit: phase 1 (exposure.h) decides for every cell near an edit which parts of its edges are exposed, phase 2
// (linking.h) links the segments at every vertex that this can have changed. Both visit the dirty cells chunk by chunk,
// in the order in which edits touched the chunks, and both can visit a cell or a vertex twice without harm: what they
// write depends on the cells alone. Where there is nothing yet, threads can do it (build.h).
#include "build.h"
#include "exposure.h"
#include "linking.h"
#include "world_impl.h"

#include <bit>

namespace lgs {

const Changes& World::Impl::commit(const Executor& executor) {
  // Ids removed by the last commit become available now and not then, so that none is in two lists of one commit and
  // the ends of removed segments can be read while links are compared.
  if (journal.isOpen()) journal.noteCommit(*this);
  for (const SegmentId id : changes.removed) segments.recycle(id.value);
  changes.removed.clear();
  changes.added.clear();
  changes.relinked.clear();

  if (executor && segments.isEmpty()) {
    detail::build(*this, executor);
  } else {
    detail::Exposure phase1(*this);
    for (const detail::Chunk* chunk : dirtyChunks) phase1.renewChunk(*chunk);
    detail::Linking phase2(*this, fan);
    for (const detail::Chunk* chunk : dirtyChunks) phase2.linkChunk(*chunk);
  }

  for (const SegmentId id : changes.relinked) segments[id.value].listed = 0;
  for (const SegmentId id : changes.removed) segments[id.value].cellRef = 0;
  forgetDirty();
  if (journal.isOpen()) journal.noteChanges(changes);
  catalogue.collect();
  return changes;
}

void World::Impl::forgetDirty() {
  for (detail::Chunk* chunk : dirtyChunks) {
    for (detail::RowMask rows = chunk->dirtyRows; rows != 0; rows &= rows - 1)
      chunk->dirty[static_cast<std::size_t>(std::countr_zero(rows))] = 0;
    chunk->dirtyRows = 0;
  }
  dirtyChunks.clear();
}

}  // namespace lgs
