// Notes of what segments and lists were before an update, so that the outline can go back. Between two marks one note
// is enough: it has each segment and each list once, as it was before the first update that changed it.
#pragma once

#include "outline/segment_pool.h"
#include "storage/bit_set.h"
#include "storage/journal.h"

#include <lgs/ids.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace lgs::detail {

using RecordsById = std::vector<std::pair<std::uint32_t, SegmentRecord>>;

/// The words of lists of segments, as they were when each was noted.
class NotedLists {
 public:
  void add(std::uint32_t cellRef, std::span<const std::uint32_t> words) {
    lists_.emplace_back(cellRef, static_cast<std::uint32_t>(words.size()));
    words_.insert(words_.end(), words.begin(), words.end());
  }
  /// Calls visit(cellRef, words) for each.
  template <class Visit>
  void forEach(Visit&& visit) const {
    std::size_t begin = 0;
    for (const auto& [cellRef, size] : lists_) {
      visit(cellRef, std::span(words_).subspan(begin, size));
      begin += size;
    }
  }
  /// The same, the last one first.
  template <class Visit>
  void forEachBackwards(Visit&& visit) const {
    std::size_t end = words_.size();
    for (std::size_t k = lists_.size(); k-- != 0;) {
      end -= lists_[k].second;
      visit(lists_[k].first, std::span(words_).subspan(end, lists_[k].second));
    }
  }
  void giveBackSpare();
  std::uint64_t bytes() const;

 private:
  std::vector<std::pair<std::uint32_t, std::uint32_t>> lists_;  ///< the cell, and how many words
  std::vector<std::uint32_t> words_;
};

/// What an update changed, or several, and how that was before.
struct SegmentNote {
  std::vector<SegmentId> removedBefore;  ///< by the update before; these ids were recycled
  std::uint32_t topBefore = 0;           ///< one more than the greatest id
  std::size_t freeKept = 0;              ///< of the ids that were available: see SegmentPool::putBack()
  std::vector<std::uint32_t> freeTaken;
  std::vector<std::uint32_t> added;   ///< ids that named no segment before, and did then
  std::vector<std::uint32_t> turned;  ///< numbers of chunks that were loaded or unloaded
  RecordsById segments;               ///< the others that changed, in that order
  NotedLists lists;                   ///< in that order

  /// All segments that it changed.
  void addTo(std::vector<std::uint32_t>& ids) const;
  std::uint64_t bytes() const;
};

class SegmentNotes {
 public:
  bool areTaken() const { return areTaken_; }
  void start() { areTaken_ = true; }
  void stop();

  /// The number of the next note.
  std::uint64_t now() const { return notes_.next(); }
  const SegmentNote& operator[](std::uint64_t number) const { return notes_[number]; }

  /// After an update: nobody will go back to a moment between this one and now. One note for all updates since is
  /// enough then.
  void squeeze(std::uint64_t moment);
  void forgetBefore(std::uint64_t moment);

  std::uint64_t bytes() const;

 private:
  friend class Outline;  // which takes them as it changes, and takes them back

  SegmentNote& add(SegmentNote note = {}) { return notes_.add(std::move(note)); }
  /// Before notes are taken back.
  void close();
  SegmentNote takeBack() { return notes_.takeBack(); }
  void open();
  void merge(SegmentNote& into, const SegmentNote& next);

  Journal<SegmentNote> notes_;
  bool areTaken_ = false;
  // Which segments and lists the last note has, if it is open: now() is this number then. So it can take over the next.
  std::uint64_t opened_ = 0;
  BitSet notedSegments_;
  BitSet notedLists_;
};

}  // namespace lgs::detail
