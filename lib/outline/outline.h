// The outline: the exposed edges of the ground as segments, each with its predecessor and its successor. It is the
// first view of the ground: update() brings it up to date with the cells that changed. commit.cpp has the algorithm.
#pragma once

#include "ground/ground.h"
#include "outline/segment_lists.h"
#include "outline/segment_pool.h"
#include "storage/bit_set.h"
#include "storage/versions.h"

#include <lgs/world.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace lgs::detail {

/// What the lists have allocated.
inline std::uint64_t bytesOf(const Changes& c) {
  return (c.removed.capacity() + c.added.capacity() + c.relinked.capacity()) * sizeof(SegmentId);
}

class Outline {
 public:
  Outline() = default;
  Outline(const Outline&) = default;
  Outline& operator=(const Outline&) = delete;
  ~Outline() = default;

  /// Renews what the changed cells of the ground can have changed: the segments in them and beside them (law 5).
  void update(const Ground& ground, const Executor& executor);

  /// Of the last update, without the segments that are hidden.
  const Changes& changes() const { return isFiltered_ ? shown_ : changes_; }
  /// What it removed, hidden or not. These ids are available with the next one.
  const std::vector<SegmentId>& removed() const { return changes_.removed; }
  std::uint64_t version() const { return version_; }

  /// How many segments there are that are not hidden.
  std::uint64_t liveCount(const Grid& grid) const;
  /// As of the last update. A segment of an unloaded chunk is *hidden*: it is there to be linked to.
  bool isHidden(std::uint32_t chunk) const { return chunk < hidden_.size() && (hidden_[chunk] & kHidden) != 0; }
  bool hasHidden() const { return hiddenChunks_ != 0; }
  bool isHidden(SegmentId id) const { return hasHidden() && isHidden(segments[id.value].cellRef / kChunkCells); }
  bool isShown(SegmentId id) const { return segments.isLive(id.value) && !isHidden(id); }
  /// A chunk of which nothing is left. Its number may name another chunk from now on.
  void forget(std::uint32_t chunk);
  /// After chunks went, while nothing is noted.
  void giveBackPages() { segments.giveBackPages(segments.maxId() - segments.free().size() - changes_.removed.size()); }
  /// Where a segment is.
  Point startOf(const Grid& grid, std::uint32_t id) const {
    return toWorld(grid.cellOf(segments[id].cellRef), segments[id].start());
  }
  Point endOf(const Grid& grid, std::uint32_t id) const {
    return toWorld(grid.cellOf(segments[id].cellRef), segments[id].end());
  }

  SegmentPool segments;
  SegmentLists lists;

  // --- What the two phases do to it

  /// A new segment. The caller puts it into the list of its cell.
  std::uint32_t create(std::uint32_t cellRef, const PackedEnds& ends, Placed placed) {
    const std::uint32_t id = segments.take();
    segments[id] = newSegment(cellRef, ends, placed);
    changes_.added.push_back({id});
    return id;
  }
  void remove(std::uint32_t id) { changes_.removed.push_back({id}); }
  /// As SegmentLists::splice().
  std::uint32_t* splice(CellAt at, std::uint32_t begin, std::uint32_t removed, std::uint32_t added) {
    if (note_) noteList(at, note_->lists);
    return lists.splice(at, begin, removed, added);
  }
  /// Before a segment that was there changes.
  void note(std::uint32_t id) {
    if (note_) note_->segments.emplace_back(id, segments[id]);
  }
  void listRelinked(std::uint32_t id) {
    if (segments[id].listed) return;
    segments[id].listed = 1;
    changes_.relinked.push_back({id});
  }
  /// Ids for as many new segments, in the order in which create() would take them.
  std::span<const SegmentId> createIds(std::size_t count);

  // --- Going back, as the ground does: there is a note for each update that changed something.

