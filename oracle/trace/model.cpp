#include "oracle/trace/model.h"

#include <algorithm>
#include <utility>

namespace lgs::oracle {

using Kind = Call::Kind;

std::vector<Cell> Model::cellsOf(const CellRect& rect) {
  std::vector<Cell> cells;
  if (isEmpty(rect)) return cells;  // it may have any number of rows
  for (std::int32_t j = rect.min.j; j <= rect.max.j; ++j)
    for (std::int32_t i = rect.min.i; i <= rect.max.i; ++i) cells.push_back({i, j});
  return cells;
}

PreserveRelation relationOf(const PreservePairs& pairs) {
  if (pairs.empty()) return {};
  return [pairs](Block a, Block b) { return pairs(a, b); };
}

Call Model::resolved(const Call& call) const {
  using enum Named::How;
  if (call.goes.empty() && call.kind != Kind::put) return call;
  Call out = call;
  if (call.kind == Kind::put) out.comes = comingOf(call);
  out.goes.clear();
  const auto put = [&](PolygonHandle at, std::string of) {
    out.goes.push_back({.how = handle, .handle = at, .name = std::move(of)});
  };
  const auto putPlaced = [&](const Standing::Placed& p) { put(p.handle, p.name); };
  for (const Named& named : call.goes) {
    if (named.how == standing || named.how == all) {
      const auto& there = now_.standing.in(named.cell);
      if (named.how == all)
        std::ranges::for_each(there, putPlaced);
      else
        there.empty() ? put({}, "") : putPlaced(there[named.nth % there.size()]);
    } else if (named.how == given || named.how == beside) {
      Given one = now_.given.empty() ? Given{} : now_.given[named.nth % now_.given.size()];
      if (named.how == beside) one.handle.serial += 1 + named.nth % Caller::kFar;
      if (named.how == beside || one.handle || !isAlive(one.name)) one.name.clear();  // its handle says what it is now
      put(one.handle, one.name);
    } else if (named.how == Named::How::name && isAlive(named.name)) {
      put(now_.standing.handleOf(named.name), named.name);
    } else {
      out.goes.push_back(named);
    }
    if (out.goes.empty()) continue;
    Named& last = out.goes.back();
    const std::string* const known = last.handle ? now_.standing.nameOf(last.handle) : nullptr;
    if (known != nullptr) last.name = *known;
  }
  return out;
}

void Model::add(const std::string& name, ScenePolygon polygon, PolygonHandle handle) {
  now_.pending = Pending::sure;
  now_.chunks.insert(chunkOf(polygon.cell));
  now_.given.push_back({name, handle});
  now_.standing.add(name, std::move(polygon), handle);
}

void Model::place(Cell cell, const Coming& coming, std::span<const PolygonHandle> handles) {
  for (std::size_t k = 0; k < coming.shape.size(); ++k)
    add(k < coming.names.size() ? coming.names[k] : freshName(), {cell, coming.block, coming.shape[k]},
        handles.empty() ? PolygonHandle{} : handles[k]);
}

void Model::clear(const CellRect& cells) {
  std::vector<Cell> gone;
  for (const auto& entry : now_.standing.cells())
    if (contains(cells, entry.first)) gone.push_back(entry.first);
  for (const Cell cell : gone) now_.standing.take(cell);
  if (!gone.empty()) now_.pending = Pending::sure;
}

void Model::apply(const Call& call, const Outcome* outcome, const World* world) {
  std::span<const PolygonHandle> handles;
  if (outcome != nullptr) handles = outcome->handles;
  const auto next = [&](Cell cell, const Coming& coming) {
    place(cell, coming, handles);
    if (!handles.empty()) handles = handles.subspan(coming.shape.size());
  };
  // What changes nothing may count as an edit, or not.
  const bool mayBeNone = !isEdit(call.kind) || call.kind == Kind::shape || call.kind == Kind::setBlock ||
                         (call.comes.empty() && call.goes.empty()) || (call.kind == Kind::fill && isEmpty(call.cells));
  if (!movesInTime(call.kind)) isPending(mayBeNone ? Pending::maybe : Pending::sure);
  if (!movesInTime(call.kind) && !isOfMemory(call.kind)) timeline_.happened(mayBeNone ? Redo::maybe : Redo::no);
  switch (call.kind) {
    case Kind::setBlock:
      return recolour(call.goes[0].name, call.comes[0].block);
    case Kind::clear:
      return clear(call.cells);
    case Kind::fill:
      for (const Cell cell : cellsOf(call.cells)) next(cell, call.comes[0]);
      return;
    case Kind::shape:
    case Kind::copy:
    case Kind::brush:
    case Kind::group:
    case Kind::repeat:
    case Kind::follow:
    case Kind::foresee:
      return;
    case Kind::take:
      return take(call, outcome);
    case Kind::commit:
      now_.pending = Pending::no;
      now_.alone.clear();
      for (const auto& entry : now_.away)
        if (!isBesideLoaded(entry.first)) now_.alone.insert(entry.first);
      return;
    case Kind::leave:
      for (const Cell chunk : leaving(call.cells)) {
        if (stays(chunk, world)) continue;
        hasForgotten_ = true;
        now_.chunks.erase(chunk);
        now_.away.erase(chunk);
      }
      return;
    case Kind::unload:
      return unload(call.cells);
    case Kind::reload:
      for (const Cell chunk : comingBack(call.cells)) reload(chunk, world);
      return;
    case Kind::reloadEmpty:
      for (const Cell chunk : chunksWithin(call.cells, false)) empty(chunk);
      return;
    case Kind::mark:
      return timeline_.mark(now_);
    case Kind::rollBack:
      if (hasMarks()) goTo(timeline_.back(call.nth, call.keeps != Call::Keeps::never));
      return;
    case Kind::redo:
      if (hasAhead()) goTo(timeline_.forward(call.nth));
      return;
    case Kind::forget:
      if (hasMarks()) timeline_.forget(call.nth);
      return;
    case Kind::load:
      now_.pending = Pending::no;
      return timeline_.clear();
    case Kind::replace:
      clear({call.comes[0].cell, call.comes[0].cell});
      break;
    default:
      break;
  }
  for (const Named& named : call.goes) now_.standing.remove(named.name);
  for (const Coming& coming : call.comes) next(call.kind == Kind::exchange ? call.cells.min : coming.cell, coming);
}

bool Model::play(const Call& call) {
  if (call.kind == Kind::repeat) {
    for (std::uint32_t k = 0; k < call.nth; ++k)
      for (const Call& part : call.group) play(part);
    return true;
  }
  if (call.kind == Kind::group || call.kind == Kind::foresee) {
    if (call.kind == Kind::foresee) apply(Call::commit());
    const State before = now_;
    const Redo redo = timeline_.redo();
    bool keeps = call.kind == Kind::group && call.keeps != Call::Keeps::never;
    for (const Call& part : call.group) {
      if (play(part) || call.keeps != Call::Keeps::ifAll) continue;
      keeps = false;
      break;
    }
    if (!keeps) restore(before, redo);
    return true;
  }
  const Call made = resolved(call);
  const bool isAccepted = judgeResolved(made).accepted;
  if (isAccepted) apply(made);
  return isAccepted;
}

Scene Model::scene(PreservePairs preserve) const {
  Scene scene{standing().polygonsOfAll(), std::move(preserve)};
  for (const auto& [chunk, content] : now_.away)
    for (const auto& [cell, there] : content)
      for (const Standing::Placed& p : there) scene.polygons.push_back({cell, p.block, p.vertices});
  return scene;
}

Trace withoutRefused(const Trace& trace) {
  Model model;
  Trace accepted{trace.preserve, {}};
  for (const Call& call : trace.calls)
    if (call.kind == Kind::brush ? model.judge(call).accepted : model.play(call)) accepted.calls.push_back(call);
  return accepted;
}

}  // namespace lgs::oracle
