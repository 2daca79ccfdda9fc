// Shapes, edits, roll-back and redo.
#include "bridge.h"

namespace lgs::web {
namespace {

CellRect rect(std::int32_t i0, std::int32_t j0, std::int32_t i1, std::int32_t j1) { return {{i0, j0}, {i1, j1}}; }

/// What an edit came to, noted in its bridge.
template <class Result>
bool isDone(Bridge* bridge, const Expected<Result>& result) {
  if (result) bridge->isEdited = true;
  return result.has_value();
}
double orZero(Bridge* bridge, const Expected<PolygonHandle>& handle) {
  return isDone(bridge, handle) ? toNumber(*handle) : refused(handle.error(), 0.0);
}
std::int32_t orZero(Bridge* bridge, const Expected<void>& done) {
  return isDone(bridge, done) ? 1 : refused(done.error(), 0);
}
double orMinusOne(Bridge* bridge, const Expected<std::uint64_t>& count) {
  return isDone(bridge, count) ? static_cast<double>(*count) : refused(count.error(), -1.0);
}

}  // namespace

/// The vertices are in the input.
LGS_EXPORT("shape") std::uint32_t shape(Bridge* bridge, std::size_t vertices) {
  const auto made = bridge->world.shape(inputPoints(vertices));
  return made ? bridge->shapes.number(*made) : refused(made.error(), 0u);
}

/// The number of the shape that is the world's so and so manyth, which need not be there.
LGS_EXPORT("shapeNumber") std::uint32_t shapeNumber(Bridge* bridge, std::uint32_t shape) {
  return bridge->shapes.number({shape});
}

LGS_EXPORT("add") double add(Bridge* bridge, std::int32_t i, std::int32_t j, std::uint32_t shape, Block block) {
  return orZero(bridge, bridge->world.add({i, j}, bridge->shapes.shape(shape), block));
}

/// Four integers an entry are in the input: i, j, shape, block. The answer has the handles.
LGS_EXPORT("addMany") std::int32_t addMany(Bridge* bridge, std::size_t entries) {
  const auto numbers = input<std::int32_t>(4 * entries);
  std::vector<Placement> placements;
  placements.reserve(entries);
  for (std::size_t k = 0; k < numbers.size(); k += 4)
    placements.push_back({.cell = {numbers[k], numbers[k + 1]},
                          .shape = bridge->shapes.shape(static_cast<std::uint32_t>(numbers[k + 2])),
                          .block = static_cast<Block>(numbers[k + 3])});
  std::vector<PolygonHandle> handles(entries);
  if (const auto done = bridge->world.addMany(placements, handles); !isDone(bridge, done))
    return refused(done.error(), 0);
  answer().clear();
  for (const PolygonHandle handle : handles) answer().push_back(toNumber(handle));
  return 1;
}

/// The vertices are in the input.
LGS_EXPORT("addPolygon")
double addPolygon(Bridge* bridge, std::int32_t i, std::int32_t j, std::size_t vertices, Block block) {
  return orZero(bridge, bridge->world.add({i, j}, inputPoints(vertices), block));
}

LGS_EXPORT("remove") std::int32_t remove(Bridge* bridge, double polygon) {
  return orZero(bridge, bridge->world.remove(toHandle(polygon)));
}

/// The handles are in the input.
LGS_EXPORT("removeMany") std::int32_t removeMany(Bridge* bridge, std::size_t count) {
  std::vector<PolygonHandle> handles;
  handles.reserve(count);
  for (const double number : input<double>(count)) handles.push_back(toHandle(number));
  return orZero(bridge, bridge->world.removeMany(handles));
}

LGS_EXPORT("replace") double replace(Bridge* bridge, std::int32_t i, std::int32_t j, std::uint32_t shape, Block block) {
  return orZero(bridge, bridge->world.replace({i, j}, bridge->shapes.shape(shape), block));
}

LGS_EXPORT("setBlock") std::int32_t setBlock(Bridge* bridge, double polygon, Block block) {
  return orZero(bridge, bridge->world.setBlock(toHandle(polygon), block));
}

LGS_EXPORT("fill")
double fill(Bridge* bridge, std::int32_t i0, std::int32_t j0, std::int32_t i1, std::int32_t j1, std::uint32_t shape,
            Block block) {
  return orMinusOne(bridge, bridge->world.fill(rect(i0, j0, i1, j1), bridge->shapes.shape(shape), block));
}

LGS_EXPORT("clear") double clear(Bridge* bridge, std::int32_t i0, std::int32_t j0, std::int32_t i1, std::int32_t j1) {
  return orMinusOne(bridge, bridge->world.clear(rect(i0, j0, i1, j1)));
}

/// A group of edits begins, when none waits for its commit. 0 ends it: its edits are undone; 1: they stay.
LGS_EXPORT("beginGroup") void beginGroup(Bridge* bridge) { bridge->group.emplace(bridge->world); }
LGS_EXPORT("endGroup") void endGroup(Bridge* bridge, std::int32_t keep) {
  if (keep != 0)
    bridge->group->keep();
  else
    bridge->isEdited = false;
  bridge->group.reset();
}

LGS_EXPORT("mark") double mark(Bridge* bridge) {
  const Mark mark = bridge->world.mark();
  if (bridge->isEdited) bridge->marksInEdits.push_back(mark);
  return static_cast<double>(mark.value);
}
LGS_EXPORT("forget") std::int32_t forget(Bridge* bridge, double mark) {
  const auto done = bridge->world.forget(markOf(mark));
  if (!done) return refused(done.error(), 0);
  std::erase(bridge->marksInEdits, markOf(mark));
  return 1;
}

}  // namespace lgs::web