  std::uint64_t now() const { return forgotten_ + notes_.size(); }
  void startNoting() { isNoting_ = true; }
  /// After an update: nobody will go back to a moment between this one and now. One note for all updates since is
  /// enough then.
  void squeeze(std::uint64_t moment);
  void stopNoting();
  void forgetBefore(std::uint64_t moment);
  /// `version` is that of the moment. `changes` receives what this does to the segments, by id. The ground must not
  /// have gone back yet.
  void goBack(const Grid& grid, std::uint64_t moment, std::uint64_t version, Undone undone, Changes& changes);
  /// To a moment that goBack() left behind, where all is as it left it. The ground must be there already.
  void goForward(const Grid& grid, std::uint64_t moment, std::uint64_t version, Changes& changes);
  void forgetUndone() { undone_ = {}; }

  // --- Saving

  /// A new outline gets ids up to `count`, of which some can be taken, and some were removed by the last update.
  void load(std::uint32_t count, std::vector<std::uint32_t> free, std::span<const std::uint32_t> removed);
  /// Links all segments of a ground whose cells have all changed.
  void linkAll(const Ground& ground);

  std::uint64_t bytes() const;

 private:
  using Records = std::vector<std::pair<std::uint32_t, SegmentRecord>>;  ///< by id

  /// What an update changed, or several, and how that was before.
  struct Note {
    std::vector<SegmentId> removedBefore;  ///< by the update before; these ids were recycled
    std::uint32_t topBefore = 0;           ///< one more than the greatest id
    std::size_t freeKept = 0;              ///< of the ids that were available: see SegmentPool::putBack()
    std::vector<std::uint32_t> freeTaken;
    std::vector<std::uint32_t> added;   ///< ids that named no segment before, and did then
    std::vector<std::uint32_t> turned;  ///< numbers of chunks that were loaded or unloaded
    Records segments;                   ///< the others that changed, in that order
    std::vector<std::uint32_t> lists;   ///< in that order the words of each list, how many these are, and the cell

    void addTo(std::vector<std::uint32_t>& ids) const;
    std::uint64_t bytes() const;
  };

  /// What was undone, and what there was after it.
  struct UndoneNote {
    Note note;
    std::vector<SegmentId> removed;
    std::uint32_t top = 0;
    std::vector<std::uint32_t> freeTaken;
    Records segments;
    std::vector<std::uint32_t> lists;  ///< as in the note
  };

  void begin();
  void dropTurned(const Ground& ground);
  void toggleHidden(std::uint32_t chunk);
  void clear(const Chunk& chunk);
  void filter();
  void finish();
  void endWithoutLinks(std::uint32_t id);
  void noteList(CellAt at, std::vector<std::uint32_t>& out) const;
  void endNote();
  void openNote();
  void closeNote();
  void take(Note& open, const Note& next);
  UndoneNote kept(const Grid& grid, const Note& note) const;
  void putLists(const Grid& grid, const std::vector<std::uint32_t>& noted);
  void undo(const Grid& grid, const Note& note);
  void redo(const Grid& grid, UndoneNote& undone);
  template <class Go>
  void go(const Grid& grid, std::vector<std::uint32_t> ids, std::uint64_t version, Changes& changes, Go&& go);

  Changes changes_;
  Changes shown_;  ///< the same without what is hidden, if some of it may be
  bool isFiltered_ = false;
  // By number of a chunk: whether it is unloaded, and was before the update under way.
  static constexpr std::uint8_t kHidden = 1, kWasHidden = 2;
  std::vector<std::uint8_t> hidden_;
  std::size_t hiddenChunks_ = 0;
  std::vector<std::uint32_t> turned_;  ///< numbers of the chunks that the update under way turned
  Versions versions_;
  std::uint64_t version_ = 0;
  std::vector<Note> notes_;
  std::size_t dropped_ = 0;         ///< notes at the front that are forgotten already
  std::uint64_t forgotten_ = 0;     ///< notes that are gone from the front
  std::vector<UndoneNote> undone_;  ///< the first to come back last
  Note* note_ = nullptr;            ///< of the update under way
  // Which segments and lists the last note has, if it is open: now() is this number then. So it can take over the next.
  std::uint64_t opened_ = 0;
  BitSet notedSegments_;
  BitSet notedLists_;
  bool isNoting_ = false;
  // Working memory. It is kept from one update to the next, to spare allocations.
  std::vector<std::uint32_t> ids_;
  std::vector<Spoke> fan_;
};

}  // namespace lgs::detail
