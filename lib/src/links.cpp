#include "links.h"

namespace lgs::detail {

void Links::listIfAnotherStart(std::uint32_t id, std::uint32_t before, std::uint32_t now) {
  if (!before || !now || !sameStart(pool_[before], pool_[now])) list(id);
}

void Links::listIfAnotherEnd(std::uint32_t id, std::uint32_t before, std::uint32_t now) {
  if (!before || !now || !sameEnd(pool_[before], pool_[now])) list(id);
}

// Most of the segments compared are in one cell. Then their ends need not be unpacked.
inline bool Links::sameStart(const SegmentRecord& a, const SegmentRecord& b) const {
  if (a.cellRef == b.cellRef) return a.from == b.from && ((a.high ^ b.high) & 3u) == 0;
  return toWorld(world_.grid.cellOf(a.cellRef), a.start()) == toWorld(world_.grid.cellOf(b.cellRef), b.start());
}

inline bool Links::sameEnd(const SegmentRecord& a, const SegmentRecord& b) const {
  if (a.cellRef == b.cellRef) return a.to == b.to && ((a.high ^ b.high) & 12u) == 0;
  return toWorld(world_.grid.cellOf(a.cellRef), a.end()) == toWorld(world_.grid.cellOf(b.cellRef), b.end());
}

void Links::list(std::uint32_t id) {
  SegmentRecord& s = pool_[id];
  if (s.listed) return;
  s.listed = 1;
  world_.changes.relinked.push_back({id});
}

}  // namespace lgs::detail
