// How much of a world is solid, by block: the smallest view of the ground. It is kept up to date by what each commit
// and roll-back changed, and never looks at the rest of the world again.
//
//   if (!world.followCells(true)) …         // first: the world keeps what the view needs
//   examples::AreaByBlock areas(world);     // then: reads everything, once
//   world.commit();                         // and from now on, after each commit and roll-back:
//   areas.update(world.cellChanges());
//
// A view is a value. A copy of a world goes on with a copy of the view.
#pragma once

#include <lgs/world.h>

#include <cstdint>
#include <map>
#include <span>

namespace examples {

/// An exact area. A world has up to 2^32 cells, of 2^33 half square units each: 64 bits are too few for these, so whole
/// cells are counted apart.
struct Area {
  static constexpr std::int64_t kCell = 2 * std::int64_t{lgs::kUnitsPerCell} * lgs::kUnitsPerCell;

  std::int64_t cells = 0;      ///< whole ones
  std::int64_t halfUnits = 0;  ///< beside them: half square units, 0 … kCell - 1

  /// Adds as many half square units, or takes them away: at most a cell.
  void add(std::int64_t more);
  friend bool operator==(const Area&, const Area&) = default;
};

class AreaByBlock {
 public:
  /// Reads all polygons of a world, which has no edits that are not committed.
  explicit AreaByBlock(const lgs::World& world);

  /// Takes over what a commit or a roll-back changed. Cost: in proportion to the polygons and vertices of these cells.
  void update(std::span<const lgs::CellChange> changes);

  /// The area of each block that some polygon has.
  const std::map<lgs::Block, Area>& areas() const { return areas_; }

 private:
  void add(const lgs::PlacedPolygon& polygon, int sign);

  std::map<lgs::Block, Area> areas_;
};

}  // namespace examples
