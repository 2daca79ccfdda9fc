#include "linking.h"

#include "radial_match.h"
#include "wide_row.h"

#include <algorithm>

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
  explicit Fan(std::vector<Spoke>& spokes) : spokes_(spokes) { reserve(0); }

  /// Makes room for this many, and for all that sides can add.
  void reserve(std::size_t more) {
    if (spokes_.size() < count_ + more + 16) spokes_.resize(2 * (count_ + more + 16));
  }
  void add(std::uint32_t segment, std::uint32_t direction, bool outgoing, bool present = true) {
    spokes_[count_] = {segment, direction & kMaxDirection, outgoing};
    count_ += present;
  }
  void addInterior(const Content& content, SpokeRange range, const std::uint32_t* ids, std::uint32_t stretch) {
    const Spoke* spoke = content.spokes.data() + range.first;
    add(ids[spoke->segment], stretch * kStretch + 1 + spoke->direction, spoke->outgoing, range.count > 0);
    if (range.count <= 1) return;
    reserve(range.count);
    for (std::uint32_t k = 1; k < range.count; ++k)
      add(ids[spoke[k].segment], stretch * kStretch + 1 + spoke[k].direction, spoke[k].outgoing);
  }
  std::span<const Spoke> spokes() const { return {spokes_.data(), count_}; }

 private:
  std::vector<Spoke>& spokes_;
  std::size_t count_ = 0;
};

void Linking::linkChunk(const Chunk& chunk) {
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
    }
    forEachColumn(corners, [&](std::int32_t x) { linkCorner(chunk, x, y); });
  });
}

void Linking::linkInterior(CellAt at) {
  const InternedContent& content = contentOf(at);
  if ((content.facts & kLinkedInside) == 0) return;
  const std::span<const std::uint32_t> ids = grid_.record(at)->ids(kInterior);
  const auto idOf = [&](std::uint32_t k) { return k == InteriorSegment::kNone ? kNoSegment : ids[k]; };
  for (std::size_t k = 0; k < content.interior.size(); ++k) {
    const InteriorSegment& s = content.interior[k];
    if (s.predecessor != InteriorSegment::kRim) setPredecessor(ids[k], idOf(s.predecessor));
    if (s.successor != InteriorSegment::kRim) setSuccessor(ids[k], idOf(s.successor));
  }
}

void Linking::match(std::span<const Spoke> fan) {
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

/// The corner where columns x - 1, x and rows y - 1, y meet. In the cell of quadrant q it is corner q: side q leaves it
/// there, and the side before arrives.
void Linking::linkCorner(const Chunk& chunk, std::int32_t x, std::int32_t y) {
  constexpr std::array<std::int32_t, 4> dx{0, -1, -1, 0}, dy{0, 0, -1, -1};
  Fan fan(fan_);
  for (unsigned q = 0; q < 4; ++q) {
    const CellAt at = cellAt(chunk, x + dx[q], y + dy[q]);
    const CellRecord* r = at ? grid_.record(at) : nullptr;
    if (!r) continue;
    const std::uint32_t* ids = r->ids();
    const unsigned leaving = q, arriving = (q + 3) % kSides;
    const bool leaves = r->touching >> leaving & 1u, arrives = r->touching >> (4 + arriving) & 1u;
    const auto first = [&](unsigned side) { return r->end[partOf(side) - 1]; };
    const auto last = [&](unsigned side) { return r->end[partOf(side)] - 1u; };
    fan.add(ids[leaves ? (runsForward(leaving) ? first(leaving) : last(leaving)) : 0], q * kStretch, true, leaves);
    const Content& content = world_.catalogue.content(Grid::contentOf(r));
    fan.addInterior(content, content.corners[q], ids, q);
    fan.add(ids[arrives ? (runsForward(arriving) ? last(arriving) : first(arriving)) : 0], (q + 1) % 4 * kStretch,
            false, arrives);
  }
  match(fan.spokes());
}

void Linking::linkSides(CellAt at) {
  for (unsigned side = 0; side < kSides; ++side)
    if (((contentOf(at).facts | contentOf(across(at, side)).facts) & kRimPoints) != 0) linkSide(at, side);
}

/// Walks along one cell's side of a boundary, from vertex to vertex.
class Linking::SideWalk {
 public:
  SideWalk(const Linking& linking, CellAt at, unsigned side)
      : pool_(linking.pool_), content_(linking.contentOf(at)), side_(side), points_(content_.sides[side].points) {
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
      if ((beyond ? low : high) == vertex) fan.add(id, stretch * kStretch, along(side_, pool_[id].start()) == vertex);
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

void Linking::setPredecessor(std::uint32_t id, std::uint32_t now) {
  SegmentRecord& s = pool_[id];
  const std::uint32_t before = s.predecessor;
  if (before == now) return;
  s.predecessor = now;
  if (before != kUnlinked && (!before || !now || world_.startOf(before) != world_.startOf(now))) list(s, id);
}

void Linking::setSuccessor(std::uint32_t id, std::uint32_t now) {
  SegmentRecord& s = pool_[id];
  const std::uint32_t before = s.successor;
  if (before == now) return;
  s.successor = now & kUnlinked;
  if (before != kUnlinked && (!before || !now || world_.endOf(before) != world_.endOf(now))) list(s, id);
}

void Linking::list(SegmentRecord& segment, std::uint32_t id) {
  if (segment.listed) return;
  segment.listed = 1;
  world_.changes.relinked.push_back({id});
}

}  // namespace lgs::detail
