// Phase 2 on the world, law 2: links the segments at every vertex near an edit.
#pragma once

#include "links.h"
#include "rim.h"
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
  void linkCorner(const Chunk& chunk, std::int32_t x, std::int32_t y);
  void linkSides(CellAt at);

  World::Impl& world_;
  Grid& grid_;
  Links links_;
  Rim rim_;
};

}  // namespace lgs::detail
