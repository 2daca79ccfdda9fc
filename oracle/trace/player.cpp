#include "oracle/trace/player.h"

#include <fmt/format.h>
#include <algorithm>

namespace lgs::oracle {
namespace {

PreserveRelation relationOf(const PreservePairs& pairs) {
  if (pairs.empty()) return {};
  return [pairs](Block a, Block b) { return pairs(a, b); };
}

tl::unexpected<TraceError> wrong(std::string text) { return tl::unexpected(TraceError{0, std::move(text), {}}); }

// The player uses the upper half of a step's chance; steps.cpp uses the lower half.
unsigned bits(std::uint64_t chance, unsigned first, unsigned count) {
  return static_cast<unsigned>(chance >> first) & ((1U << count) - 1);
}

template <class Real>
std::vector<RealPoint<Real>> realPoints(const std::vector<LocalPoint>& vertices, double off) {
  std::vector<RealPoint<Real>> points;
  points.reserve(vertices.size());
  for (const LocalPoint& p : vertices)
    points.push_back({static_cast<Real>((p.x + off) / kUnitsPerCell), static_cast<Real>((p.y - off) / kUnitsPerCell)});
  return points;
}

// Runs the jobs from the last to the first; with `apart` the even ones, then the odd ones.
Executor executorOf(bool apart) {
  return [apart](std::size_t count, const std::function<void(std::size_t)>& job) {
    for (std::size_t k = count; k-- > 0;)
      if (!apart || k % 2 == 0) job(k);
    for (std::size_t k = 0; k < count; ++k)
      if (apart && k % 2 != 0) job(k);
  };
}

}  // namespace

Player::Player(PreservePairs preserve) : world_(relationOf(preserve)) { scene_.preserve = std::move(preserve); }

tl::expected<void, TraceError> Player::apply(const Edit& edit) {
  Step step;
  step.door = doorOf(edit);
  step.edits = {&edit, 1};
  step.cells = {edit.polygon.cell, edit.polygon.cell};
  step.chance = chanceOf(edit.name);
  return apply(step);
}

tl::expected<void, TraceError> Player::apply(const Step& step) {
  auto done = step.edits.front().kind == Edit::Kind::add ? add(step) : remove(step);
  if (done) {
    pending_ = true;
    chance_ = step.chance;
  } else {
    done.error().line = step.edits.front().line;
  }
  return done;
}

const Changes& Player::commit() {
  pending_ = false;
  switch (bits(chance_, 40, 2)) {
    case 0:
      return world_.commit();
    case 1:
      return world_.commit(Executor());
    default:
      return world_.commit(executorOf(bits(chance_, 40, 1) != 0));
  }
}

Player::Done Player::add(const Step& step) {
  for (const Edit& edit : step.edits) {
    if (!isAlive(edit.name)) continue;
    return wrong(fmt::format("the name '{}' is in use; remove that polygon first, or choose another", edit.name));
  }
  if (auto done = wear(step.edits.front().polygon.cell, step.worn); !done) return done;
  const Handles handles = call(step);
  if (!handles) return tl::unexpected(handles.error());
  for (std::size_t k = 0; k < step.edits.size(); ++k) {
    const auto& [kind, name, polygon, line] = step.edits[k];
    const PolygonHandle handle = find(polygon);
    if (!handle) return wrong(fmt::format("{}: '{}' is accepted, but not in its cell", describe(step.door), name));
    if (k < handles->size() && (*handles)[k] != handle)
      return wrong(fmt::format("{}: the handle of '{}' is another polygon's", describe(step.door), name));
    placed_.emplace(name, Placed{handle, names_.size()});
    names_.push_back(name);
    scene_.polygons.push_back(polygon);
  }
  return {};
}

// Returns the handles that the call gives, in the order of the edits. Some calls give only the first, and fill() gives
// none.
Player::Handles Player::call(const Step& step) {
  switch (step.door) {
    case Door::points:
    case Door::floats:
    case Door::doubles:
      return addByPoints(step);
    case Door::shape:
    case Door::handles:
    case Door::several:
      return addByShape(step);
    default:
      return fill(step);
  }
}

Player::Handles Player::addByPoints(const Step& step) {
  const auto& [cell, block, vertices] = step.edits.front().polygon;
  constexpr std::array kOff{0.0, 0.25, -0.25, 0.49};  // rounded, all are the same
  Expected<PolygonHandle> handle;
  if (step.door == Door::points) {
    handle = world_.add(cell, std::span<const LocalPoint>(vertices), block);
  } else if (step.door == Door::floats) {
    const std::vector<FloatPoint> points = realPoints<float>(vertices, 0);
    handle = world_.add(cell, std::span<const FloatPoint>(points), block);
  } else {
    const std::vector<DoublePoint> points = realPoints<double>(vertices, kOff[bits(step.chance, 32, 2)]);
    handle = world_.add(cell, std::span<const DoublePoint>(points), block);
  }
  if (!handle) return refused(handle.error());
  return std::vector{*handle};
}

Player::Handles Player::addByShape(const Step& step) {
  const auto& [cell, block, vertices] = step.edits.front().polygon;
  Shape polygons;
  for (const Edit& edit : step.edits) polygons.push_back(edit.polygon.vertices);
  const bool isOne = polygons.size() == 1;
  const auto made = isOne ? world_.shape(std::span<const LocalPoint>(vertices)) : world_.shape(polygons);
  const auto shape = checked(made, polygons, cell);
  if (!shape) return tl::unexpected(shape.error());
  const unsigned room = step.door == Door::shape ? 0 : bits(step.chance, 34, 2);
  if (room == 0) {
    const auto handle = world_.add(cell, *shape, block);
    if (!handle) return refused(handle.error());
    return std::vector{*handle};
  }
  // There is room for all handles, for one fewer, or for one more. The last one must then stay as it is.
  constexpr PolygonHandle kUntouched{7, 7};
  std::vector<PolygonHandle> handles(polygons.size() + room - 2, kUntouched);
  const auto handle = world_.add(cell, *shape, block, handles);
  if (!handle) return refused(handle.error());
  if (!handles.empty() && handles.front() != *handle) return wrong("add() returns another handle than its first one");
  if (handles.size() > polygons.size() && handles.back() != kUntouched)
    return wrong("add() writes more handles than there are polygons");
  handles.resize(std::min(handles.size(), polygons.size()));
  return handles;
}

Player::Handles Player::fill(const Step& step) {
  const auto& [cell, block, vertices] = step.edits.front().polygon;
  Shape polygons;
  for (const Edit& edit : step.edits.first(step.inCell)) polygons.push_back(edit.polygon.vertices);
  const auto shape = checked(world_.shape(polygons), polygons, cell);
  if (!shape) return tl::unexpected(shape.error());
  const auto filled = world_.fill(step.cells, *shape, block);
  if (!filled) return refused(filled.error());
  const std::size_t cells = step.edits.size() / step.inCell;
  if (*filled != cells) return wrong(fmt::format("fill() of {} cells says that it filled {}", cells, *filled));
  return std::vector<PolygonHandle>();
}

// A shape always gets the same id, and no two shapes get one id.
tl::expected<ShapeId, TraceError> Player::checked(const Expected<ShapeId>& id, const Shape& shape, Cell cell) {
  if (!id) {
    TraceError error = refused(id.error()).value();
    Error inCell = id.error();
    inCell.cell = cell;
    error.text = message(inCell);
    return tl::unexpected(std::move(error));
  }
  const auto [made, isNew] = shapes_.emplace(shape, *id);
  if (made->second != *id || shapeIds_.insert(*id).second != isNew)
    return wrong("shape() gives a shape another id, or two shapes one");
  return *id;
}

Player::Done Player::wear(Cell cell, unsigned times) {
  if (times == 0) return {};
  const auto square = checked(world_.shape(kUnitSquare), {{kUnitSquare.begin(), kUnitSquare.end()}}, cell);
  if (!square) return tl::unexpected(square.error());
  for (; times > 0; --times) {
    const auto handle = world_.add(cell, *square, times);
    if (!handle) return refused(handle.error());
    if (const auto gone = world_.remove(*handle); !gone) return refused(gone.error());
  }
  return {};
}

// No two polygons of a cell have equal vertices, so the vertices tell which one it is.
PolygonHandle Player::find(const ScenePolygon& polygon) const {
  for (const PlacedPolygon& placed : world_.polygons(polygon.cell)) {
    if (placed.block == polygon.block && std::ranges::equal(placed.vertices, polygon.vertices)) return placed.handle;
  }
  return {};
}

Player::Done Player::remove(const Step& step) {
  for (const Edit& edit : step.edits) {
    if (!isAlive(edit.name)) return wrong(fmt::format("there is no polygon named '{}' to remove", edit.name));
  }
  if (step.door == Door::clear) {
    const auto count = world_.clear(step.cells);
    if (!count) return refused(count.error());
    if (*count != step.edits.size())
      return wrong(fmt::format("clear() of {} polygons says that it removed {}", step.edits.size(), *count));
  } else if (const auto done = world_.remove(handleOf(step.edits.front().name)); !done) {
    return refused(done.error());
  }
  for (const Edit& edit : step.edits) forget(edit.name);
  return {};
}

// The last polygon of the scene takes the place of the one that goes.
void Player::forget(const std::string& name) {
  const auto found = placed_.find(name);
  const std::size_t hole = found->second.index;
  placed_.erase(found);
  if (hole + 1 < names_.size()) {
    placed_.at(names_.back()).index = hole;
    names_[hole] = std::move(names_.back());
    scene_.polygons[hole] = std::move(scene_.polygons.back());
  }
  names_.pop_back();
  scene_.polygons.pop_back();
}

// Names the polygon that is overlapped: a reader of the trace knows names, and not the engine's handles.
tl::unexpected<TraceError> Player::refused(const Error& error) const {
  TraceError refusal{0, {}, error};
  for (const auto& [name, placed] : placed_) {
    if (error.code != ErrorCode::overlap || !error.other || placed.handle != error.other) continue;
    refusal.text = fmt::format("cell ({}, {}): its interior overlaps '{}'", error.cell.i, error.cell.j, name);
    return tl::unexpected(std::move(refusal));
  }
  Error ofOne = error;
  ofOne.polygon = -1;
  refusal.text = message(ofOne);
  return tl::unexpected(std::move(refusal));
}

tl::expected<void, TraceError> play(const Trace& trace, Player& player, const CommitCallback& afterCommit) {
  const auto commit = [&] {
    const Changes& changes = player.commit();
    return !afterCommit || afterCommit(player, changes);
  };
  for (const Edit& edit : trace.edits) {
    if (edit.kind == Edit::Kind::commit) {
      if (!commit()) return {};
    } else if (auto done = player.apply(edit); !done) {
      return done;
    }
  }
  if (player.pending()) commit();
  return {};
}

}  // namespace lgs::oracle
