// The algorithm. Phase 1 renews the segments of every cell near a change (exposure.cpp). Phase 2 links the segments at
// every vertex near a change (linking.cpp). Both visit the changed cells chunk by chunk, in the order of their first
// change. A cell or a vertex may be visited twice: what is written depends on the ground alone, so that does no harm.
// The vertices in and on the rim of changed cells are enough for phase 2: where phase 1 renews the side of a cell that
// did not change, the ends of what comes and goes lie on that rim. While there are no segments, threads can do both
// (build.cpp). What the phases ask of a cell is in look.h (law 1); what they do at a vertex is in turn.h and
// geometry/radial_match.h (law 2).
#include "outline/exposure.h"
#include "outline/fetch.h"
#include "outline/linking.h"
#include "outline/outline.h"

#include <algorithm>
#include <iterator>

namespace lgs::detail {

#ifdef LGS_SMALL_CODE
constexpr bool kHasThreads = false;  // in WebAssembly there are none
#else
constexpr bool kHasThreads = true;
#endif

namespace {

/// Calls visit(chunk) for each that changed. What fetches is no part of update(), which would be slower for small
/// worlds.
template <class Visit>
[[gnu::noinline]] void visitFetched(const Outline& outline, std::span<Chunk* const> changed, Visit&& visit) {
  forEachFetched(outline, changed, visit);
}
/// For a lone chunk an edit has asked for the rest.
[[gnu::noinline]] void fetchSegmentsOf(const Outline& outline, const Chunk& lone) {
  forEachScattered(lone, [&](CellAt at) { fetchSegments(outline, at.ref()); });
}
template <class Visit>
void visitChanged(const Outline& outline, std::span<Chunk* const> changed, Visit&& visit) {
  if (changed.size() > 1 && isLarge(outline)) [[unlikely]]
    return visitFetched(outline, changed, visit);
  for (const Chunk* chunk : changed) visit(*chunk);
}

}  // namespace

void Outline::update(const Ground& ground, Journal* journal, const Executor& executor) {
  journal_ = journal;
  changes_.removed.clear();
  changes_.added.clear();
  changes_.relinked.clear();
  isFiltered_ = ground.grid.unloadedCount() != 0 || hidesAny();
  if (isFiltered_) [[unlikely]]
    dropStreamed(ground);
  if (kHasThreads && executor && segments.isEmpty() && ground.grid.unloadedCount() == 0) {
    build(ground, *this, executor);
  } else {
    if (isLarge(*this) && ground.changedChunks().size() == 1) [[unlikely]]
      fetchSegmentsOf(*this, *ground.changedChunks().front());
    Exposure phase1(ground, *this, ids_);
    visitChanged(*this, ground.changedChunks(), [&](const Chunk& chunk) { phase1.renewChunk(chunk); });
    if (journal_) [[unlikely]]
      noteAdded();  // before phase 2 changes their records
    Linking phase2(ground, *this, fan_);
    visitChanged(*this, ground.changedChunks(), [&](const Chunk& chunk) { phase2.linkChunk(chunk); });
  }
  if (ground.preserve)
    for (const SegmentId id : changes_.added) endWithoutLinks(id.value);
  finish(!ground.changedChunks().empty());
  journal_ = nullptr;
}

/// Chunks that are unloaded and were not, or the other way around: their segments go, and those that show now are new.
/// So no id is of a hidden segment and then of one that is not. (If both came between two commits, ids stay.)
void Outline::dropStreamed(const Ground& ground) {
  hasStreamed_ = false;
  dropped_ = 0;
  shown_.removed.clear();
  for (const Chunk* chunk : ground.changedChunks()) {
    const bool was = hides(chunk->index);
    if (chunk->isUnloaded == was) continue;
    clear(*chunk);
    const std::span<const SegmentId> gone = std::span(changes_.removed).subspan(dropped_);
    if (!was) shown_.removed.insert(shown_.removed.end(), gone.begin(), gone.end());
    dropped_ += gone.size();
    Note* note = journal_ ? journal_->addOnce(Thing::hidden, chunk->index) : nullptr;
    if (note) note->value = was ? 1 : 0;
    setHidden(chunk->index, !was);
    hasStreamed_ = true;
  }
}

void Outline::setHidden(std::uint32_t chunk, bool isHidden) {
  if (isHidden)
    hidden_.insert(chunk);
  else
    hidden_.erase(chunk);
  giveBackBuckets(hidden_);
}

/// All segments of a chunk go.
void Outline::clear(const Chunk& chunk) {
  for (std::uint32_t row = 0; row < kChunkSize; ++row) {
    forEachBit(lists.liveRow(chunk, row), [&](std::uint32_t x) {
      const CellAt at{chunk.self(), row * kChunkSize + x};
      const std::span<const std::uint32_t> ids = lists.of(at).all();
      for (const std::uint32_t id : ids) remove(id);
      splice(at, 0, static_cast<std::uint32_t>(ids.size()), 0);
    });
  }
  lists.forget(chunk.index);  // how they are kept is decided anew
}

/// Leaves out what is hidden. Of the removed those that were dropped are told already, if they were shown before.
void Outline::filter() {
  const auto take = [&](std::span<const SegmentId> all, std::vector<SegmentId>& out) {
    std::ranges::copy_if(all, std::back_inserter(out), [&](SegmentId id) { return !isHidden(id); });
  };
  shown_.added.clear();
  shown_.relinked.clear();
  take(std::span(changes_.removed).subspan(dropped_), shown_.removed);
  take(changes_.added, shown_.added);
  take(changes_.relinked, shown_.relinked);
}

/// A preserve relation that contradicts itself can leave ends that phase 2 never visits. They get no link.
void Outline::endWithoutLinks(std::uint32_t id) {
  SegmentRecord& s = segments[id];
  if (s.predecessor == kUnlinked) s.predecessor = kNoSegment;
  if (s.successor == kUnlinked) s.successor = kNoSegment;
}

/// Ids of removed segments become available only here. So no id is in two lists of one update, and the ends of removed
/// segments can be read while links are compared. A commit that found something makes a version even if no segment
/// changed: the ground did, and views of it must see when they missed that.
void Outline::finish(bool hasFound) {
  for (const SegmentId id : changes_.relinked) segments[id.value].listed = 0;
  if (isFiltered_) [[unlikely]]
    filter();
  for (const SegmentId id : changes_.removed) {
    if (journal_) [[unlikely]]
      noteRemoved(id.value);
    segments[id.value].cellRef = 0;
    segments.recycle(id.value);
  }
  Changes& shown = isFiltered_ ? shown_ : changes_;
  shown.before = version_;
  if (hasFound) version_ = versions_.next();
  shown.after = version_;
}

void Outline::linkAll(const Ground& ground) {
  Linking phase2(ground, *this, fan_);
  for (const Chunk* chunk : ground.changedChunks()) phase2.linkChunk(*chunk);
  for (std::uint32_t id = 1; id <= segments.maxId(); ++id)
    if (segments.isLive(id)) endWithoutLinks(id);
  version_ = versions_.next();
}

}  // namespace lgs::detail
