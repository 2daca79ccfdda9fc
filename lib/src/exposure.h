// Phase 1 on the world: brings the segments of the cells near an edit up to date.
#pragma once

#include "exposed_edges.h"
#include "wide_row.h"

namespace lgs::detail {

class Exposure {
 public:
  explicit Exposure(World::Impl& world)
      : world_(world), grid_(world.grid), pool_(world.segments), exposed_(world), ids_(world.ids) {}

  /// Renews the segments of the chunk's dirty cells, and of the cells beside them on the sides that they share. Segments
  /// that stay the same keep their ids.
  void renewChunk(const Chunk& chunk);

 private:
  class PartUpdate;

  using Facing = ExposedEdges::Facing;

  void renewCell(CellAt at);
  void renewAll(CellAt at);
  void renewSide(CellAt at, unsigned side, unsigned facing);
  void removeAll(CellAt at);
  void createAll(CellAt at, const InternedContent& content, unsigned sides);
  void update(CellAt at, const InternedContent& content, Facing facing, unsigned parts);
  std::uint32_t create(std::uint32_t cellRef, const PackedEnds& ends, Placed placed);

  World::Impl& world_;
  Grid& grid_;
  SegmentPool& pool_;
  ExposedEdges exposed_;
  std::vector<std::uint32_t>& ids_;
};

}  // namespace lgs::detail
