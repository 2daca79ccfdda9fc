// What a World is made of. The catalogue owns the contents, the grid owns the cells, the pool owns the segments. Edits
// (edit.cpp) change cells and mark them dirty. A commit (commit.cpp) brings the segments up to date. Reading (read.cpp)
// changes nothing.
#pragma once

#include "catalogue.h"
#include "grid.h"
#include "journal.h"
#include "radial_match.h"
#include "segment_geometry.h"
#include "segment_pool.h"
#include "versions.h"

#include <lgs/world.h>

#include <bit>
#include <optional>
#include <vector>

namespace lgs {

struct World::Impl {
  explicit Impl(PreserveRelation relation) : preserve(std::move(relation)) {}
  Impl(const Impl& other) = default;  // useOwnChunks() then
  Impl& operator=(const Impl&) = delete;
  ~Impl() = default;
  void useOwnChunks();

  // edit.cpp
  Expected<ShapeId> shape(std::span<const detail::PolygonView> polygons);
  PolygonHandle addQuickly(Cell cell, ShapeId shape, Block block);
  Expected<PolygonHandle> add(Cell cell, ShapeId shape, Block block);
  Expected<PolygonHandle> add(Cell cell, ShapeId shape, Block block, std::span<PolygonHandle> handles);
  Expected<PolygonHandle> add(Cell cell, detail::PolygonView polygon, Block block);
  Expected<void> remove(PolygonHandle polygon);
  Expected<PolygonHandle> replace(Cell cell, ShapeId shape, Block block, std::span<PolygonHandle> handles);
  Expected<void> exchange(Cell cell, std::span<const PolygonHandle> removed, std::span<const NewPolygon> added,
                          std::span<PolygonHandle> handles);
  Expected<void> setBlock(PolygonHandle polygon, Block block);
  Expected<std::uint64_t> fill(const CellRect& cells, ShapeId shape, Block block);
  Expected<std::uint64_t> clear(const CellRect& cells);

  // many.cpp
  bool addManyQuickly(std::span<const Placement> placements, std::span<PolygonHandle> handles);

  // commit.cpp
  const Changes& commit(const Executor& executor);
  void forgetDirty();

  // read.cpp
  void polygons(Cell cell, std::vector<PlacedPolygon>& out) const;
  std::optional<PlacedPolygon> polygon(PolygonHandle handle) const;
  Segment segment(std::uint32_t id) const;
  std::vector<SegmentId> liveSegments() const;
  std::vector<SegmentId> segmentsIn(const CellRect& cells) const;
  std::vector<Loop> loops(Collinear collinear) const;
  void mergeCollinear(std::vector<Loop>& loops) const;
  bool holdsPolygonsOf(const Impl& other) const;
  Stats stats() const;

  // questions.cpp
  void forEachPolygon(const CellRect& cells, const World::PolygonVisitor& visit) const;
  std::optional<CellRect> bounds() const;
  Spot at(Point p) const;
  Expected<Nearest> nearest(Point p, double radius) const;
  Expected<RayHit> rayCast(Point from, Point to) const;

  /// The empty content if there is no chunk.
  const detail::InternedContent& contentOf(detail::CellAt at) const {
    return catalogue.content(at ? grid.content(at) : detail::kEmptyContent);
  }
  void touch(detail::CellAt at, detail::ContentId content);
  std::optional<detail::Slot> slotOf(PolygonHandle handle) const;
  bool keeps(Block a, Block b) const { return preserve && (a < b ? preserve(a, b) : preserve(b, a)); }
  Point startOf(std::uint32_t id) const { return toWorld(grid.cellOf(segments[id].cellRef), segments[id].start()); }
  Point endOf(std::uint32_t id) const { return toWorld(grid.cellOf(segments[id].cellRef), segments[id].end()); }

