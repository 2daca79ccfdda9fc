// A commit: phase 1 decides for every cell near an edit which parts of its edges are exposed, phase 2 links the segments
// at every vertex that this can have changed. Both visit the dirty cells chunk by chunk, in the order in which edits
// touched the chunks, and both can visit a cell or a vertex twice without harm: what they write depends on the cells
// alone.
#include "boundary.h"
#include "radial_match.h"
#include "world_impl.h"

#include <bit>

namespace lgs {
namespace {

using namespace detail;

/// A row of one bit per cell of a chunk with a cell of the neighbours at either end: bit x + 1 is column x.
using WideRow = std::uint64_t;
constexpr WideRow kOwnColumns = WideRow{0xffff'ffff} << 1;

/// Row y (-1 … 32) of one of a chunk's bitmaps.
template <auto Bitmap>
WideRow wideRow(const Chunk& chunk, std::int32_t y) {
  const auto row = static_cast<std::size_t>(y & (kChunkSize - 1));
  const auto first = static_cast<std::size_t>(3 * ((y >> 5) + 1));
  const auto bits = [&](const Chunk* c) { return c ? WideRow{(c->*Bitmap)[row]} : 0; };
  return bits(chunk.around[first]) >> 31 | bits(chunk.around[first + 1]) << 1 |
         (bits(chunk.around[first + 2]) & 1) << 33;
}

/// Calls visit(y) for y from -1 to 32 where row y, or one beside it, has a dirty cell.
template <class Visit>
void forEachRowNear(RowMask dirtyRows, Visit&& visit) {
  const WideRow rows = WideRow{dirtyRows} << 1;
  for (WideRow near = rows | rows << 1 | rows >> 1; near != 0; near &= near - 1) visit(std::countr_zero(near) - 1);
}

/// Calls visit(x) for every bit of a wide row.
template <class Visit>
void forEachColumn(WideRow row, Visit&& visit) {
  for (; row != 0; row &= row - 1) visit(std::countr_zero(row) - 1);
}

class Commit {
 public:
  Commit(World::Impl& world, std::vector<std::uint32_t>& ids, std::vector<Spoke>& fan)
      : world_(world), grid_(world.grid), pool_(world.segments), ids_(ids), fan_(fan) {}

  void run() {
    for (Chunk* chunk : world_.dirtyChunks) exposeChunk(*chunk);
    for (Chunk* chunk : world_.dirtyChunks) linkChunk(*chunk);
  }

 private:
  const InternedContent& contentOf(CellAt at) const {
    return world_.catalogue.content(at ? grid_.content(at) : kEmptyContent);
  }

  // --- Phase 1: exposure --------------------------------------------------------------------------------------------

  /// Renews the segments of the chunk's dirty cells, and of the cells beside them on the sides that they share.
  void exposeChunk(Chunk& chunk) {
    forEachRowNear(chunk.dirtyRows, [&](std::int32_t y) {
      const bool ownRow = y >= 0 && y < kChunkSize;
      const auto dirty = [&](std::int32_t row) {
        return row >= 0 && row < kChunkSize ? WideRow{chunk.dirty[static_cast<std::size_t>(row)]} << 1 : 0;
      };
      const WideRow here = dirty(y), below = dirty(y - 1), above = dirty(y + 1);
      WideRow near = here | below | above | here << 1 | here >> 1;
      // A dirty cell of another chunk is renewed with that chunk.
      const WideRow own = ownRow ? kOwnColumns : 0;
      near &= own | ~wideRow<&Chunk::dirty>(chunk, y);
      if (ownRow && !world_.preserve) near &= ~buried(chunk, y);
      forEachColumn(near, [&](std::int32_t x) {
        const CellAt at = cellAt(chunk, x, y);
        if (!at) return;
        const auto bit = [x](WideRow row) { return static_cast<unsigned>(row >> (x + 1) & 1u); };
        if (bit(here))
          renew(at, kAllParts);
        else
          renew(at, bit(below) << kSouthPart | bit(here >> 1) << kEastPart | bit(above) << kNorthPart |
                        bit(here << 1) << kWestPart);
      });
    });
  }

  /// Cells without segments that cover themselves and are enclosed by such: nothing can be exposed.
  static WideRow buried(const Chunk& chunk, std::int32_t y) {
    const WideRow covered = wideRow<&Chunk::covered>(chunk, y);
    const WideRow enclosed = covered & covered << 1 & covered >> 1 & wideRow<&Chunk::covered>(chunk, y - 1) &
                             wideRow<&Chunk::covered>(chunk, y + 1);
    return enclosed & ~wideRow<&Chunk::live>(chunk, y) & kOwnColumns;
  }

  static constexpr unsigned kAllParts = (1u << kParts) - 1;

  /// Brings these parts of a cell's segments up to date; segments that stay the same keep their ids.
  void renew(CellAt at, unsigned parts) {
    const InternedContent& content = contentOf(at);
    if (content.polygons.empty() && !grid_.hasSegments(at)) return;
    ids_.clear();
    PartEnds ends{};
    for (unsigned part = 0; part < kParts; ++part) {
      const std::span<const std::uint32_t> old = grid_.segments(at, part);
      if ((parts >> part & 1u) == 0) {
        ids_.insert(ids_.end(), old.begin(), old.end());
      } else {
        PartUpdate update(*this, at, old);
        if (part == kInterior)
          exposeInterior(content, update);
        else
          exposeSide(at, content, part - 1, update);
      }
      ends[part] = static_cast<std::uint16_t>(ids_.size());
    }
    grid_.setSegments(at, ids_, ends);
  }

  /// Merges the exposed edges of one part, which come in order, with the segments that are there.
  class PartUpdate {
   public:
    PartUpdate(Commit& commit, CellAt at, std::span<const std::uint32_t> old) : commit_(commit), at_(at), old_(old) {}
    ~PartUpdate() {
      while (!old_.empty()) dropFirst();
    }
    PartUpdate(const PartUpdate&) = delete;
    PartUpdate& operator=(const PartUpdate&) = delete;

    void operator()(LocalPoint start, LocalPoint end, Slot slot) {
      const Placed placed = commit_.grid_.placed(at_, slot);
      for (; !old_.empty(); dropFirst()) {
        const SegmentRecord& first = commit_.pool_[old_.front()];
        const auto order = std::pair(first.start(), first.end()) <=> std::pair(start, end);
        if (order > 0) break;
        if (order == 0 && first.serial == placed.serial) {
          commit_.ids_.push_back(old_.front());
          old_ = old_.subspan(1);
          return;
        }
      }
      commit_.ids_.push_back(commit_.create(at_, start, end, placed));
    }

   private:
    void dropFirst() {
      commit_.world_.changes.removed.push_back({old_.front()});
      old_ = old_.subspan(1);
    }

    Commit& commit_;
    CellAt at_;
    std::span<const std::uint32_t> old_;
  };

  static void exposeInterior(const Content& content, PartUpdate& update) {
    for (const InteriorSegment& s : content.interior) update(s.start, s.end, s.slot);
  }

  void exposeSide(CellAt at, const Content& content, unsigned side, PartUpdate& update) {
    const Cover mine = content.cover[side];
    if (mine == Cover::none) return;
    const CellAt beyond = across(at, side);
    const Content& facing = contentOf(beyond);
    const Cover theirs = facing.cover[opposite(side)];
    if (mine == Cover::whole && theirs == Cover::whole && !world_.preserve) return;
    exposedParts(
        content.sides[side], facing.sides[opposite(side)],
        [&](Slot a, Slot b) {
          return world_.preserve && world_.keeps(grid_.placed(at, a).block, grid_.placed(beyond, b).block);
        },
        [&](std::int32_t begin, std::int32_t end, Slot slot) {
          const LocalPoint low = pointAt(side, begin), high = pointAt(side, end);
          runsForward(side) ? update(low, high, slot) : update(high, low, slot);
        });
  }

  std::uint32_t create(CellAt at, LocalPoint start, LocalPoint end, Placed placed) {
    const std::uint32_t id = pool_.allocate();
    SegmentRecord& s = pool_[id];
    s.predecessor = s.successor = kNoSegment;
    s.fresh = 1;
    s.listed = 0;
    s.cellRef = at.chunk->ref(at.local);
    s.block = placed.block;
    s.serial = placed.serial & kMaxSerial;
    s.setEnds(start, end);
    world_.changes.added.push_back({id});
    return id;
  }

  // --- Phase 2: links -----------------------------------------------------------------------------------------------

  /// Links the segments at every vertex in or on the rim of the chunk's dirty cells.
  void linkChunk(Chunk& chunk) {
    forEachRowNear(chunk.dirtyRows, [&](std::int32_t y) {
      if (y < 0) return;
      const auto dirty = [&](std::int32_t row) {
        return row >= 0 && row < kChunkSize ? WideRow{chunk.dirty[static_cast<std::size_t>(row)]} << 1 : 0;
      };
      const WideRow here = dirty(y);
      const WideRow live = wideRow<&Chunk::live>(chunk, y), rimmed = wideRow<&Chunk::rimmed>(chunk, y);
      forEachColumn(here & live, [&](std::int32_t x) { linkInterior(cellAt(chunk, x, y)); });
      const WideRow rims = rimmed | rimmed << 1 | rimmed >> 1 | wideRow<&Chunk::rimmed>(chunk, y - 1) |
                           wideRow<&Chunk::rimmed>(chunk, y + 1);
      forEachColumn(here & rims, [&](std::int32_t x) {
        for (unsigned side = 0; side < kSides; ++side) linkSide(cellAt(chunk, x, y), side);
      });
      // The corners below row y: corner x lies between columns x - 1 and x.
      const WideRow dirtyAround = here | dirty(y - 1), liveAround = live | wideRow<&Chunk::live>(chunk, y - 1);
      const WideRow corners = (dirtyAround | dirtyAround << 1) & (liveAround | liveAround << 1);
      forEachColumn(corners, [&](std::int32_t x) { linkCorner(chunk, x, y); });
    });
  }

  void linkInterior(CellAt at) {
    const InternedContent& content = contentOf(at);
    const std::span<const std::uint32_t> ids = grid_.segments(at, kInterior);
    const auto idOf = [&](std::uint32_t k) { return k == InteriorSegment::kNone ? kNoSegment : ids[k]; };
    for (std::size_t k = 0; k < content.interior.size(); ++k) {
      const InteriorSegment& s = content.interior[k];
      if (s.predecessor != InteriorSegment::kRim) setPredecessor(ids[k], idOf(s.predecessor));
      if (s.successor != InteriorSegment::kRim) setSuccessor(ids[k], idOf(s.successor));
    }
  }

  // Around a rim vertex the grid gives the order: the directions along the sides, and between them the cells' interior
  // half-edges, which the contents keep in order. Directions are numbered so that each stretch has its own numbers.
  static constexpr std::uint32_t kStretch = 1u << 20;

  void addInterior(CellAt at, SpokeRange range, std::uint32_t stretch) {
    if (range.count == 0) return;
    const std::span<const std::uint32_t> ids = grid_.segments(at, kInterior);
    for (const InteriorSpoke& s : contentOf(at).at(range))
      fan_.push_back({ids[s.segment], stretch * kStretch + 1 + s.direction, s.outgoing});
  }

  void matchFan() {
    radialMatch(
        fan_, kNoSegment, [&](std::uint32_t s, std::uint32_t other) { setPredecessor(s, other); },
        [&](std::uint32_t s, std::uint32_t other) { setSuccessor(s, other); });
  }

  /// The corner where columns x - 1, x and rows y - 1, y meet. In the cell of quadrant q it is corner q; side q leaves it
  /// there, side q - 1 arrives.
  void linkCorner(Chunk& chunk, std::int32_t x, std::int32_t y) {
    constexpr std::array<std::int32_t, 4> dx{0, -1, -1, 0}, dy{0, 0, -1, -1};
    fan_.clear();
    for (unsigned q = 0; q < 4; ++q) {
      const CellAt at = cellAt(chunk, x + dx[q], y + dy[q]);
      if (!at || !grid_.hasSegments(at)) continue;
      const unsigned leaving = q, arriving = (q + 3) % kSides;
      if (const std::uint32_t id = endmost(at, leaving, true, kCorners[q])) fan_.push_back({id, q * kStretch, true});
      addInterior(at, contentOf(at).corners[q], q);
      if (const std::uint32_t id = endmost(at, arriving, false, kCorners[q]))
        fan_.push_back({id, (q + 1) % 4 * kStretch, false});
    }
    matchFan();
  }

  /// The segment on a side that starts (or ends) at a corner where the side does, if there is one.
  std::uint32_t endmost(CellAt at, unsigned side, bool starts, LocalPoint corner) const {
    const std::span<const std::uint32_t> ids = grid_.segments(at, partOf(side));
    if (ids.empty()) return kNoSegment;
    const std::uint32_t id = starts == runsForward(side) ? ids.front() : ids.back();
    return (starts ? pool_[id].start() : pool_[id].end()) == corner ? id : kNoSegment;
  }

  /// All vertices in the open side of a cell.
  void linkSide(CellAt at, unsigned side) {
    const CellAt beyond = across(at, side);
    SideWalk mine(*this, at, side), theirs(*this, beyond, opposite(side));
    while (!mine.done() || !theirs.done()) {
      const std::int32_t vertex = std::min(mine.next(), theirs.next());
      // Counter-clockwise from the direction in which my edges run: my half-edges, the other direction, theirs.
      fan_.clear();
      mine.addSideSpokes(vertex, runsForward(side), 0);
      theirs.addSideSpokes(vertex, runsForward(side), 0);
      mine.addInteriorSpokes(vertex, 0);
      mine.addSideSpokes(vertex, !runsForward(side), 1);
      theirs.addSideSpokes(vertex, !runsForward(side), 1);
      theirs.addInteriorSpokes(vertex, 1);
      matchFan();
      mine.pass(vertex);
      theirs.pass(vertex);
    }
  }

  /// Walks along one cell's side of a boundary, from vertex to vertex.
  class SideWalk {
   public:
    SideWalk(Commit& commit, CellAt at, unsigned side)
        : commit_(commit), at_(at), side_(side), points_(commit.contentOf(at).sides[side].points) {
      if (at) ids_ = commit.grid_.segments(at, partOf(side));
    }
    bool done() const { return points_.empty(); }
    std::int32_t next() const { return done() ? kUnitsPerCell : points_.front().at; }

    /// The segment that lies beyond the vertex (in the direction of increasing coordinates) or before it.
    void addSideSpokes(std::int32_t vertex, bool beyond, std::uint32_t stretch) {
      while (!ids_.empty() && high(ids_.front()) < vertex) ids_ = ids_.subspan(1);
      for (const std::uint32_t id : ids_.first(std::min<std::size_t>(ids_.size(), 2))) {
        if ((beyond ? low(id) : high(id)) != vertex) continue;
        commit_.fan_.push_back({id, stretch * kStretch, along(side_, commit_.pool_[id].start()) == vertex});
      }
    }
    void addInteriorSpokes(std::int32_t vertex, std::uint32_t stretch) {
      if (next() == vertex) commit_.addInterior(at_, points_.front().spokes, stretch);
    }
    void pass(std::int32_t vertex) {
      if (next() == vertex) points_ = points_.subspan(1);
    }

   private:
    std::int32_t low(std::uint32_t id) const { return bounds(id).first; }
    std::int32_t high(std::uint32_t id) const { return bounds(id).second; }
    std::pair<std::int32_t, std::int32_t> bounds(std::uint32_t id) const {
      return std::minmax(along(side_, commit_.pool_[id].start()), along(side_, commit_.pool_[id].end()));
    }

    Commit& commit_;
    CellAt at_;
    unsigned side_;
    std::span<const RimPoint> points_;
    std::span<const std::uint32_t> ids_;
  };

  void setPredecessor(std::uint32_t id, std::uint32_t now) {
    SegmentRecord& s = pool_[id];
    const std::uint32_t before = s.predecessor;
    if (before == now) return;
    s.predecessor = now & kMaxSegment;
    if (!s.fresh && (!before || !now || world_.startOf(before) != world_.startOf(now))) list(id);
  }

  void setSuccessor(std::uint32_t id, std::uint32_t now) {
    SegmentRecord& s = pool_[id];
    const std::uint32_t before = s.successor;
    if (before == now) return;
    s.successor = now & kMaxSegment;
    if (!s.fresh && (!before || !now || world_.endOf(before) != world_.endOf(now))) list(id);
  }

  void list(std::uint32_t id) {
    if (pool_[id].listed) return;
    pool_[id].listed = 1;
    world_.changes.relinked.push_back({id});
  }

  World::Impl& world_;
  Grid& grid_;
  SegmentPool& pool_;
  std::vector<std::uint32_t>& ids_;  ///< of the cell being renewed
  std::vector<Spoke>& fan_;          ///< at the vertex being linked
};

}  // namespace

const Changes& World::Impl::commit() {
  // Ids removed by the last commit become available now and not then, so that none is in two lists of one commit and
  // the ends of removed segments can be read while links are compared.
  for (const SegmentId id : changes.removed) segments.recycle(id.value);
  changes.removed.clear();
  changes.added.clear();
  changes.relinked.clear();

  Commit(*this, commitIds_, commitFan_).run();

  for (const SegmentId id : changes.added) segments[id.value].fresh = 0;
  for (const SegmentId id : changes.relinked) segments[id.value].listed = 0;
  for (const SegmentId id : changes.removed) segments[id.value].cellRef = 0;
  for (Chunk* chunk : dirtyChunks) {
    for (RowMask rows = chunk->dirtyRows; rows != 0; rows &= rows - 1)
      chunk->dirty[static_cast<std::size_t>(std::countr_zero(rows))] = 0;
    chunk->dirtyRows = 0;
  }
  dirtyChunks.clear();
  catalogue.collect();
  return changes;
}

}  // namespace lgs
