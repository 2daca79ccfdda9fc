#include "linking.h"

#include "radial_match.h"
#include "wide_row.h"

#include <algorithm>
#include <utility>

namespace lgs::detail {
namespace {

// Around a rim vertex the grid gives the order: the directions along the sides, and between them the cells' interior
// half-edges, which the contents keep in order. Directions are numbered so that each of these stretches has its own.
constexpr std::uint32_t kStretch = 1u << 20;

}  // namespace

/// The spokes at one vertex as they are collected. Adding one that is not there costs what adding one costs, and no
/// branch.
class Linking::Fan {
 public:
  explicit Fan(std::vector<Spoke>& spokes) : begin_(spokes.data()), end_(begin_) {}

  /// `present` is 1 or 0.
  void add(std::uint32_t segment, std::uint32_t direction, std::uint32_t outgoing, std::uint32_t present) {
    *end_ = {segment, direction & kMaxDirection, outgoing & 1u};
    end_ += present;
  }
  void addInterior(const Content& content, const SpokeRange& range, const std::uint32_t* ids, std::uint32_t stretch) {
    const auto addSpoke = [&](const Spoke& spoke, std::uint32_t present) {
      add(ids[spoke.segment], stretch * kStretch + 1 + spoke.direction, spoke.outgoing, present);
    };
    addSpoke(range.first, range.count > 0 ? 1 : 0);
    for (std::uint32_t k = 1; k < range.count; ++k) addSpoke(content.spokes[range.rest + k - 1], 1);
  }
  std::span<const Spoke> spokes() const { return {begin_, end_}; }

