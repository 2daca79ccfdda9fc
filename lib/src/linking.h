// Phase 2 on the world: links the segments at every vertex near an edit.
#pragma once

#include "world_impl.h"

namespace lgs::detail {

class Linking {
 public:
  /// `fan` is working memory.
  Linking(World::Impl& world, std::vector<Spoke>& fan);

  /// Links the segments at every vertex in or on the rim of the chunk's dirty cells.
  void linkChunk(const Chunk& chunk);

 private:
  class Fan;
  class SideWalk;

  void linkCell(CellAt at);
  void linkInterior(CellAt at);
  template <unsigned q>
  void addQuadrant(Fan& fan, const CellRecord& r) const;
  void linkCorner(const Chunk& chunk, std::int32_t x, std::int32_t y);
  void linkSides(CellAt at);
  void linkSide(CellAt at, unsigned side);
  void match(std::span<const Spoke> fan);
  void setPredecessor(std::uint32_t id, std::uint32_t now);
  void setSuccessor(std::uint32_t id, std::uint32_t now);
  bool sameStart(const SegmentRecord& a, const SegmentRecord& b) const;
  bool sameEnd(const SegmentRecord& a, const SegmentRecord& b) const;
  void listIfAnotherStart(std::uint32_t id, std::uint32_t before, std::uint32_t now);
  void listIfAnotherEnd(std::uint32_t id, std::uint32_t before, std::uint32_t now);
  void list(std::uint32_t id);

  World::Impl& world_;
  Grid& grid_;
  SegmentPool& pool_;
  std::vector<Spoke>& fan_;
};

}  // namespace lgs::detail
