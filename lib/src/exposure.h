// Phase 1 on the world: brings the segments of the cells near an edit up to date.
#pragma once

#include "look.h"

namespace lgs::detail {

class Exposure {
 public:
  explicit Exposure(World::Impl& world) : world_(world), grid_(world.grid), pool_(world.segments), ids_(world.ids) {}

  /// Renews the segments of the chunk's dirty cells, and of the cells beside them on the sides that they share. Segments
  /// that stay the same keep their ids.
  void renewChunk(const Chunk& chunk);

 private:
  class PartUpdate;

  void renewCell(CellAt at);
  void renewAll(CellAt at);
  void renewSide(CellAt at, unsigned side, unsigned beyond);
  void removeAll(CellAt at);
  void update(CellAt at, unsigned parts);

  /// The next segment of the world.
  std::uint32_t create(std::uint32_t cellRef, const PackedEnds& ends, Placed placed) {
    const std::uint32_t id = pool_.take();
    pool_[id] = newSegment(cellRef, ends, placed);
    world_.changes.added.push_back({id});
    return id;
  }

  World::Impl& world_;
  Grid& grid_;
  SegmentPool& pool_;
  std::vector<std::uint32_t>& ids_;
};

}  // namespace lgs::detail
