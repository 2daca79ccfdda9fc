// The general way to renew a cell's segments: those that are there merged with what shows.
#include "exposure.h"

#include <algorithm>

namespace lgs::detail {

/// Merges the exposed edges of one part, which come in order, with the segments that are there.
class Exposure::PartUpdate {
 public:
  PartUpdate(Exposure& exposure, CellAt at, std::span<const std::uint32_t> old)
      : exposure_(exposure), at_(at), old_(old) {}

  void operator()(const PackedEnds& ends, Slot slot) {
    auto& ids = exposure_.ids_;
    const Placed placed = exposure_.grid_.placed(at_)[slot];
    const auto edge = std::pair(ends.start(), ends.end());
    for (; !old_.empty(); dropFirst()) {
      const SegmentRecord& first = exposure_.pool_[old_.front()];
      const auto order = std::pair(first.start(), first.end()) <=> edge;
      if (order > 0) break;
      if (order == 0 && first.serial == placed.serial && first.block == placed.block) {
        ids.push_back(old_.front());
        old_ = old_.subspan(1);
        return;
      }
    }
    ids.push_back(exposure_.create(at_.chunk->ref(at_.local), ends, placed));
    changed_ = true;
  }

  /// After the last edge: drops what is left. Whether anything changed.
  bool finish() {
    while (!old_.empty()) dropFirst();
    return changed_;
  }

 private:
  void dropFirst() {
    exposure_.world_.changes.removed.push_back({old_.front()});
    old_ = old_.subspan(1);
    changed_ = true;
  }

  Exposure& exposure_;
  CellAt at_;
  std::span<const std::uint32_t> old_;
  bool changed_ = false;
};

/// The general case: what is there merged with what shows.
void Exposure::update(CellAt at, unsigned parts) {
  const Look look(world_, at);
  const CellRecord* old = grid_.record(at);
  ids_.clear();
  PartEnds ends{};
  unsigned touches = 0;
  bool changed = false;
  for (unsigned part = 0; part < kParts; ++part) {
    const std::span<const std::uint32_t> before = old ? old->ids(part) : std::span<const std::uint32_t>{};
    if ((parts >> part & 1u) == 0) {
      ids_.insert(ids_.end(), before.begin(), before.end());
      if (old && part != kInterior) touches |= old->touching & bothCorners(part - 1);
    } else {
      PartUpdate merge(*this, at, before);
      look.forEach(part, [&](const PackedEnds& e, Slot slot, std::uint8_t touch) {
        merge(e, slot);
        touches |= touch;
      });
      changed |= merge.finish();
    }
    ends[part] = static_cast<std::uint16_t>(ids_.size());
  }
  if (!changed) return;
  CellRecord* r = grid_.spliceSegments(at, 0, old ? old->count() : 0, static_cast<std::uint32_t>(ids_.size()));
  if (!r) return;
  std::copy(ids_.begin(), ids_.end(), r->ids());
  r->end = ends;
  r->touching = static_cast<std::uint8_t>(touches);
}

}  // namespace lgs::detail
