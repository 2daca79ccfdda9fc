// The segments by id. Ids are dense, pages never move, and a slot keeps its data until it is used again, so that during
// a commit the ends of removed segments can still be read.
#pragma once

#include <lgs/lattice.h>

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <vector>

namespace lgs::detail {

inline constexpr std::uint32_t kNoSegment = 0;

/// An id has 31 bits, so that a record has room for two flags.
inline constexpr std::uint32_t kMaxSegment = (1u << 31) - 1;

/// 28 bytes. A coordinate is 0 … 65,536: sixteen bits, and one more in `high`.
struct SegmentRecord {
  std::uint32_t predecessor : 31;
  std::uint32_t fresh : 1;  ///< added by the commit under way
  std::uint32_t successor : 31;
  std::uint32_t listed : 1;  ///< already among the relinked of the commit under way
  std::uint32_t cellRef;     ///< 0: not alive
  Block block;
  std::uint32_t serial : 28;
  std::uint32_t high : 4;
  std::uint16_t low[4];

  LocalPoint start() const { return {coordinate(0), coordinate(1)}; }
  LocalPoint end() const { return {coordinate(2), coordinate(3)}; }
  void setEnds(LocalPoint s, LocalPoint e) {
    const std::int32_t value[4] = {s.x, s.y, e.x, e.y};
    unsigned highBits = 0;
    for (unsigned k = 0; k < 4; ++k) {
      low[k] = static_cast<std::uint16_t>(value[k] & 0xffff);
      highBits |= (static_cast<unsigned>(value[k]) >> 16) << k;
    }
    high = highBits & 0xfu;
  }

 private:
  std::int32_t coordinate(unsigned k) const { return static_cast<std::int32_t>(low[k] | (high >> k & 1u) << 16); }
};
static_assert(sizeof(SegmentRecord) == 28);

class SegmentPool {
 public:
  SegmentRecord& operator[](std::uint32_t id) { return pages_[id / kPage][id % kPage]; }
  const SegmentRecord& operator[](std::uint32_t id) const { return pages_[id / kPage][id % kPage]; }

  std::uint32_t allocate() {
    if (free_ != kNoSegment) {
      const std::uint32_t id = free_;
      free_ = (*this)[id].successor;
      return id;
    }
    if (next_ > kMaxSegment) std::abort();  // 56 GiB of segments: treated as running out of memory
    if (next_ % kPage == 0 || pages_.empty()) pages_.push_back(std::make_unique_for_overwrite<SegmentRecord[]>(kPage));
    return next_++;
  }

  /// Makes an id available again. Its slot must have been marked dead (cellRef 0).
  void recycle(std::uint32_t id) {
    (*this)[id].successor = free_ & kMaxSegment;
    free_ = id;
  }

  bool isLive(std::uint32_t id) const { return id != kNoSegment && id < next_ && (*this)[id].cellRef != 0; }
  std::uint32_t maxId() const { return next_ - 1; }
  std::uint64_t bytes() const { return pages_.size() * (kPage * sizeof(SegmentRecord) + sizeof pages_[0]); }

 private:
  static constexpr std::uint32_t kPage = 4096;
  std::vector<std::unique_ptr<SegmentRecord[]>> pages_;
  std::uint32_t next_ = 1;  // 0 names no segment
  std::uint32_t free_ = kNoSegment;
};

}  // namespace lgs::detail
