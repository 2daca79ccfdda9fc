// Writes the links of segments, and lists those whose ghost has moved (law 6).
#pragma once

#include "world_impl.h"

#include <cstdint>
#include <utility>

namespace lgs::detail {

class Links {
 public:
  explicit Links(World::Impl& world) : world_(world), pool_(world.segments) {}

  void setPredecessor(std::uint32_t id, std::uint32_t now) {
    const std::uint32_t before = std::exchange(pool_[id].predecessor, now);
    if (before != now && before != kUnlinked) listIfAnotherStart(id, before, now);
  }
  void setSuccessor(std::uint32_t id, std::uint32_t now) {
    SegmentRecord& s = pool_[id];
    const std::uint32_t before = s.successor;
    s.successor = now & kUnlinked;
    if (before != now && before != kUnlinked) listIfAnotherEnd(id, before, now);
  }

 private:
  // A link can change and the ghost stay: the other segment has the same far end. Then nothing is listed. These are in
  // another file, so that they are not inlined: a first build never needs them, as no segment had a link before.
  void listIfAnotherStart(std::uint32_t id, std::uint32_t before, std::uint32_t now);
  void listIfAnotherEnd(std::uint32_t id, std::uint32_t before, std::uint32_t now);
  bool sameStart(const SegmentRecord& a, const SegmentRecord& b) const;
  bool sameEnd(const SegmentRecord& a, const SegmentRecord& b) const;
  void list(std::uint32_t id);

  World::Impl& world_;
  SegmentPool& pool_;
};

}  // namespace lgs::detail
