// What a brush does in one cell that an edge of the region runs through.
#pragma once

#include "pieces.h"

#include <lgs/world.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace lgs::brush {

enum class Deed : std::uint8_t { carve, fill, replace };

/// The blocks that stay. The game's function is asked once for each block in a stroke. So one that answers at random
/// does no harm: the steps of a stroke agree.
class Staying {
 public:
  explicit Staying(const StayingBlocks& ask) : ask_(ask) {}
  bool operator()(Block block) const {
    if (!ask_) return false;
    for (const auto& [known, stays] : known_)  // there are few
      if (known == block) return stays;
    return known_.emplace_back(block, ask_(block)).second;
  }

 private:
  const StayingBlocks& ask_;
  mutable std::vector<std::pair<Block, bool>> known_;
};

struct Stroke {
  Deed deed = Deed::carve;
  Block block = 0;  ///< what is painted
  FillRule rule = FillRule::nonZero;
  const Staying* staying = nullptr;  ///< null: none

  bool stays(Block old) const { return staying != nullptr && (*staying)(old); }
  /// Whether ground of a block becomes something else in the region, and whether what is free does.
  bool changes(Block old) const {
    return deed != Deed::fill && !(deed == Deed::replace && old == block) && !stays(old);
  }
  bool fillsFreePlaces() const { return deed != Deed::carve; }
};

/// A polygon of the cell, in units from the cell's corner.
struct CellPolygon {
  Points ring;
  Block block = 0;
};

struct NewPart {
  Points ring;
  Block block = 0;
  List<std::size_t> from;  ///< the old polygons that it has a part of, by index
};

struct CellEdit {
  List<std::size_t> gone;  ///< old polygons that are no more, by index; all others stay as they are
  List<NewPart> placed;
  List<std::size_t> rounded;  ///< of those that are gone: what law 9 should have kept
  bool isTooMuch = false;     ///< more crossings or more corners than a cell can have: the rest is not worked out
};

/// Whether the region, with its outline, has a point in common with a polygon.
bool meets(PieceSpan region, FillRule rule, const Points& ring);

/// Which polygons the region meets.
List<bool> meetingOf(const List<CellPolygon>& polygons, PieceSpan region, FillRule rule);

/// What a stroke does in a cell.
CellEdit editOf(std::span<const PlacedPolygon> polygons, PieceSpan region, const Stroke& stroke);

/// The same for any cell, by an arrangement of all edges. Cost: O(n²) in the edges of the cell's polygons and of the
/// region there.
CellEdit arrangedEdit(const List<CellPolygon>& polygons, PieceSpan region, const Stroke& stroke);

}  // namespace lgs::brush
