// The ways in which a player adds polygons.
#include "oracle/trace/choices.h"
#include "oracle/trace/player.h"

#include <fmt/format.h>
#include <algorithm>

namespace lgs::oracle {

Player::Done Player::add(const Step& step) {
  if (auto done = checkNames(step); !done) return done;
  if (auto done = wear(step.adds().front().polygon.cell, step.worn); !done) return done;
  const Block block = step.adds().front().polygon.block;
  const Block first = wantsOtherBlock(step.chance) ? block ^ 1U : block;
  const Handles handles = call(step, first);
  if (!handles) return tl::unexpected(handles.error());
  for (const Edit& edit : step.removes()) forget(edit.name);
  for (std::size_t k = 0; k < step.adds().size(); ++k) {
    const Edit& edit = step.adds()[k];
    if (first != block) {
      ++detours_.repainted;
      const auto done = world_.setBlock(find({edit.polygon.cell, first, edit.polygon.vertices}), block);
      if (!done) return refused(done.error());
    }
    const PolygonHandle handle = find(edit.polygon);
    if (!handle) return wrong(fmt::format("{}: '{}' is accepted, but not in its cell", describe(step.door), edit.name));
    if (k < handles->size() && (*handles)[k] != handle)
      return wrong(fmt::format("{}: the handle of '{}' is another polygon's", describe(step.door), edit.name));
    note(edit, handle);
  }
  return {};
}

// Returns the handles that the call gives, in the order of the adds. Some calls give only the first, and fill() gives
// none.
Player::Handles Player::call(const Step& step, Block block) {
  switch (step.door) {
    case Door::points:
    case Door::floats:
    case Door::doubles:
      return addByPoints(step, block);
    case Door::fill:
      return fill(step, block);
    default:
      return addByShape(step, block);
  }
}

Player::Handles Player::addByPoints(const Step& step, Block block) {
  const ScenePolygon& polygon = step.edits.front().polygon;
  const Notation plain = wantsOverload(step.chance) ? Notation::list : Notation::lattice;
  const Notation notation = step.door == Door::floats    ? Notation::floats
                            : step.door == Door::doubles ? Notation::doubles
                                                         : plain;
  const auto handle = inNotation(polygon.vertices, notation, offset(step.chance),
                                 [&](auto points) { return world_.add(polygon.cell, points, block); });
  if (!handle) return refused(handle.error());
  return std::vector{*handle};
}

Player::Handles Player::addByShape(const Step& step, Block block) {
  const Cell cell = step.adds().front().polygon.cell;
  Shape polygons;
  for (const Edit& edit : step.adds()) polygons.push_back(edit.polygon.vertices);
  const auto shape = checked(made(polygons, step.chance), polygons, cell);
  if (!shape) return tl::unexpected(shape.error());
  const bool replaces = step.door == Door::replace;
  const unsigned room = step.door == Door::shape ? 0 : roomForHandles(step.chance);
  if (room == 0) {
    const auto handle = replaces ? world_.replace(cell, *shape, block) : world_.add(cell, *shape, block);
    if (!handle) return refused(handle.error());
    return std::vector{*handle};
  }
  // There is room for all handles, for one fewer, or for one more. The last one must then stay as it is.
  constexpr PolygonHandle kUntouched{7, 7};
  std::vector<PolygonHandle> handles(polygons.size() + room - 2, kUntouched);
  const auto handle =
      replaces ? world_.replace(cell, *shape, block, handles) : world_.add(cell, *shape, block, handles);
  if (!handle) return refused(handle.error());
  if (!handles.empty() && handles.front() != *handle)
    return wrong(fmt::format("{}() returns another handle than its first one", replaces ? "replace" : "add"));
  if (handles.size() > polygons.size() && handles.back() != kUntouched)
    return wrong(fmt::format("{}() writes more handles than there are polygons", replaces ? "replace" : "add"));
  handles.resize(std::min(handles.size(), polygons.size()));
  return handles;
}

Player::Handles Player::fill(const Step& step, Block block) {
  Shape polygons;
  for (const Edit& edit : step.edits.first(step.inCell)) polygons.push_back(edit.polygon.vertices);
  const auto shape = checked(world_.shape(polygons), polygons, step.edits.front().polygon.cell);
  if (!shape) return tl::unexpected(shape.error());
  const auto filled = world_.fill(step.cells, *shape, block);
  if (!filled) return refused(filled.error());
  const std::size_t cells = step.edits.size() / step.inCell;
  if (*filled != cells) return wrong(fmt::format("fill() of {} cells says that it filled {}", cells, *filled));
  return std::vector<PolygonHandle>();
}

Expected<ShapeId> Player::made(const Shape& polygons, std::uint64_t chance) {
  if (polygons.size() != 1 || wantsOverload(chance)) return world_.shape(polygons);
  return inNotation(polygons[0], notationOf(chance), offset(chance),
                    [this](auto points) { return world_.shape(points); });
}

}  // namespace lgs::oracle
