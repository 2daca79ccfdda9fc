// The algorithm. Phase 1 renews the segments of every cell near a change (exposure.cpp). Phase 2 links the segments at
// every vertex near a change (linking.cpp). Both visit the changed cells chunk by chunk, in the order of their first
// change. A cell or a vertex may be visited twice: what is written depends on the ground alone, so that does no harm.
// The vertices in and on the rim of changed cells are enough for phase 2: where phase 1 renews the side of a cell that
// did not change, the ends of what comes and goes lie on that rim. While there are no segments, threads can do both
// (build.cpp). What the phases ask of a cell is in look.h (law 1); what they do at a vertex is in turn.h and
// geometry/radial_match.h (law 2).
#include "outline/build.h"
#include "outline/exposure.h"
#include "outline/linking.h"
#include "outline/outline.h"

namespace lgs::detail {

void Outline::update(const Ground& ground, const Executor& executor) {
  if (isNoting_ && (!ground.changedChunks().empty() || !changes_.removed.empty())) note_ = &notes_.emplace_back();
  begin();
  if (executor && segments.isEmpty()) {
    build(ground, *this, executor);
  } else {
    Exposure phase1(ground, *this, ids_);
    for (const Chunk* chunk : ground.changedChunks()) phase1.renewChunk(*chunk);
    Linking phase2(ground, *this, fan_);
    for (const Chunk* chunk : ground.changedChunks()) phase2.linkChunk(*chunk);
  }
  if (ground.preserve)
    for (const SegmentId id : changes_.added) endWithoutLinks(id.value);
  finish();
}

/// A preserve relation that contradicts itself can leave ends that phase 2 never visits. They get no link.
void Outline::endWithoutLinks(std::uint32_t id) {
  SegmentRecord& s = segments[id];
  if (s.predecessor == kUnlinked) s.predecessor = kNoSegment;
  if (s.successor == kUnlinked) s.successor = kNoSegment;
}

/// Ids that the last update removed become available now, and not then. So no id is in two lists of one update, and the
/// ends of removed segments can be read while links are compared.
void Outline::begin() {
  if (note_) {
    note_->removedBefore = changes_.removed;
    note_->topBefore = segments.maxId() + 1;
  }
  for (const SegmentId id : changes_.removed) segments.recycle(id.value);
  changes_.removed.clear();
  changes_.added.clear();
  changes_.relinked.clear();
}

void Outline::finish() {
  for (const SegmentId id : changes_.relinked) segments[id.value].listed = 0;
  for (const SegmentId id : changes_.removed) {
    note(id.value);
    segments[id.value].cellRef = 0;
  }
  changes_.before = version_;
  if (!changes_.removed.empty() || !changes_.added.empty() || !changes_.relinked.empty()) version_ = versions_.next();
  changes_.after = version_;
  if (note_) std::exchange(note_, nullptr)->changes = changes_;
}

void Outline::linkAll(const Ground& ground) {
  Linking phase2(ground, *this, fan_);
  for (const Chunk* chunk : ground.changedChunks()) phase2.linkChunk(*chunk);
  for (std::uint32_t id = 1; id <= segments.maxId(); ++id)
    if (segments.isLive(id)) endWithoutLinks(id);
  version_ = versions_.next();
}

}  // namespace lgs::detail