  PreserveRelation preserve;
  detail::Catalogue catalogue;
  detail::Grid grid;
  detail::SegmentPool segments;
  std::vector<detail::Chunk*> dirtyChunks;  ///< in the order in which edits touched them
  Changes changes;                          ///< of the last commit; ids in `removed` are available with the next one
  detail::Versions versions;
  std::uint64_t version = 0;  ///< of the segments
  detail::Journal journal;
  Changes changesOfRollBack;
  // Working memory. It is kept from one call to the next, to spare allocations.
  std::vector<LocalPoint> rounded;  ///< of the polygon being added
  std::vector<std::uint32_t> ids;   ///< of the segments of the cell that is updated
  std::vector<detail::Spoke> fan;   ///< at the vertex being linked

 private:
  /// A polygon of the cell that is edited.
  struct Entry {
    detail::PolygonId polygon = 0;
    detail::Placed placed;
    bool isOld = false;  ///< it was there before the edit
  };

  detail::Edge edgeOf(std::uint32_t id) const { return {startOf(id), endOf(id)}; }
  bool comesFirst(std::uint32_t a, std::uint32_t b) const;

  void readEntries(detail::CellAt at);
  void addEntries(std::span<const detail::PolygonId> added, Block block, std::uint32_t lastSerial);
  Expected<detail::ContentId> internEntries();
  Expected<detail::ContentId> withAdded(detail::CellAt at, std::span<const detail::PolygonId> added, Block block);
  PolygonHandle placeSole(detail::CellAt at, detail::ContentId content, Block block);
  Expected<PolygonHandle> place(detail::CellAt at, Cell cell, std::span<const detail::PolygonId> polygons, Block block,
                                std::span<PolygonHandle> handles);
  void apply(detail::CellAt at, detail::ContentId after, std::uint32_t lastSerial);
  Error overlapAmongEntries(std::uint32_t cellRef);
  Error overlapWith(detail::CellAt at, std::span<const detail::PolygonId> added);
  void mark(detail::CellAt at, detail::Facts facts);

  std::size_t workingBytes() const {
    const auto of = [](const auto&... v) { return (... + (v.capacity() * sizeof(v[0]))); };
    return of(rounded, ids, fan, entries_, placed_, ids_, known_, kept_);
  }

  // Working memory of one edit.
  std::vector<Entry> entries_;
  std::vector<detail::Placed> placed_;
  std::vector<detail::PolygonId> ids_;
  std::vector<std::uint8_t> known_;
  std::vector<std::pair<detail::Slot, detail::Slot>> kept_;
};

/// Notes the content that a cell has from now on.
inline void World::Impl::touch(detail::CellAt at, detail::ContentId content) {
  if (at.chunk->dirtyRows == 0) dirtyChunks.push_back(at.chunk);
  mark(at, catalogue.facts(content));
}

/// The same for a cell of a chunk that is among the dirty ones.
inline void World::Impl::mark(detail::CellAt at, detail::Facts facts) {
  detail::Chunk& chunk = *at.chunk;
  chunk.dirtyRows |= detail::RowMask{1} << at.row();
  chunk.dirty[at.row()] |= at.bit();
  chunk.facts[at.local] = facts;
  chunk.everFacts |= facts;
}

inline void World::Impl::forgetDirty() {
  for (detail::Chunk* chunk : dirtyChunks) {
    for (detail::RowMask rows = chunk->dirtyRows; rows != 0; rows &= rows - 1)
      chunk->dirty[static_cast<std::size_t>(std::countr_zero(rows))] = 0;
    chunk->dirtyRows = 0;
  }
  dirtyChunks.clear();
}

/// The usual case of add(), which is tried first and needs no call: one polygon into an empty cell, in the chunk of the
/// edit before, which is dirty already. Null, and nothing is done, in any other case.
inline PolygonHandle World::Impl::addQuickly(Cell cell, ShapeId shape, Block block) {
  const detail::SoleContent& sole = catalogue.soleContent(shape);
  const detail::CellAt at = grid.findQuickly(cell);
  if (sole.id == detail::kEmptyContent || !at || at.chunk->dirtyRows == 0) return {};
  const std::uint32_t serial = detail::Grid::placeQuickly(at, sole.id, block);
  if (serial == 0) return {};
  mark(at, sole.facts);
  return {at.chunk->ref(at.local), serial};
}

}  // namespace lgs
