// Phase 1 on the world: brings the segments of the cells near an edit up to date.
#pragma once

#include "wide_row.h"
#include "world_impl.h"

namespace lgs::detail {

class Exposure {
 public:
  explicit Exposure(World::Impl& world)
      : world_(world), grid_(world.grid), pool_(world.segments), scratch_(world.exposure) {}

  /// Renews the segments of the chunk's dirty cells, and of the cells beside them on the sides that they share. Segments
  /// that stay the same keep their ids.
  void renewChunk(const Chunk& chunk);

  /// Moves what was added to the list of changes.
  void finish();

 private:
  class PartUpdate;

  WideRow buried(const Chunk& chunk, std::int32_t y) const;
  const InternedContent& contentOf(CellAt at) const {
    return world_.catalogue.content(at ? grid_.content(at) : kEmptyContent);
  }
  void createAll(CellAt at, const InternedContent& content);
  void update(CellAt at, const InternedContent& content, unsigned parts);
  template <class Emit>
  void exposeSide(CellAt at, const Content& content, unsigned side, Emit&& emit);
  std::uint32_t create(std::uint32_t cellRef, const PackedEnds& ends, Placed placed, bool exposed);

  World::Impl& world_;
  Grid& grid_;
  SegmentPool& pool_;
  ExposureScratch& scratch_;
};

}  // namespace lgs::detail
