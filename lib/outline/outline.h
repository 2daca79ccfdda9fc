// The outline: the exposed edges of the ground as segments, each with its predecessor and its successor. It is the
// first view of the ground: update() brings it up to date with the cells that changed. commit.cpp has the algorithm.
#pragma once

#include "ground/ground.h"
#include "outline/segment_lists.h"
#include "outline/segment_pool.h"
#include "storage/journal.h"
#include "storage/versions.h"

#include <lgs/world.h>

#include <cstdint>
#include <optional>
#include <unordered_set>
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

  /// Renews what the changed cells of the ground can have changed: the segments in them and beside them (law 5). Where
  /// there is a journal, it gets what comes, goes and changes.
  void update(const Ground& ground, Journal* journal, const Executor& executor);

  /// Of the last update, without the segments that are hidden.
  const Changes& changes() const { return isFiltered_ ? shown_ : changes_; }
  /// Whether that update changed segments that are shown, or which chunks are.
  bool hasShownChange() const {
    const Changes& shown = changes();
    return (isFiltered_ && hasStreamed_) || !shown.removed.empty() || !shown.added.empty() || !shown.relinked.empty();
  }
  std::uint64_t version() const { return version_; }
  void setVersion(std::uint64_t version) { version_ = version; }

  /// How many segments there are that are not hidden.
  std::uint64_t liveCount(const Grid& grid) const;
  /// Whether the segments of a chunk are hidden, since it was unloaded at the last update: they are there to be linked
  /// to. The number need not be in use.
  bool hides(std::uint32_t chunk) const { return hidden_.contains(chunk); }
  bool hidesAny() const { return !hidden_.empty(); }
  bool isHidden(SegmentId id) const { return hidesAny() && hides(segments[id.value].cellRef / kChunkCells); }
  bool isShown(SegmentId id) const { return segments.isLive(id.value) && !isHidden(id); }
  /// A chunk of which nothing is left. Its number may name another chunk from now on.
  void forget(std::uint32_t chunk);
  /// After chunks went, while nothing is noted.
  void giveBackPages() { segments.giveBackPages(segments.maxId() - segments.free().size()); }
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
    if (journal_) [[unlikely]]
      noteList(at);
    return lists.splice(at, begin, removed, added);
  }
  /// Before a segment that was there changes.
  void note(std::uint32_t id) {
    if (journal_) [[unlikely]]
      noteSegment(id);
  }
  /// Whether the update under way notes what it changes.
  bool isNoting() const { return journal_ != nullptr; }
  /// The segments that phase 1 added were not alive before.
  void noteAdded();
  void listRelinked(std::uint32_t id) {
    if (segments[id].listed) return;
    segments[id].listed = 1;
    changes_.relinked.push_back({id});
  }
  /// Ids for as many new segments, in the order in which create() would take them.
  std::span<const SegmentId> createIds(std::size_t count);

  // --- Roll-back and redo (roll_back.cpp)

  /// Beside the notes a moment has this.
  struct State {
    SegmentPool::Length ids;
    std::uint64_t version = 0;
  };
  State state() const { return {segments.length(), version_}; }
  /// A note of the outline and the outline exchange what they hold.
  void exchange(const Grid& grid, Journal& journal, Note& note);
  /// What can be seen of a segment that is alive, for law 6: the edge, its block and cell, and where its ghosts are.
  struct Seen {
    Point start, end;
    Block block = 0;
    std::uint32_t cellRef = 0, serial = 0;
    std::optional<Point> ghost1 = {}, ghost2 = {};

    bool isSameEdge(const Seen& s) const {
      return start == s.start && end == s.end && block == s.block && cellRef == s.cellRef && serial == s.serial;
    }
  };
  std::vector<std::optional<Seen>> seen(const Grid& grid, const std::vector<std::uint32_t>& ids) const;
  void setState(const State& state) {
    segments.setLength(state.ids);
    setVersion(state.version);
  }
  /// What became of segments since they were `before`, in the order of `ids`.
  void compare(const Grid& grid, const std::vector<std::uint32_t>& ids, const std::vector<std::optional<Seen>>& before,
               Changes& changes) const;

  // --- Saving

  /// A new outline gets ids up to `count`, of which some can be taken.
  void load(std::uint32_t count, std::vector<std::uint32_t> free) { segments.reset(count, std::move(free)); }
  /// Links all segments of a ground whose cells have all changed.
  void linkAll(const Ground& ground);

  std::uint64_t bytes() const;

 private:
  void dropStreamed(const Ground& ground);
  void clear(const Chunk& chunk);
  void filter();
  void finish(bool hasFound);
  void endWithoutLinks(std::uint32_t id);
  void noteList(CellAt at);
  void noteSegment(std::uint32_t id);
  void setHidden(std::uint32_t chunk, bool isHidden);
  void noteRemoved(std::uint32_t id);

  Changes changes_;
  Changes shown_;                             ///< the same without what is hidden, if some of it may be
  bool isFiltered_ = false;                   ///< whether the last update had hidden segments, or unloaded chunks
  bool hasStreamed_ = false;                  ///< if it had: whether chunks came or went with it
  std::size_t dropped_ = 0;                   ///< of the removed, those of chunks that came or went
  std::unordered_set<std::uint32_t> hidden_;  ///< numbers of chunks
  Versions versions_;
  std::uint64_t version_ = 0;
  Journal* journal_ = nullptr;  ///< of the update under way, if there is a moment to roll back to
  // Working memory. It is kept from one update to the next, to spare allocations.
  std::vector<std::uint32_t> ids_;
  std::vector<Spoke> fan_;
};

/// Both phases of an update for all changed chunks, on several threads (build.cpp). There are no segments: so every cell
/// that holds polygons has changed. Segments, ids and changes are the same as if the chunks were renewed and linked one
/// after the other.
void build(const Ground& ground, Outline& outline, const Executor& executor);

}  // namespace lgs::detail
