// Phase 1 on the ground, law 1: brings the segments of the cells near a change up to date.
#pragma once

#include "outline/look.h"
#include "outline/outline.h"

namespace lgs::detail {

class Exposure {
 public:
  /// `ids` is working memory.
  Exposure(const Ground& ground, Outline& outline, std::vector<std::uint32_t>& ids)
      : ground_(ground), outline_(outline), ids_(ids) {}

  /// Renews the segments of the chunk's changed cells; and of the cells beside them, on the sides that they share.
  /// Segments that stay as they are keep their ids.
  void renewChunk(const Chunk& chunk);

 private:
  void renewAround(CellAt at);
  void renew(CellAt at);
  void renewSide(CellAt at, unsigned side, unsigned beyond);
  void create(CellAt at);
  void merge(CellAt at, unsigned parts);

  const Ground& ground_;
  Outline& outline_;
  std::vector<std::uint32_t>& ids_;
};

}  // namespace lgs::detail
