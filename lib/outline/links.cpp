#include "outline/links.h"

namespace lgs::detail {

void Links::change(std::uint32_t id, std::uint32_t before, std::uint32_t now, bool isGhostStart) {
  outline_.note(id);
  const SegmentRecord &a = pool_[before], &b = pool_[now];
  const auto ghost = [&](const SegmentRecord& s) { return isGhostStart ? s.start() : s.end(); };
  const auto place = [&](const SegmentRecord& s) { return toWorld(grid_.cellOf(s.cellRef), ghost(s)); };
  const bool same = a.cellRef == b.cellRef ? ghost(a) == ghost(b) : place(a) == place(b);
  if (before == kNoSegment || now == kNoSegment || !same) outline_.listRelinked(id);
}

}  // namespace lgs::detail
