// A commit. Phase 1 (exposure.h) renews the segments of every cell near an edit. Phase 2 (linking.h) links the segments
// at every vertex near an edit. Both visit the dirty cells chunk by chunk, in the order in which edits touched the
// chunks. Both can visit a cell or a vertex twice without harm, as what they write depends on the cells alone. While
// there are no segments, threads can do both (build.h).
#include "build.h"
#include "exposure.h"
#include "linking.h"
#include "world_impl.h"

namespace lgs {

const Changes& World::Impl::commit(const Executor& executor) {
  const bool isNoted = journal.isOpen() && journal.noteCommit(*this);
  // Ids that the last commit removed become available now, and not then. So no id is in two lists of one commit, and
  // the ends of removed segments can be read while links are compared.
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
  changes.before = version;
  if (!changes.removed.empty() || !changes.added.empty() || !changes.relinked.empty()) version = versions.next();
  changes.after = version;
  if (isNoted) journal.noteChanges(changes);
  catalogue.collect();
  return changes;
}

}  // namespace lgs
