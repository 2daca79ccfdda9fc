// The segments by id. Ids are dense, and pages never move. A removed segment keeps its data until its id is used again,
// so that a commit can still read its ends.
#pragma once

#include "geometry/edge.h"
#include "ground/cell.h"
#include "storage/pages.h"

#include <lgs/ids.h>
#include <lgs/lattice.h>

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lgs::detail {

inline constexpr std::uint32_t kNoSegment = 0;

/// An id has 31 bits, so that a record has room for a flag. The greatest is no id: it is the link of a segment that is
/// new and has none yet.
inline constexpr std::uint32_t kUnlinked = (1u << 31) - 1;
inline constexpr std::uint32_t kSegmentPage = 4096;
/// The last page would have kUnlinked in it, and is never made.
inline constexpr std::uint32_t kMaxSegment = kUnlinked - kSegmentPage;

struct SegmentRecord {
  std::uint32_t predecessor;
  std::uint32_t successor : 31;
  std::uint32_t listed : 1;  ///< already among the relinked of the commit under way
  std::uint32_t cellRef;     ///< 0: not alive
  Block block;
  std::uint32_t serial : 28;
  std::uint32_t high : 4;
  std::uint32_t from;
  std::uint32_t to;

  PackedEnds ends() const { return {from, to, high}; }
  LocalPoint start() const { return ends().start(); }
  LocalPoint end() const { return ends().end(); }
};
static_assert(sizeof(SegmentRecord) == 28);

/// The record of a segment that has no links yet.
inline SegmentRecord newSegment(std::uint32_t cellRef, const PackedEnds& ends, Placed placed) {
  return {.predecessor = kUnlinked,
          .successor = kUnlinked,
          .listed = 0,
          .cellRef = cellRef,
          .block = placed.block,
          .serial = placed.serial & kMaxSerial,
          .high = ends.high & 0xfu,
          .from = ends.from,
          .to = ends.to};
}

class SegmentPool {
 public:
  SegmentRecord& operator[](std::uint32_t id) { return pages_[id / kPage][id % kPage]; }
  const SegmentRecord& operator[](std::uint32_t id) const { return pages_[id / kPage][id % kPage]; }

  /// An id for a new segment. The caller writes its record.
  std::uint32_t take() {
    if (freeCount_ != 0) {
      const std::uint32_t id = free_[--freeCount_];
      if (pages_.missing() != 0) [[unlikely]]
        bringBack(id / kPage);
      return id;
    }
    return takeTop();
  }
  /// Makes an id available again. Its record must say that it is not alive.
  void recycle(std::uint32_t id) {
    assert(id != kNoSegment && id < top_ && (*this)[id].cellRef == 0);
    if (freeCount_ == free_.size())
      free_.push_back(id);
    else
      free_[freeCount_] = id;
    ++freeCount_;
  }

  /// The ids that are available. The last one is taken next.
  std::span<const std::uint32_t> free() const { return std::span(free_).first(freeCount_); }

  // --- Roll-back and redo. An id that was taken stays in its place in the list of free ids, until another one that
  // is recycled is written there. If such a place is noted before, a length brings the list of another time back.

  struct Length {
    std::size_t free = 0;
    std::uint32_t top = 0;
  };
  Length length() const { return {freeCount_, top_}; }
  void setLength(const Length& length) {
    assert(length.free <= free_.size());
    freeCount_ = length.free;
    top_ = length.top;
  }
  /// The places in that list that were ever written.
  std::span<std::uint32_t> places() { return free_; }

  /// Gives a new pool `count` ids. None is alive; those in `free` can be taken.
  void reset(std::uint32_t count, std::vector<std::uint32_t> free) {
    assert(maxId() == 0);
    while (maxId() < count) (*this)[take()].cellRef = 0;
    free_ = std::move(free);
    freeCount_ = free_.size();
  }

  /// For tests of the limit, in a pool that is as new: its first pages count as given out, and are not there.
  void passOver(std::uint32_t pages) {
    addPage();
    pages_.addMissing(pages);
    top_ = static_cast<std::uint32_t>(pages_.size()) * kPage;
  }

  bool isLive(std::uint32_t id) const {
    return id != kNoSegment && id < top_ && pages_.has(id / kPage) && (*this)[id].cellRef != 0;
  }
  /// Pages on which no segment is alive take no memory until an id of theirs is taken. `live` says how many are. To be
  /// called after many went, while no segments are noted. Cost: O(1) for each that went, amortised.
  void giveBackPages(std::size_t live);
  /// Whether every id is available: no segment is alive.
  bool isEmpty() const { return freeCount_ == maxId(); }
  std::uint32_t maxId() const { return top_ == 0 ? 0 : top_ - 1; }
  std::uint64_t bytes() const { return pages_.bytes() + free_.capacity() * sizeof free_[0]; }

 private:
  static constexpr std::uint32_t kPage = kSegmentPage;
  using Page = std::array<SegmentRecord, kPage>;

  std::uint32_t takeTop() {
    if (top_ % kPage == 0) addPage();
    return top_++;
  }
  void addPage();  // in its own file, so that take() is small and inlined
  void bringBack(std::size_t page);

  Pages<Page> pages_;
  std::size_t dead_ = 0;             ///< records without a segment, when pages were last given back
  std::vector<std::uint32_t> free_;  ///< and behind these the ones that were taken
  std::size_t freeCount_ = 0;
  std::uint32_t top_ = 0;  ///< one more than the greatest id; 0 until the first page is made
};

}  // namespace lgs::detail
