// Edits. Each is checked against the ground as it is, and then sets the cell. A refused edit has changed nothing: no
// cell, and no chunk was made.
#pragma once

#include "ground/ground.h"
#include "storage/vectors.h"

#include <lgs/world.h>

#include <cstdint>
#include <span>
#include <vector>

namespace lgs::detail {

class Edit {
 public:
  explicit Edit(Ground& ground) : ground_(ground) {}

  /// The usual case of add(), which needs no call: a shape of one polygon into a cell that has nothing, in the chunk of
  /// the edit before. False, and nothing is done, in any other case.
  bool addSole(Cell cell, ShapeId shape, Block block, PolygonHandle& handle) {
    const InternedShape& interned = ground_.catalogue.shape(shape);
    const CellAt at = ground_.grid.findLast(cell);
    if (!at || !takesSole(at, interned)) return false;
    handle = {at.ref(), at.word() + 1};
    return ground_.setSoleAgain(at, interned, {handle.serial, block});
  }

  // As the functions of World that have these names.
  Expected<ShapeId> shape(std::span<const PolygonView> polygons);
  Expected<PolygonHandle> add(Cell cell, ShapeId shape, Block block, std::span<PolygonHandle> handles);
  Expected<PolygonHandle> add(Cell cell, PolygonView polygon, Block block);
  Expected<void> addMany(std::span<const Placement> placements, std::span<PolygonHandle> handles);
  Expected<void> remove(PolygonHandle polygon);
  Expected<void> removeMany(std::span<const PolygonHandle> polygons);
  Expected<PolygonHandle> replace(Cell cell, ShapeId shape, Block block, std::span<PolygonHandle> handles);
  Expected<void> exchange(Cell cell, std::span<const PolygonHandle> removed, std::span<const NewPolygon> added,
                          std::span<PolygonHandle> handles);
  Expected<void> setBlock(PolygonHandle polygon, Block block);
  Expected<std::uint64_t> fill(const CellRect& cells, ShapeId shape, Block block, std::span<PolygonHandle> handles);
  Expected<std::uint64_t> clear(const CellRect& cells);

  /// Of working memory.
  std::uint64_t bytes() const { return heldBytes(entries_, placed_, ids_, known_, kept_); }

 private:
  /// A polygon of the cell that is edited.
  struct Entry {
    PolygonId polygon = 0;
    Placed placed;
    bool isNew = false;
  };

  /// Whether a cell gets the shape's own content by it, and a word is enough for that.
  static bool takesSole(CellAt at, const InternedShape& shape) { return shape.isSole && at.word() < kLowMask; }
  template <class One>
  Expected<void> allOrNone(std::size_t count, One&& edit);
  bool addSoles(std::span<const Placement> placements, std::span<PolygonHandle> handles);
  Expected<void> check(Cell cell, ShapeId shape) const;
  Expected<void> checkFill(const CellRect& cells, ShapeId shape, Block block);

  // An edit of one cell: its polygons become `entries_`, which are changed, and set.
  void open(Cell cell);
  void place(PolygonId polygon, Block block);
  void place(ShapeId shape, Block block);
  Expected<void> check();
  Expected<ContentId> content();
  Expected<PolygonHandle> close(std::span<PolygonHandle> handles = {});
  Error overlap();

  Ground& ground_;
  // The edit under way. The vectors are kept from one edit to the next, to spare allocations.
  Cell cell_;
  CellAt at_;
  std::uint32_t lastSerial_ = 0, newOnes_ = 0;
  ContentId content_ = kEmptyContent;
  std::vector<Entry> entries_;  ///< sorted by polygon
  std::vector<Placed> placed_;
  std::vector<PolygonId> ids_;
  std::vector<std::uint8_t> known_;
  std::vector<std::pair<Slot, Slot>> kept_;
};

}  // namespace lgs::detail
