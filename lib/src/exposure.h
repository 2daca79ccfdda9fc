// Phase 1 on the world: brings the segments of the cells near an edit up to date.
#pragma once

#include "wide_row.h"
#include "world_impl.h"

namespace lgs::detail {

class Exposure {
 public:
  explicit Exposure(World::Impl& world) : world_(world), grid_(world.grid), pool_(world.segments), ids_(world.ids) {}

  /// Renews the segments of the chunk's dirty cells, and of the cells beside them on the sides that they share. Segments
  /// that stay the same keep their ids.
  void renewChunk(const Chunk& chunk);

 private:
  class PartUpdate;

  /// What hides the sides of a cell.
  struct Facing {
    unsigned hidden = 0;   ///< bit s: side s is hidden as a whole by one edge
    bool isSimple = true;  ///< that is all: the others are free as a whole
  };

  Facing facing(CellAt at) const;
  const InternedContent& contentOf(CellAt at) const {
    return world_.catalogue.content(at ? grid_.content(at) : kEmptyContent);
  }
  void renewCell(CellAt at);
  void renewAll(CellAt at);
  void renewSide(CellAt at, unsigned side, unsigned facing);
  void removeAll(CellAt at);
  void createAll(CellAt at, const InternedContent& content, unsigned sides);
  void update(CellAt at, const InternedContent& content, Facing facing, unsigned parts);
  template <class Emit>
  void exposeSide(CellAt at, const Content& content, Facing facing, unsigned side, Emit&& emit);
  std::uint32_t create(std::uint32_t cellRef, const PackedEnds& ends, Placed placed);

  World::Impl& world_;
  Grid& grid_;
  SegmentPool& pool_;
  std::vector<std::uint32_t>& ids_;
};

}  // namespace lgs::detail
