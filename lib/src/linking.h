// Phase 2 on the world, law 2: links the segments at every vertex near an edit.
#pragma once

#include "fan.h"
#include "links.h"
#include "world_impl.h"

namespace lgs::detail {

class Linking {
 public:
  /// `fan` is working memory.
  Linking(World::Impl& world, std::vector<Spoke>& fan);

  /// Links the segments at every vertex in or on the rim of the chunk's dirty cells.
  void linkChunk(const Chunk& chunk);

 private:
  void linkCell(CellAt at);
  void linkInterior(CellAt at);
  template <unsigned q>
  void addQuadrant(Fan& fan, const CellRecord& r) const;
  void linkCorner(const Chunk& chunk, std::int32_t x, std::int32_t y);
  void linkSides(CellAt at);
  void linkSide(CellAt at, unsigned side);
  void match(std::span<const Spoke> fan);

  World::Impl& world_;
  Grid& grid_;
  Links links_;
  std::vector<Spoke>& fan_;
};

}  // namespace lgs::detail
