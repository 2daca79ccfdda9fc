#include "outline/links.h"

namespace lgs::detail {

// Most of the segments compared are in one cell. Then their ends need not be unpacked.
void Links::changeStart(std::uint32_t id, std::uint32_t now) {
  outline_.note(id);
  const std::uint32_t before = pool_[id].predecessor;
  const SegmentRecord &a = pool_[before], &b = pool_[now];
  const bool same = a.cellRef == b.cellRef ? a.from == b.from && ((a.high ^ b.high) & 3u) == 0
                                           : outline_.startOf(grid_, before) == outline_.startOf(grid_, now);
  if (before == kNoSegment || now == kNoSegment || !same) outline_.listRelinked(id);
}

void Links::changeEnd(std::uint32_t id, std::uint32_t now) {
  outline_.note(id);
  const std::uint32_t before = pool_[id].successor;
  const SegmentRecord &a = pool_[before], &b = pool_[now];
  const bool same = a.cellRef == b.cellRef ? a.to == b.to && ((a.high ^ b.high) & 12u) == 0
                                           : outline_.endOf(grid_, before) == outline_.endOf(grid_, now);
  if (before == kNoSegment || now == kNoSegment || !same) outline_.listRelinked(id);
}

}  // namespace lgs::detail
