// Islands that leave the ground as bodies, and come back: found by a flood over the polygons.
#include "oracle/reference/touching.h"
#include "oracle/trace/model.h"

#include <fmt/format.h>
#include <algorithm>
#include <set>
#include <tuple>

namespace lgs::oracle {

using Kind = Call::Kind;

namespace {

ScenePolygon inWorld(const Body& body, const BodyPolygon& p) {
  return {{body.origin.i + p.cell.i, body.origin.j + p.cell.j}, p.block, p.vertices};
}

CellRect boxOf(const Body& body) {
  CellRect box{{INT32_MAX, INT32_MAX}, {INT32_MIN, INT32_MIN}};
  for (const BodyPolygon& p : body.polygons) {
    const Cell cell = inWorld(body, p).cell;
    box = {{std::min(box.min.i, cell.i), std::min(box.min.j, cell.j)},
           {std::max(box.max.i, cell.i), std::max(box.max.j, cell.j)}};
  }
  return box;
}

}  // namespace

// The names of all in memory that hangs together with this one, in the order of a body's polygons.
std::vector<std::string> Model::islandOf(const std::string& name, bool byEdges) const {
  std::vector<std::string> found{name};
  std::set<std::string> seen{name};
  for (std::size_t k = 0; k < found.size(); ++k) {
    const ScenePolygon here = standing()[found[k]];
    for (const Cell cell : cellsOf({{here.cell.i - 1, here.cell.j - 1}, {here.cell.i + 1, here.cell.j + 1}})) {
      for (const Standing::Placed& p : standing().in(cell)) {
        const ScenePolygon other{cell, p.block, p.vertices};
        if (byEdges ? !haveCommonEdge(here, other) : !haveCommonPoint(here, other)) continue;
        if (seen.insert(p.name).second) found.push_back(p.name);
      }
    }
  }
  std::ranges::stable_sort(found, {}, [&](const std::string& each) {
    const Cell cell = standing().cellOf(each);
    return std::tuple(cell.j, cell.i, standing().handleOf(each));
  });
  return found;
}

// In the order of their first polygons.
std::vector<Body> Model::bodiesOf(const Call& call) const {
  std::vector<Body> bodies;
  std::set<std::string> taken;
  for (const std::string& first : islandOf(call.goes[0].name, false)) {
    if (taken.contains(first)) continue;
    const auto names = (call.nth & Call::kApart) != 0 ? islandOf(first, true) : islandOf(first, false);
    taken.insert(names.begin(), names.end());
    Body body;
    for (const std::string& name : names) {
      const auto [cell, block, vertices] = standing()[name];
      body.polygons.push_back({cell, block, vertices});
    }
    body.cells = boxOf(body);
    body.origin = body.cells.min;
    for (BodyPolygon& p : body.polygons) p.cell = {p.cell.i - body.origin.i, p.cell.j - body.origin.j};
    bodies.push_back(std::move(body));
  }
  return bodies;
}

// What hangs together with ground that is not in memory stays; what lies at the square of a chunk that is not may stay,
// too. While edits are pending a view may find another island, or none.
Verdict Model::judgeTake(const Call& call) const {
  const Verdict stale{false, ErrorCode::staleHandle};
  const Verdict open{.code = ErrorCode::staleHandle, .isOpen = true};
  if (now_.pending != Pending::no) return open;
  if (call.goes[0].name.empty()) return stale;
  if ((call.nth & Call::kOpen) != 0 || isWhole()) return {};
  bool isAtEdge = false;
  for (const std::string& name : islandOf(call.goes[0].name, false)) {
    const ScenePolygon here = standing()[name];
    for (const Cell cell : cellsOf({{here.cell.i - 1, here.cell.j - 1}, {here.cell.i + 1, here.cell.j + 1}})) {
      const auto away = now_.away.find(chunkOf(cell));
      if (away == now_.away.end()) continue;
      isAtEdge = true;
      const auto there = away->second.find(cell);
      if (there == away->second.end()) continue;
      for (const Standing::Placed& p : there->second)
        if (haveCommonPoint(here, {cell, p.block, p.vertices})) return stale;
    }
  }
  return isAtEdge ? open : Verdict{};
}

// Of a body that is put: its polygons, as they would lie.
std::vector<Coming> Model::comingOf(const Call& call) const {
  std::vector<Coming> comes;
  if (now_.bodies.empty()) return comes;
  const Body body = laid(now_.bodies[call.nth % now_.bodies.size()], call.lies);
  const auto named = [](std::int64_t index) {
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(index, -kMaxCell - 1, kMaxCell + 1));
  };
  for (const BodyPolygon& p : body.polygons) {
    const Cell cell{named(std::int64_t{body.origin.i} + p.cell.i), named(std::int64_t{body.origin.j} + p.cell.j)};
    comes.push_back({.cell = cell, .shape = {p.vertices}, .block = p.block});
  }
  return comes;
}

// Of what stands; empty if it does not.
std::string Model::nameOf(const Body& body, const BodyPolygon& polygon) const {
  const ScenePolygon there = inWorld(body, polygon);
  for (const Standing::Placed& p : standing().in(there.cell))
    if (p.block == there.block && p.vertices == there.vertices) return p.name;
  return "";
}

std::string Model::wrongBodies(const Call& call, const Outcome& outcome) const {
  if (call.kind != Kind::take) return "";
  if (outcome.bodies.empty() || outcome.bodies[0].polygons.empty()) return "takes nothing";
  Call named = call;
  const bool isAny = now_.pending != Pending::no;  // any island that there is
  if (isAny) named.goes[0].name = nameOf(outcome.bodies[0], outcome.bodies[0].polygons[0]);
  if (named.goes[0].name.empty()) return "takes what is not there";
  const std::vector<Body> expected = bodiesOf(named);
  if (outcome.bodies.size() != expected.size())
    return fmt::format("takes {} bodies instead of {}", outcome.bodies.size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) {
    const Body &is = outcome.bodies[k], &must = expected[k];
    if (is.polygons != must.polygons) return "takes other polygons than those that hang together";
    if (is.origin != must.origin || is.cells != must.cells) return "says of a body that it was elsewhere";
  }
  return "";
}

void Model::take(const Call& call, const Outcome* outcome) {
  const std::vector<Body> bodies = outcome != nullptr          ? outcome->bodies
                                   : call.goes[0].name.empty() ? std::vector<Body>()
                                                               : bodiesOf(call);
  for (const Body& body : bodies)
    for (const BodyPolygon& p : body.polygons) now_.standing.remove(nameOf(body, p));
  now_.bodies.insert(now_.bodies.end(), bodies.begin(), bodies.end());
}

}  // namespace lgs::oracle
