// Phase 2 on the ground, law 2: links the segments at every vertex near a change.
#pragma once

#include "outline/links.h"

#include <array>
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

  const Ground& ground_;
  const Outline& outline_;
  Links links_;
  std::vector<Spoke>& fan_;
};

}  // namespace lgs::detail