 private:
  Spoke* begin_;
  Spoke* end_;
};

Linking::Linking(World::Impl& world, std::vector<Spoke>& fan)
    : world_(world), grid_(world.grid), pool_(world.segments), fan_(fan) {
  constexpr std::size_t kOfSides = 8;                                        // two to each of four directions
  fan_.resize(4 * std::size_t{world.catalogue.widestFan()} + kOfSides + 1);  // and one that is written and not there
}

/// The only dirty cell of its chunk.
void Linking::linkCell(CellAt at) {
  const Chunk& chunk = *at.chunk;
  if ((chunk.facts[at.local] & kLinkedInside) != 0) linkInterior(at);
  linkSides(at);
  const auto x = static_cast<std::int32_t>(at.local % kChunkSize), y = static_cast<std::int32_t>(at.local / kChunkSize);
  linkCorner(chunk, x, y);
  linkCorner(chunk, x + 1, y);
  linkCorner(chunk, x, y + 1);
  linkCorner(chunk, x + 1, y + 1);
}

void Linking::linkChunk(const Chunk& chunk) {
  if (const CellAt only = onlyDirtyCell(chunk)) {
    linkCell(only);
    return;
  }
  const bool nearRimPoints = std::any_of(chunk.around.begin(), chunk.around.end(),
                                         [](const Chunk* c) { return c && (c->everFacts & kRimPoints) != 0; });
  forEachRowNear(chunk.dirtyRows, [&](std::int32_t y) {
    if (y < 0) return;
    const WideRow here = dirtyRow(chunk, y);
    if (y < kChunkSize) {
      const WideRow live = wideRow<&Chunk::live>(chunk, y);
      if ((chunk.everFacts & kLinkedInside) != 0)
        forEachColumn(here & live, [&](std::int32_t x) { linkInterior(cellAt(chunk, x, y)); });
      if (nearRimPoints) forEachColumn(here, [&](std::int32_t x) { linkSides(cellAt(chunk, x, y)); });
    }
    // The corners below row y: corner x lies between columns x - 1 and x.
    const WideRow dirty = here | dirtyRow(chunk, y - 1);
    WideRow corners = dirty | dirty << 1;
    if (isCrowded(corners)) {
      const WideRow live = wideRow<&Chunk::live>(chunk, y) | wideRow<&Chunk::live>(chunk, y - 1);
      corners &= live | live << 1;
      if (y == kChunkSize) {  // those at a dirty cell of the chunk above are linked with that one
        const WideRow above = wideRow<&Chunk::dirty>(chunk, y) & kOwnColumns;
        corners &= ~(above | above << 1);
      }
    }
    forEachColumn(corners, [&](std::int32_t x) { linkCorner(chunk, x, y); });
  });
}

inline void Linking::setPredecessor(std::uint32_t id, std::uint32_t now) {
  const std::uint32_t before = std::exchange(pool_[id].predecessor, now);
  if (before != now && before != kUnlinked) listIfAnotherStart(id, before, now);
}

inline void Linking::setSuccessor(std::uint32_t id, std::uint32_t now) {
  SegmentRecord& s = pool_[id];
  const std::uint32_t before = s.successor;
  s.successor = now & kUnlinked;
  if (before != now && before != kUnlinked) listIfAnotherEnd(id, before, now);
}

void Linking::linkInterior(CellAt at) {
  const InternedContent& content = world_.contentOf(at);
  if ((content.facts & kLinkedInside) == 0) return;
  const std::span<const std::uint32_t> ids = grid_.record(at)->ids(kInterior);
  const auto idOf = [&](std::uint32_t k) { return k == InteriorSegment::kNone ? kNoSegment : ids[k]; };
  for (std::size_t k = 0; k < content.interior.size(); ++k) {
    const InteriorSegment& s = content.interior[k];
    if (s.predecessor != InteriorSegment::kRim) setPredecessor(ids[k], idOf(s.predecessor));
    if (s.successor != InteriorSegment::kRim) setSuccessor(ids[k], idOf(s.successor));
  }
}

inline void Linking::match(std::span<const Spoke> fan) {
  if (!world_.preserve) {
    radialMatchAlternating(fan, [&](std::uint32_t incoming, std::uint32_t outgoing) {
      setSuccessor(incoming, outgoing);
      setPredecessor(outgoing, incoming);
    });
    return;
  }
  radialMatch(
      fan, kNoSegment, [&](std::uint32_t s, std::uint32_t other) { setPredecessor(s, other); },
      [&](std::uint32_t s, std::uint32_t other) { setSuccessor(s, other); });
}

/// Adds the spokes at corner `q` of a cell: side q leaves it, the side before arrives.
template <unsigned q>
inline void Linking::addQuadrant(Fan& fan, const CellRecord& r) const {
  constexpr unsigned leaving = q, arriving = (q + 3) % kSides;
  const std::uint32_t* ids = r.ids();
  const unsigned leaves = r.touching >> leaving & 1u, arrives = r.touching >> (4 + arriving) & 1u;
  const auto first = [&](unsigned side) -> unsigned { return r.end[partOf(side) - 1]; };
  const auto last = [&](unsigned side) { return r.end[partOf(side)] - 1u; };
  const auto idIf = [ids](unsigned present, unsigned index) { return ids[index & (0u - present)]; };
  const Content& content = world_.catalogue.content(Grid::content(r));
  fan.add(idIf(leaves, runsForward(leaving) ? first(leaving) : last(leaving)), q * kStretch, 1, leaves);
  fan.addInterior(content, content.corners[q], ids, q);
  fan.add(idIf(arrives, runsForward(arriving) ? last(arriving) : first(arriving)), (q + 1) % 4 * kStretch, 0, arrives);
}

/// The corner where columns x - 1, x and rows y - 1, y meet. In the cell of quadrant q it is corner q.
void Linking::linkCorner(const Chunk& chunk, std::int32_t x, std::int32_t y) {
  const CellRecord *r0 = nullptr, *r1 = nullptr, *r2 = nullptr, *r3 = nullptr;
  if (x > 0 && x < kChunkSize && y > 0 && y < kChunkSize) {
    const std::uint32_t* cell = &chunk.cells[localOf({x, y})];
    r0 = grid_.recordOf(cell[0]);
    r1 = grid_.recordOf(cell[-1]);
    r2 = grid_.recordOf(cell[-1 - kChunkSize]);
    r3 = grid_.recordOf(cell[-kChunkSize]);
  } else {
    const auto recordAt = [&](std::int32_t cx, std::int32_t cy) {
      const CellAt at = cellAt(chunk, cx, cy);
      return at ? grid_.record(at) : nullptr;
    };
    r0 = recordAt(x, y);
    r1 = recordAt(x - 1, y);
    r2 = recordAt(x - 1, y - 1);
    r3 = recordAt(x, y - 1);
  }
  Fan fan(fan_);
  if (r0) addQuadrant<0>(fan, *r0);
  if (r1) addQuadrant<1>(fan, *r1);
  if (r2) addQuadrant<2>(fan, *r2);
  if (r3) addQuadrant<3>(fan, *r3);
  match(fan.spokes());
}

void Linking::linkSides(CellAt at) {
  const unsigned here = at.chunk->facts[at.local];
  const FactsAround around = factsAround(at);
  if (((here | around.south) & kRimPoints) != 0) linkSide(at, kSouth);
  if (((here | around.east) & kRimPoints) != 0) linkSide(at, kEast);
  if (((here | around.north) & kRimPoints) != 0) linkSide(at, kNorth);
  if (((here | around.west) & kRimPoints) != 0) linkSide(at, kWest);
}

/// Walks along one cell's side of a boundary, from vertex to vertex.
class Linking::SideWalk {
 public:
  SideWalk(const Linking& linking, CellAt at, unsigned side)
      : pool_(linking.pool_),
        content_(linking.world_.contentOf(at)),
        side_(side),
        points_(content_.sides[side].points) {
    const CellRecord* r = at ? linking.grid_.record(at) : nullptr;
    if (!r) return;
    interior_ = r->ids();
    ids_ = r->ids(partOf(side));
  }
  bool done() const { return points_.empty(); }
  std::int32_t next() const { return done() ? kUnitsPerCell : points_.front().at; }

