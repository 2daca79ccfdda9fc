// Takes islands out of the ground, and says what an edit would do to them.
#include "geometry/sort.h"
#include "walk.h"

#include <lgs/islands.h>

#include <algorithm>
#include <cstddef>
#include <unordered_set>

namespace lgs {
namespace {

using detail::Contact;
using detail::Standing;

Body bodyOf(std::span<const Standing> polygons) {
  Body body;
  const auto [south, north] = std::ranges::minmax(polygons, {}, [](const Standing& s) { return s.cell.j; });
  const auto [west, east] = std::ranges::minmax(polygons, {}, [](const Standing& s) { return s.cell.i; });
  body.cells = {{west.cell.i, south.cell.j}, {east.cell.i, north.cell.j}};
  body.origin = body.cells.min;
  for (const auto& [cell, p] : polygons)
    body.polygons.push_back(
        {{cell.i - body.origin.i, cell.j - body.origin.j}, p.block, {p.vertices.begin(), p.vertices.end()}});
  body.mass = massOf(body.polygons);
  return body;
}

/// A polygon of the island, as the world is now.
std::optional<Standing> startOf(const World& world, const Islands& islands, IslandId id) {
  const auto island = islands.island(id);
  if (!island) return std::nullopt;
  const auto first = islands.loops().outline(world).segment(island->outer.first);
  return first ? detail::ownerOf(world, *first) : std::nullopt;
}

}  // namespace

Expected<Body> take(World& world, const Islands& islands, IslandId island) noexcept {
  const auto start = startOf(world, islands, island);
  if (!start) return tl::unexpected(Error{.code = ErrorCode::staleHandle});
  detail::Walk walk;
  const std::vector<Standing>& polygons = walk.from(world, *start, Contact::point);
  Body body = bodyOf(polygons);
  std::vector<PolygonHandle> handles;
  for (const Standing& s : polygons) handles.push_back(s.polygon.handle);
  if (const auto done = world.removeMany(handles); !done) return tl::unexpected(done.error());
  return body;
}

Expected<std::vector<Body>> takeApart(World& world, const Islands& islands, IslandId island) noexcept {
  const auto start = startOf(world, islands, island);
  if (!start) return tl::unexpected(Error{.code = ErrorCode::staleHandle});
  detail::Walk whole, part;
  std::unordered_set<PolygonHandle> taken;
  std::vector<PolygonHandle> handles;
  std::vector<Body> bodies;
  for (const Standing& s : whole.from(world, *start, Contact::point)) {
    handles.push_back(s.polygon.handle);
    if (taken.contains(s.polygon.handle)) continue;
    const std::vector<Standing>& polygons = part.from(world, s, Contact::edge);
    for (const Standing& p : polygons) taken.insert(p.polygon.handle);
    bodies.push_back(bodyOf(polygons));
  }
  if (const auto done = world.removeMany(handles); !done) return tl::unexpected(done.error());
  return bodies;
}

Foreseen foresee(World& world, Islands& islands, const std::function<bool(World&)>& edit) noexcept {
  Foreseen out;
  if (world.hasUncommitted()) return out;
  const Mark mark = world.mark();
  if (edit && edit(world) && islands.update(world, world.commit())) {
    out.changes = islands.changes();
    const auto look = [&](IslandId id) {
      if (const auto facts = islands.island(id)) out.after.push_back(*facts);
    };
    for (const auto* ids : {&out.changes.added, &out.changes.changed})
      for (const IslandId id : *ids) look(id);
    for (const IslandPair& p : out.changes.cutOff) look(p.into);
    for (const IslandPair& p : out.changes.cutOff) look(p.from);
    for (const IslandPair& p : out.changes.joined) look(p.into);
    detail::sort(out.after, [](const IslandFacts& a, const IslandFacts& b) { return a.id < b.id; });
    const auto isSame = [](const IslandFacts& a, const IslandFacts& b) { return a.id == b.id; };
    out.after.erase(std::unique(out.after.begin(), out.after.end(), isSame), out.after.end());
  }
  static_cast<void>(world.rollBack(mark));
  static_cast<void>(islands.update(world, world.changesOfRollBack()));
  static_cast<void>(world.forget(mark));
  return out;
}

}  // namespace lgs
