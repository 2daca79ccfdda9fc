// Writes the links of segments, and lists those whose ghost has moved (law 6).
#pragma once

#include "outline/outline.h"

#include <cstdint>

namespace lgs::detail {

class Links {
 public:
  Links(const Grid& grid, Outline& outline) : grid_(grid), outline_(outline), pool_(outline.segments) {}

  void link(std::uint32_t incoming, std::uint32_t outgoing) {
    setSuccessor(incoming, outgoing);
    setPredecessor(outgoing, incoming);
  }
  void setPredecessor(std::uint32_t id, std::uint32_t now) {
    SegmentRecord& s = pool_[id];
    if (s.predecessor != now && s.predecessor != kUnlinked) change(id, s.predecessor, now, true);
    s.predecessor = now;
  }
  void setSuccessor(std::uint32_t id, std::uint32_t now) {
    SegmentRecord& s = pool_[id];
    if (s.successor != now && s.successor != kUnlinked) change(id, s.successor, now, false);
    s.successor = now & kUnlinked;
  }

 private:
  // Slow path: an existing link changes. Lists the segment as relinked only if its ghost moved, which is the start or the
  // end of the other one: that may have the same far end. This is in another file, so that it is not inlined: a first
  // build never needs it, as no segment had a link before.
  void change(std::uint32_t id, std::uint32_t before, std::uint32_t now, bool isGhostStart);

  const Grid& grid_;
  Outline& outline_;
  SegmentPool& pool_;
};

}  // namespace lgs::detail