  /// The segment that lies beyond the vertex (in the direction of increasing coordinates) or before it.
  void addSideSpokes(Fan& fan, std::int32_t vertex, bool beyond, std::uint32_t stretch) {
    while (!ids_.empty() && bounds(ids_.front()).second < vertex) ids_ = ids_.subspan(1);
    for (const std::uint32_t id : ids_.first(std::min<std::size_t>(ids_.size(), 2))) {
      const auto [low, high] = bounds(id);
      if ((beyond ? low : high) == vertex)
        fan.add(id, stretch * kStretch, along(side_, pool_[id].start()) == vertex ? 1 : 0, 1);
    }
  }
  void addInteriorSpokes(Fan& fan, std::int32_t vertex, std::uint32_t stretch) const {
    if (next() == vertex && interior_) fan.addInterior(content_, points_.front().spokes, interior_, stretch);
  }
  void pass(std::int32_t vertex) {
    if (next() == vertex) points_ = points_.subspan(1);
  }

 private:
  std::pair<std::int32_t, std::int32_t> bounds(std::uint32_t id) const {
    return std::minmax(along(side_, pool_[id].start()), along(side_, pool_[id].end()));
  }

  const SegmentPool& pool_;
  const Content& content_;
  unsigned side_;
  std::span<const RimPoint> points_;
  const std::uint32_t* interior_ = nullptr;
  std::span<const std::uint32_t> ids_;
};

/// All vertices in the open side of a cell.
void Linking::linkSide(CellAt at, unsigned side) {
  SideWalk mine(*this, at, side), theirs(*this, across(at, side), opposite(side));
  const bool forward = runsForward(side);
  while (!mine.done() || !theirs.done()) {
    const std::int32_t vertex = std::min(mine.next(), theirs.next());
    // Counter-clockwise from the direction in which my edges run: my half-edges, the other direction, theirs.
    Fan fan(fan_);
    mine.addSideSpokes(fan, vertex, forward, 0);
    theirs.addSideSpokes(fan, vertex, forward, 0);
    mine.addInteriorSpokes(fan, vertex, 0);
    mine.addSideSpokes(fan, vertex, !forward, 1);
    theirs.addSideSpokes(fan, vertex, !forward, 1);
    theirs.addInteriorSpokes(fan, vertex, 1);
    match(fan.spokes());
    mine.pass(vertex);
    theirs.pass(vertex);
  }
}

// A link can change without its ghost: another segment with the same far end. Then the segment is as it was (law 6).

// Most such segments are in one cell, where nothing has to be unpacked.
inline bool Linking::sameStart(const SegmentRecord& a, const SegmentRecord& b) const {
  if (a.cellRef == b.cellRef) return a.from == b.from && ((a.high ^ b.high) & 3u) == 0;
  return toWorld(grid_.cellOf(a.cellRef), a.start()) == toWorld(grid_.cellOf(b.cellRef), b.start());
}

inline bool Linking::sameEnd(const SegmentRecord& a, const SegmentRecord& b) const {
  if (a.cellRef == b.cellRef) return a.to == b.to && ((a.high ^ b.high) & 12u) == 0;
  return toWorld(grid_.cellOf(a.cellRef), a.end()) == toWorld(grid_.cellOf(b.cellRef), b.end());
}

// Out of the way of building, where no segment had a link before.
[[gnu::noinline]] void Linking::listIfAnotherStart(std::uint32_t id, std::uint32_t before, std::uint32_t now) {
  if (!before || !now || !sameStart(pool_[before], pool_[now])) list(id);
}

[[gnu::noinline]] void Linking::listIfAnotherEnd(std::uint32_t id, std::uint32_t before, std::uint32_t now) {
  if (!before || !now || !sameEnd(pool_[before], pool_[now])) list(id);
}

void Linking::list(std::uint32_t id) {
  SegmentRecord& s = pool_[id];
  if (s.listed) return;
  s.listed = 1;
  world_.changes.relinked.push_back({id});
}

}  // namespace lgs::detail
