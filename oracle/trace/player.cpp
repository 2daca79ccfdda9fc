#include "oracle/trace/player.h"

#include "oracle/trace/call_model.h"
#include "oracle/trace/choices.h"
#include "oracle/trace/detour.h"

#include <fmt/format.h>
#include <algorithm>

namespace lgs::oracle {
namespace {

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

Player::Player(PreservePairs preserve, Loads loads)
    : world_(relationOf(preserve)), preserve_(std::move(preserve)), loads_(loads) {}

tl::expected<void, TraceError> Player::apply(const Edit& edit) {
  Step step;
  step.door = doorOf(edit);
  step.edits = {&edit, 1};
  step.cells = {edit.polygon.cell, edit.polygon.cell};
  step.chance = chanceOf(edit.name);
  return apply(step);
}

tl::expected<void, TraceError> Player::apply(const Step& step) {
  brushed_ = {};
  auto done = step.isTrial ? Done() : leaveAndComeBack(step);
  if (done) done = wantsGroup(step.chance) ? inGroup(step) : make(step);
  if (done) {
    pending_ = true;
    chance_ = step.chance;
  } else {
    done.error().line = step.edits.front().line;
  }
  return done;
}

// What nobody may notice: the world is saved and loaded, edited wrongly and brought back, or keeps a mark for a while.
// Or chunks leave memory and come back: only if a commit is to follow, as they count as changed then.
Player::Done Player::leaveAndComeBack(const Step& step) {
  constexpr std::size_t kSmall = 200;  // polygons: it costs in proportion to the world
  const auto told = [](std::optional<std::string> complaint) -> Done {
    return complaint ? Done(wrong(std::move(*complaint))) : Done();
  };
  if (loads_ == Loads::sometimes && wantsSaving(step.chance) && !pending_ && placed_.polygons() <= kSmall) {
    ++detours_.saved;
    mark_.reset();  // it is not saved
    if (auto done = told(saveAndLoad(world_)); !done) return done;
  }
  if (mark_ && !pending_) {  // it has seen a commit
    if (!world_.forget(*mark_)) return wrong("a mark is forgotten too early");
    mark_.reset();
  }
  if (wantsMark(step.chance) && !mark_) {
    ++detours_.marked;
    mark_ = world_.checkpoint();
  }
  const Edit& first = step.edits.front();
  const Cell cell = isAlive(first.name) ? cellOf(first.name) : first.polygon.cell;
  if (!inRange(cell)) return {};
  if (wantsUnloading(step.chance) && pending_) {
    ++detours_.unloaded;
    if (auto done = told(unloadAndReload(world_, cell, step.chance)); !done) return done;
  }
  if (!wantsDetour(step.chance)) return {};
  ++detours_.undone;
  return told(editAndGoBack(world_, cell, step.chance));
}

Player::Done Player::inGroup(const Step& step) {
  ++detours_.grouped;
  Transaction group = world_.edit();
  auto done = make(step);
  group.keep();  // if the edit is refused, there is nothing to undo
  return done;
}

Player::Done Player::make(const Step& step) {
  if (step.door == Door::brush) return brush(step.edits.front());
  if (step.door == Door::setBlock) return setBlock(step);
  return step.adds().empty() ? remove(step) : add(step);
}

const Changes& Player::commit() {
  pending_ = false;
  switch (executor(chance_)) {
    case 0:
      return world_.commit();
    case 1:
      return world_.commit(Executor());
    default:
      return world_.commit(executorOf(executor(chance_) % 2 != 0));
  }
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

Player::Done Player::checkNames(const Step& step) const {
  for (const Edit& edit : step.removes()) {
    if (isAlive(edit.name)) continue;
    const auto lost = lost_.find(edit.name);
    const std::string why = lost == lost_.end() ? "" : "; a brush has changed it, and a changed polygon has no name";
    const std::string where = why.empty() || lost->second == 0 ? "" : fmt::format(" (line {})", lost->second);
    return wrong(fmt::format("there is no polygon named '{}' to remove{}{}", edit.name, why, where));
  }
  for (const Edit& edit : step.adds()) {
    const auto goes = [&](const Edit& remove) { return remove.name == edit.name; };
    if (isAlive(edit.name) && std::ranges::none_of(step.removes(), goes))
      return wrong(fmt::format("the name '{}' is in use; remove that polygon first, or choose another", edit.name));
  }
  return {};
}

Player::Done Player::remove(const Step& step) {
  if (auto done = checkNames(step); !done) return done;
  if (step.door == Door::clear) {
    const bool isOneCell = step.cells.min == step.cells.max && wantsOverload(step.chance);
    const auto count = isOneCell ? world_.clear(step.cells.min) : world_.clear(step.cells);
    if (!count) return refused(count.error());
    if (*count != step.edits.size())
      return wrong(fmt::format("clear() of {} polygons says that it removed {}", step.edits.size(), *count));
  } else if (auto done = world_.remove(handleOf(step.edits.front().name)); !done) {
    return refused(done.error());
  }
  for (const Edit& edit : step.edits) forget(edit.name);
  return {};
}

// The polygon keeps its handle, and gets the name of the add.
Player::Done Player::setBlock(const Step& step) {
  if (auto done = checkNames(step); !done) return done;
  const Edit &old = step.removes().front(), &next = step.adds().front();
  const PolygonHandle handle = handleOf(old.name);
  if (auto done = world_.setBlock(handle, next.polygon.block); !done) return refused(done.error());
  forget(old.name);
  if (find(next.polygon) != handle) return wrong("setBlock() does not give the polygon its block, or not only that");
  note(next, handle);
  return {};
}

void Player::note(const Edit& add, PolygonHandle handle) {
  lost_.erase(add.name);
  placed_.apply(add);
  handles_.emplace(add.name, handle);
}

void Player::forget(const std::string& name) {
  placed_.apply(Edit::remove(name));
  handles_.erase(name);
}

// Names the polygon that is overlapped: a reader of the trace knows names, and not the engine's handles.
tl::unexpected<TraceError> Player::refused(const Error& error) const {
  TraceError refusal{0, {}, error};
  for (const auto& [name, handle] : handles_) {
    if (error.code != ErrorCode::overlap || !error.other || handle != error.other) continue;
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
