// Segments with their geometry, as arrays: of a commit, of a roll-back, of a rectangle.
#include "bridge.h"

#include <algorithm>

namespace lgs::web {
namespace {

template <class Real>
Real* putPoint(Real* to, RealPoint<Real> p) {
  *to++ = p.x;
  *to++ = p.y;
  return to;
}

/// In this order: owners, geometry, cells, ids (those that were removed first), blocks, predecessors, successors.
template <class Real>
void putArrays(Block64& block, std::span<const SegmentId> ids, const std::vector<RealSegment<Real>>& segments) {
  constexpr Real kNone = std::numeric_limits<Real>::quiet_NaN();
  const std::size_t count = segments.size();
  auto* owner = block.array<double>(count);
  auto* geometry = block.array<Real>(8 * count);
  auto* cell = block.array<Cell>(count);
  std::ranges::copy(ids, block.array<SegmentId>(ids.size()));
  auto* blocks = block.array<Block>(count);
  auto* predecessor = block.array<SegmentId>(count);
  auto* successor = block.array<SegmentId>(count);
  for (const auto& s : segments) {
    *owner++ = toNumber(s.polygon);
    geometry = putPoint(geometry, s.start);
    geometry = putPoint(geometry, s.end);
    geometry = putPoint(geometry, s.predecessor ? s.ghost1 : RealPoint<Real>{kNone, kNone});
    geometry = putPoint(geometry, s.successor ? s.ghost2 : RealPoint<Real>{kNone, kNone});
    *cell++ = s.cell;
    *blocks++ = s.block;
    *predecessor++ = s.predecessor;
    *successor++ = s.successor;
  }
}

/// Reads the segments of all ids but the first `removed`, and writes everything into a block.
template <class Real>
void putSegments(Block64& block, std::span<const SegmentId> ids, SegmentHead head, const World& world,
                 std::vector<RealSegment<Real>>& segments) {
  const std::size_t count = ids.size() - head.removed;
  segments.resize(count);
  // The ids come from the world itself, and the origin is in range: it can not be refused.
  static_cast<void>(world.segments(ids.subspan(head.removed), Point{}, std::span(segments)));
  const std::size_t each = sizeof(double) + 8 * sizeof(Real) + sizeof(Cell) + 3 * sizeof(std::uint32_t);
  const std::size_t bytes = sizeof(SegmentHead) + each * count + sizeof(SegmentId) * ids.size();
  head.words = static_cast<std::uint32_t>((bytes + 7) / 8);
  block.open(bytes);
  *block.array<SegmentHead>(1) = head;
  putArrays(block, ids, segments);
}

const std::uint64_t* listed(Bridge& bridge, Block64& block, std::span<const SegmentId> ids, const SegmentHead& head) {
  if (bridge.isFloat)
    putSegments(block, ids, head, bridge.world, bridge.floats);
  else
    putSegments(block, ids, head, bridge.world, bridge.doubles);
  return block.data();
}

std::uint32_t count(const std::vector<SegmentId>& ids) { return static_cast<std::uint32_t>(ids.size()); }

const std::uint64_t* listed(Bridge& bridge, const Changes& changes, bool isEdited) {
  bridge.last = &changes;
  bridge.isEdited = isEdited;
  bridge.isLastNews = changes.before != changes.after || !bridge.world.cellChanges().empty();
  if (bridge.isLastNews) ++bridge.moment;
  bridge.ids.clear();
  for (const auto* list : {&changes.removed, &changes.added, &changes.relinked})
    bridge.ids.insert(bridge.ids.end(), list->begin(), list->end());
  return listed(bridge, bridge.changes, bridge.ids,
                {static_cast<double>(changes.before), static_cast<double>(changes.after), count(changes.removed),
                 count(changes.added), count(changes.relinked), 0});
}

const std::uint64_t* listed(Bridge& bridge, const std::vector<SegmentId>& ids) {
  const auto version = static_cast<double>(bridge.world.version());
  return listed(bridge, bridge.segments, ids, {version, version, 0, count(ids), 0, 0});
}

}  // namespace

LGS_EXPORT("commit") const std::uint64_t* commit(Bridge* bridge) {
  return listed(*bridge, bridge->world.commit(), false);
}

// `way`: 0 rolls back, 1 rolls back and keeps what it undoes, 2 redoes.
LGS_EXPORT("roll") const std::uint64_t* roll(Bridge* bridge, double mark, std::int32_t way) {
  World& world = bridge->world;
  const auto done =
      way == 2 ? world.redo(markOf(mark)) : world.rollBack(markOf(mark), way == 1 ? Undone::keep : Undone::drop);
  if (!done) return refused(done.error(), static_cast<const std::uint64_t*>(nullptr));
  const bool isEdited = std::ranges::find(bridge->marksInEdits, markOf(mark)) != bridge->marksInEdits.end();
  return listed(*bridge, bridge->world.changesOfRollBack(), isEdited);
}

LGS_EXPORT("segments") const std::uint64_t* segments(Bridge* bridge) {
  return listed(*bridge, bridge->world.segments());
}

LGS_EXPORT("segmentsIn")
const std::uint64_t* segmentsIn(Bridge* bridge, std::int32_t i0, std::int32_t j0, std::int32_t i1, std::int32_t j1) {
  return listed(*bridge, bridge->world.segments(CellRect{{i0, j0}, {i1, j1}}));
}

}  // namespace lgs::web
