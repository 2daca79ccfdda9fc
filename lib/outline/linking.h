// Phase 2 on the ground, law 2: links the segments at every vertex near a change, and lists those whose ghost has moved
// (law 6).
#pragma once

#include "outline/outline.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace lgs::detail {

class Linking {
 public:
  /// `fan` is working memory.
  Linking(const Ground& ground, Outline& outline, std::vector<Spoke>& fan);

  /// Links the segments at every vertex in or on the rim of the chunk's changed cells.
  void linkChunk(const Chunk& chunk);

 private:
  using Quadrants = std::array<CellSegments, 4>;  ///< around a corner: to the cell of quadrant q it is corner q

  void linkAround(CellAt at);
  void linkInterior(CellAt at);
  void linkSides(CellAt at, bool isSouthDone, bool isWestDone);
  void linkSide(CellAt at, unsigned side);
  void linkCorner(const Chunk& chunk, std::int32_t x, std::int32_t y);
  void linkCornerBySpokes(const std::array<CellAt, 4>& cells, const Quadrants& shown);
  void match(std::span<const Spoke> fan);

  void link(std::uint32_t incoming, std::uint32_t outgoing) {
    setSuccessor(incoming, outgoing);
    setPredecessor(outgoing, incoming);
  }
  void setPredecessor(std::uint32_t id, std::uint32_t now) {
    SegmentRecord& s = outline_.segments[id];
    if (s.predecessor != now && s.predecessor != kUnlinked) change(id, s.predecessor, now, true);
    s.predecessor = now;
  }
  void setSuccessor(std::uint32_t id, std::uint32_t now) {
    SegmentRecord& s = outline_.segments[id];
    if (s.successor != now && s.successor != kUnlinked) change(id, s.successor, now, false);
    s.successor = now & kUnlinked;
  }
  // Slow path: an existing link changes. Lists the segment as relinked only if its ghost moved, which is the start or the
  // end of the other one: that may have the same far end. A first build never needs it, as no segment had a link before.
  [[gnu::noinline]] void change(std::uint32_t id, std::uint32_t before, std::uint32_t now, bool isGhostStart);

  const Ground& ground_;
  Outline& outline_;
  std::vector<Spoke>& fan_;
};

}  // namespace lgs::detail
