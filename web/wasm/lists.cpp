// Segments with their geometry, as arrays: of a commit, of a roll-back, of a rectangle.
#include "bridge.h"

#include <algorithm>

namespace lgs::web {
namespace {

template <class Real>
void putGeometry(const std::vector<RealSegment<Real>>& segments, std::vector<Real>& geometry) {
  constexpr Real kNone = std::numeric_limits<Real>::quiet_NaN();
  geometry.resize(8 * segments.size());
  Real* to = geometry.data();
  for (const auto& s : segments) {
    const RealPoint<Real> ghost1 = s.predecessor ? s.ghost1 : RealPoint<Real>{kNone, kNone};
    const RealPoint<Real> ghost2 = s.successor ? s.ghost2 : RealPoint<Real>{kNone, kNone};
    for (const RealPoint<Real> p : {s.start, s.end, ghost1, ghost2}) {
      *to++ = p.x;
      *to++ = p.y;
    }
  }
}

template <class Real>
void putOthers(const std::vector<RealSegment<Real>>& segments, Lists& lists) {
  const std::size_t count = segments.size();
  lists.blocks.resize(count);
  lists.cells.resize(count);
  lists.owners.resize(count);
  lists.predecessors.resize(count);
  lists.successors.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    lists.blocks[k] = segments[k].block;
    lists.cells[k] = segments[k].cell;
    lists.owners[k] = toNumber(segments[k].polygon);
    lists.predecessors[k] = segments[k].predecessor;
    lists.successors[k] = segments[k].successor;
  }
}

/// Reads the segments of all ids but the first `removed`, and tells where the arrays are.
const Lists::Header* listed(Bridge& bridge, Lists& lists, std::size_t removed, std::size_t added) {
  const auto alive = std::span(lists.ids).subspan(removed);
  const void* geometry = nullptr;
  const auto put = [&](auto& segments, auto& numbers) {
    segments.resize(alive.size());
    // The ids come from the world itself, and the origin is in range: it can not be refused.
    static_cast<void>(bridge.world.segments(alive, Point{}, std::span(segments)));
    putGeometry(segments, numbers);
    putOthers(segments, lists);
    geometry = numbers.data();
  };
  if (bridge.isFloat)
    put(bridge.floats, lists.geometryFloat);
  else
    put(bridge.doubles, lists.geometry);
  const auto count = [](std::size_t n) { return static_cast<std::uint32_t>(n); };
  lists.header = {.before = lists.header.before,
                  .after = lists.header.after,
                  .removed = count(removed),
                  .added = count(added),
                  .relinked = count(alive.size() - added),
                  .ids = lists.ids.data(),
                  .geometry = geometry,
                  .blocks = lists.blocks.data(),
                  .cells = lists.cells.data(),
                  .owners = lists.owners.data(),
                  .predecessors = lists.predecessors.data(),
                  .successors = lists.successors.data()};
  return &lists.header;
}

const Lists::Header* listed(Bridge& bridge, const Changes& changes) {
  Lists& lists = bridge.changes;
  lists.ids.clear();
  for (const auto* list : {&changes.removed, &changes.added, &changes.relinked})
    lists.ids.insert(lists.ids.end(), list->begin(), list->end());
  lists.header.before = changes.before;
  lists.header.after = changes.after;
  return listed(bridge, lists, changes.removed.size(), changes.added.size());
}

}  // namespace

LGS_EXPORT("commit") const Lists::Header* commit(Bridge* bridge) { return listed(*bridge, bridge->world.commit()); }

LGS_EXPORT("rollBack") const Lists::Header* rollBack(Bridge* bridge, std::uint64_t mark) {
  if (const auto done = bridge->world.rollBack(Mark{mark}); !done)
    return refused(done.error(), static_cast<const Lists::Header*>(nullptr));
  return listed(*bridge, bridge->world.changesOfRollBack());
}

LGS_EXPORT("segments") const Lists::Header* segments(Bridge* bridge) {
  bridge->segments.ids = bridge->world.segments();
  return listed(*bridge, bridge->segments, 0, bridge->segments.ids.size());
}

LGS_EXPORT("segmentsIn")
const Lists::Header* segmentsIn(Bridge* bridge, std::int32_t i0, std::int32_t j0, std::int32_t i1, std::int32_t j1) {
  bridge->segments.ids = bridge->world.segments(CellRect{{i0, j0}, {i1, j1}});
  return listed(*bridge, bridge->segments, 0, bridge->segments.ids.size());
}

}  // namespace lgs::web
