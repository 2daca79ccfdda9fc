// Calls that move in time, or take ground out of the world, or say what would be: what the caller was given goes along.
#include "oracle/calls/caller.h"
#include "oracle/calls/shapes.h"

#include <algorithm>
#include <utility>

namespace lgs::oracle {

bool Caller::makeGroup(const Call& call, const std::function<bool(const Call&)>& make) {
  const std::size_t before = given.size(), taken = bodies.size();
  Transaction edits = world.edit();
  bool keeps = call.keeps != Call::Keeps::never;
  for (const Call& part : call.group) {
    if (make(part) || call.keeps != Call::Keeps::ifAll) continue;
    keeps = false;
    break;
  }
  if (keeps) {
    edits.keep();
  } else {
    given.resize(before);
    bodies.resize(taken);
  }
  return keeps;
}

void Caller::rollBack(const Call& call, Outcome& out) {
  const bool keeps = call.keeps != Call::Keeps::never;
  const auto done = world.rollBack(timeline_.at(call.nth).mark, keeps ? Undone::keep : Undone::drop);
  if (!done) return void(out.refusal = done.error());
  changes = &world.changesOfRollBack();
  out.changes = copyOf(*changes);
  remember(timeline_.back(call.nth, keeps));
}

void Caller::redo(const Call& call, Outcome& out) {
  const auto done = world.redo(timeline_.ahead(call.nth).mark);
  if (!done) return void(out.refusal = done.error());
  changes = &world.changesOfRollBack();
  out.changes = copyOf(*changes);
  remember(timeline_.forward(call.nth));
}

void Caller::remember(const Remembered& moment) {
  given = moment.given;
  bodies = moment.bodies;
}

void Caller::foresee(const Call& call, Outcome& out, const std::function<void(const Call&)>& make) {
  changes = &world.commit();
  out.changes = copyOf(*changes);
  const std::size_t before = given.size(), taken = bodies.size();
  Islands islands(world, isAnchorOfView);
  out.foreseen = lgs::foresee(world, islands, [&](World&) {
    for (const Call& part : call.group) make(part);
    return true;
  });
  out.count = islands.all().size();
  given.resize(before);
  bodies.resize(taken);
  timeline_.happened(Redo::maybe);
}

void Caller::take(const Call& call, Outcome& out) {
  const bool isOpen = (call.nth & Call::kOpen) != 0;
  const Islands islands(world, {}, isOpen ? AtEdge::open : AtEdge::holds);
  const IslandId island = islands.of(world, call.goes[0].handle);
  if ((call.nth & Call::kApart) != 0) {
    auto apart = takeApart(world, islands, island);
    if (!apart) return void(out.refusal = apart.error());
    out.bodies = std::move(*apart);
  } else {
    auto body = lgs::take(world, islands, island);
    if (!body) return void(out.refusal = body.error());
    out.bodies.push_back(std::move(*body));
  }
  bodies.insert(bodies.end(), out.bodies.begin(), out.bodies.end());
}

void Caller::putBack(const Call& call, Outcome& out) {
  const Body body = bodies.empty() ? Body() : laid(bodies[call.nth % bodies.size()], call.lies);
  auto placed = put(world, body, body.origin);
  if (!placed) return void(out.refusal = placed.error());
  out.told = std::move(*placed);
  for (std::size_t first = 0, k = 0; k < body.polygons.size(); first = k) {  // those of a cell come one after the other
    const Cell cell = body.polygons[first].cell;
    while (k < body.polygons.size() && body.polygons[k].cell == cell) ++k;
    keepLast({body.origin.i + cell.i, body.origin.j + cell.j}, k - first, out);
  }
}

Body laid(Body body, const Lies& lies) {
  const auto sum = [](std::int32_t a, std::int32_t b) {
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(std::int64_t{a} + b, INT32_MIN, INT32_MAX));
  };
  body.origin = {sum(body.origin.i, lies.by.i), sum(body.origin.j, lies.by.j)};
  const auto turn = static_cast<int>(lies.symmetry);
  for (BodyPolygon& p : body.polygons) {
    p.vertices = turned(p.vertices, turn);
    if ((turn & 1) != 0) p.cell.i = -p.cell.i;
    if ((turn & 2) != 0) p.cell.j = -p.cell.j;
    if ((turn & 4) != 0) std::swap(p.cell.i, p.cell.j);
  }
  return body;
}

bool isAnchorOfView(Block block, Cell cell) { return block % 3 == 1 || (std::int64_t{cell.i} + cell.j) % 5 == 0; }

}  // namespace lgs::oracle
