// What is needed to go back to a mark. While there are marks, every edit of a cell and every commit leaves an entry
// here with the state before it. To go back undoes the entries, the last one first (law 12). Without marks nothing is
// kept.
//
// A commit changes the segments of the dirty cells and of the eight cells around each, and no others (law 5). So its
// entry has these segments as they were, and costs as much as the commit.
#pragma once

#include "catalogue.h"
#include "grid.h"
#include "owned.h"
#include "segment_pool.h"

#include <lgs/world.h>

#include <array>
#include <cstdint>
#include <deque>
#include <variant>
#include <vector>

namespace lgs::detail {

class Journal {
 public:
  /// Whether there are marks. World::Impl::addQuickly() need not ask: while there are, the grid remembers no chunk, and
  /// addQuickly() does nothing.
  bool isOpen() const { return isOpen_; }

  Mark mark(World::Impl& world, bool ofGroup = false);
  bool knows(Mark mark) const { return positionOf(mark) < marks_.size(); }

  /// Drops a mark, and the entries that no older mark needs.
  void forget(World::Impl& world, Mark mark);

  /// Drops the marks of groups. A copy of the world does so: nobody could end them there.
  void forgetGroups(World::Impl& world);

  /// Brings the world back to a mark, which stays. Later marks are void. `changes` receives what this does to the
  /// segments, by id.
  void rollBack(World::Impl& world, Mark mark, Changes& changes);

  /// Whether a commit was made since a mark, which must be known.
  bool committedSince(Mark mark) const;

  /// Before the polygons of a cell change.
  void noteCell(World::Impl& world, CellAt at);

  /// Before a commit, and after it. False, and there is nothing to note after it, if it finds nothing to do and follows
  /// another one: a game commits in every frame, and marks can stay long.
  bool noteCommit(const World::Impl& world);
  void noteChanges(const Changes& changes);

  std::uint64_t bytes() const;

 private:
  /// The polygons of a cell before an edit.
  struct CellEntry {
    std::uint32_t cellRef = 0;
    ContentId content = kEmptyContent;  ///< in use as long as the entry is there
    std::uint32_t lastSerial = 0;
    std::uint32_t polygons = 0;  ///< how many: they are in placed_
    bool isListed = false;
    bool wasDirty = false;
  };

  struct DirtyChunk {
    std::uint32_t index = 0;
    std::array<RowMask, kChunkSize> rows{};
  };

  /// The segments of a cell before a commit.
  struct CellSegments {
    std::uint32_t cellRef = 0;
    Parts parts;
    std::uint8_t touching = 0;
  };

  /// What a commit found, and what it reported.
  struct CommitEntry {
    std::vector<DirtyChunk> dirty;    ///< in the order of World::Impl::dirtyChunks
    std::vector<CellSegments> cells;  ///< those that it can change
    std::vector<std::uint32_t> ids;   ///< of their segments, cell by cell
    std::vector<SegmentRecord> segments;
    std::vector<SegmentId> removedBefore;  ///< by the commit before; this one recycled them
    std::uint32_t topBefore = 0;           ///< one more than the greatest id
    Changes changes;
  };
  using Entry = std::variant<CellEntry, Owned<CommitEntry>>;  // many are of cells, so they are small

  struct MarkEntry {
    Mark mark;
    std::uint64_t position = 0;  ///< how many entries there ever were before it
    std::size_t chunks = 0;
    std::uint64_t shapes = 0;
    std::uint64_t version = 0;  ///< of the segments
    bool ofGroup = false;
  };

  void setOpen(World::Impl& world, bool open);
  /// Whether nothing happened since the last commit, and no mark was made.
  bool endsWithCommit() const;
  std::size_t positionOf(Mark mark) const;
  /// Lets go of what an entry holds. Returns how many of placed_ are its own.
  static std::ptrdiff_t drop(World::Impl& world, const Entry& entry);
  void undo(World::Impl& world, const CellEntry& entry);
  static void undo(World::Impl& world, const Owned<CommitEntry>& owned);

  std::deque<Entry> entries_;
  std::deque<Placed> placed_;    ///< the polygons of the cells' entries, by slot, entry by entry
  std::uint64_t forgotten_ = 0;  ///< entries that were dropped at the front
  std::vector<MarkEntry> marks_;
  bool isOpen_ = false;
};

}  // namespace lgs::detail
