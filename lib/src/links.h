// Writes links, and lists the segments whose ghost is another point now (law 6).
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
  // A link can change without its ghost: another segment with the same far end. Then the segment is as it was. Building
  // never asks, as no segment had a link before; so this is kept out of its way, in another file.
  void listIfAnotherStart(std::uint32_t id, std::uint32_t before, std::uint32_t now);
  void listIfAnotherEnd(std::uint32_t id, std::uint32_t before, std::uint32_t now);
  bool sameStart(const SegmentRecord& a, const SegmentRecord& b) const;
  bool sameEnd(const SegmentRecord& a, const SegmentRecord& b) const;
  void list(std::uint32_t id);

  World::Impl& world_;
  SegmentPool& pool_;
};

}  // namespace lgs::detail
