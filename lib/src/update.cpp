// The general way to renew the segments of a cell: those that are there are merged with the edges that show now.
#include "exposure.h"

#include <algorithm>

namespace lgs::detail {

/// Walks along the segments that are there, part by part, and along the edges that show now. Both are in the same
/// order.
class Exposure::Merge {
 public:
  Merge(Exposure& exposure, CellAt at)
      : exposure_(exposure), placed_(exposure.grid_.placed(at)), ref_(at.chunk->ref(at.local)) {}

  /// Takes up the next part.
  void begin(std::span<const std::uint32_t> old) { old_ = old; }

  /// The next edge that shows. Its segment is there already, or is made.
  void show(const PackedEnds& ends, Slot slot) {
    const Placed placed = placed_[slot];
    const auto edge = std::pair(ends.start(), ends.end());
    for (; !old_.empty(); dropFirst()) {
      const SegmentRecord& first = exposure_.pool_[old_.front()];
      const auto order = std::pair(first.start(), first.end()) <=> edge;
      if (order > 0) break;
      if (order == 0 && first.serial == placed.serial && first.block == placed.block) {
        exposure_.ids_.push_back(old_.front());
        old_ = old_.subspan(1);
        return;
      }
    }
    exposure_.ids_.push_back(exposure_.create(ref_, ends, placed));
    changed_ = true;
  }

  /// After the last edge: drops what is left.
  void finish() {
    while (!old_.empty()) dropFirst();
  }

  bool changed() const { return changed_; }

 private:
  void dropFirst() {
    exposure_.world_.changes.removed.push_back({old_.front()});
    old_ = old_.subspan(1);
    changed_ = true;
  }

  Exposure& exposure_;
  PlacedBySlot placed_;
  std::uint32_t ref_;
  std::span<const std::uint32_t> old_;
  bool changed_ = false;
};

void Exposure::update(CellAt at, unsigned parts) {
  const Look look(world_, at);
  const CellRecord* old = grid_.record(at);
  Merge merge(*this, at);
  PartEnds ends{};
  unsigned touches = 0;
  ids_.clear();
  for (unsigned part = 0; part < kParts; ++part) {
    const std::span<const std::uint32_t> before = old ? old->ids(part) : std::span<const std::uint32_t>{};
    if ((parts >> part & 1u) == 0) {
      ids_.insert(ids_.end(), before.begin(), before.end());
      if (old && part != kInterior) touches |= old->touching & unsigned{bothCorners(part - 1)};
    } else {
      merge.begin(before);
      look.forEach(part, [&](const PackedEnds& edge, Slot slot, std::uint8_t touching) {
        merge.show(edge, slot);
        touches |= touching;
      });
      merge.finish();
    }
    ends[part] = static_cast<std::uint16_t>(ids_.size());
  }
  if (!merge.changed()) return;
  CellRecord* r = grid_.spliceSegments(at, 0, old ? old->count() : 0, static_cast<std::uint32_t>(ids_.size()));
  if (!r) return;
  std::copy(ids_.begin(), ids_.end(), r->ids());
  r->parts = partsOf(ends, touches, world_.contentOf(at).cornerEnds);
  r->touching = static_cast<std::uint8_t>(touches);
}

}  // namespace lgs::detail
