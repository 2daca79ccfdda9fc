// What views are asked, against the slow way.
#include "fuzz/beside.h"
#include "fuzz/questions.h"
#include "fuzz/views.h"
#include "oracle/check/questions.h"

#include <cmath>
#include <set>

namespace lgs::fuzz {
namespace {

using oracle::Random;

bool has(std::span<const LocalPoint> piece, Cell cell, Point p) {
  for (std::size_t k = 0; k < piece.size(); ++k) {
    const Point a = toWorld(cell, piece[k]), b = toWorld(cell, piece[(k + 1) % piece.size()]);
    if ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) < 0) return false;
  }
  return true;
}

/// The first piece of the least cell that has the point.
std::string wrongPieceAt(const Pieces& pieces, Point p) {
  std::optional<PieceId> first;
  const Cell last = cellAt(p);
  for (std::int32_t i = last.i - 1; i <= last.i; ++i) {
    for (std::int32_t j = last.j - 1; j <= last.j; ++j) {
      const auto free = pieces.freePieces({i, j});
      for (std::uint32_t k = 0; k < free.size() && !first; ++k)
        if (has(free[k].vertices, {i, j}, p)) first = PieceId{{i, j}, k};
    }
  }
  return pieces.freePieceAt(p) == first ? "" : "freePieceAt() finds another piece";
}

std::string wrongWholeCells(const Pieces& pieces, const CellRect& cells) {
  for (const Part part : {Part::solid, Part::free}) {
    std::set<Cell> whole;
    std::size_t count = 0;
    for (const CellRect& r : pieces.wholeCells(cells, part)) {
      for (std::int32_t j = r.min.j; j <= r.max.j; ++j)
        for (std::int32_t i = r.min.i; i <= r.max.i; ++i, ++count) whole.insert({i, j});
    }
    if (count != whole.size()) return "wholeCells() has a cell twice";
    for (std::int32_t j = cells.min.j; j <= cells.max.j; ++j) {
      for (std::int32_t i = cells.min.i; i <= cells.max.i; ++i) {
        const Cell cell{i, j};
        const bool is =
            inRange(cell) && (part == Part::solid ? pieces.freePieces(cell) : pieces.solidPieces(cell)).empty();
        if (is != whole.contains(cell)) return "wholeCells() has a cell too many, or too few";
      }
    }
  }
  return pieces.wholeCells({{1, 1}, {0, 0}}, Part::free).empty() ? "" : "no cells have a whole one";
}

std::string wrongHashes(const GroundHashes& hashes, const World& world) {
  const auto bounds = world.bounds();
  const HashedSquare whole = hashes.whole();
  if (whole.hash != hashes.hash() || !hashes.hashes(whole.cells, -1).empty() ||
      !hashes.hashes(whole.cells, GroundHashes::kTopLevel + 1).empty() || !hashes.hashes({{1, 1}, {0, 0}}).empty())
    return "the hash of all ground is not that of the square with all ground";
  if (bounds && (!contains(whole.cells, bounds->min) || !contains(whole.cells, bounds->max)))
    return "whole() has not all ground";
  return bounds && groundHash(world, *bounds) != hashes.hash() ? "groundHash() of all ground is another one" : "";
}

std::string wrongIslands(const Islands& islands, const World& world) {
  std::set<IslandId> all;
  for (const IslandId id : islands.all()) all.insert(id);
  std::set<IslandId> found;
  world.forEachPolygon([&](Cell, const PlacedPolygon& p) { found.insert(islands.of(world, p.handle)); });
  if (found != all) return "of() finds other islands than there are";
  for (const IslandId id : islands.loose())
    if (islands.island(id)->anchors > 0) return "an island is loose, and has an anchor";
  const IslandId none{0xffff'ff00};
  const bool isNone = !islands.island(none) && !islands.of(world, PolygonHandle{}) &&
                      !islands.loops().loop({0xffff'ff00}) && !islands.loops().of(SegmentId{0xffff'ff00});
  return isNone ? "" : "an id that names nothing names an island";
}

/// A body in parts that share more than points; and one that fits nowhere.
std::string wrongParts(World world, const Islands& islands, Random& random) {
  const auto all = islands.all();
  if (all.empty() || take(world, islands, IslandId{0xffff'ff00}) || takeApart(world, islands, IslandId{0xffff'ff00}))
    return all.empty() ? "" : "an island that is none can be taken";
  World twin = world;
  const IslandId island = random.pick(all);
  const auto whole = take(world, islands, island);
  const auto parts = takeApart(twin, islands, island);
  if (!whole || !parts) return "an island can not be taken apart";
  std::size_t polygons = 0;
  double area = 0;
  for (const Body& part : *parts) {
    polygons += part.polygons.size();
    area += part.mass.area;
    if (massOf(part.polygons).area != part.mass.area) return "the mass of a part is not that of its polygons";
  }
  if (polygons != whole->polygons.size() || std::abs(area - whole->mass.area) > 1e-9 * (1 + area) ||
      !samePolygons(world, twin))
    return "the parts of an island are not all of it";
  Body far = *whole;
  const std::size_t count = far.polygons.size();
  far.polygons.push_back({{far.origin.i > 0 ? INT32_MAX : INT32_MIN, 0}, 1, far.polygons[0].vertices});
  far.polygons.push_back({{0, 0}, 1, {{-1, 0}, {1, 0}, {0, 1}}});
  const auto done = put(world, far, far.origin);
  const bool isTold = !done && done.error().index == static_cast<std::int32_t>(count) && samePolygons(world, twin);
  return isTold && massOf({}).area == 0 ? "" : "a body that fits nowhere is put into the ground";
}

}  // namespace

std::string wrongViewReads(const World& world, const Followed& views, Random& random) {
  const auto& [islands, pieces, hashes] = views;
  for (int k = 0; k < 6; ++k)
    if (std::string wrong = wrongPieceAt(pieces, oracle::somePoint(world, random)); !wrong.empty()) return wrong;
  if (pieces.freePieceAt({kMaxCoordinate + 1, 0}) || !pieces.portals({{kMaxCell + 1, 0}, 0}).empty())
    return "beyond the last cell there is a free piece";
  const CellRect bounds = world.bounds().value_or(CellRect{});
  const bool isSmall = bounds.max.i - std::int64_t{bounds.min.i} < 99 && bounds.max.j - std::int64_t{bounds.min.j} < 99;
  const CellRect around{{bounds.min.i - 1, bounds.min.j - 1}, {bounds.max.i + 1, bounds.max.j + 1}};
  if (std::string wrong = isSmall ? wrongWholeCells(pieces, around) : ""; !wrong.empty()) return wrong;
  if (std::string wrong = wrongHashes(hashes, world); !wrong.empty()) return wrong;
  if (std::string wrong = wrongIslands(islands, world); !wrong.empty()) return wrong;
  // Changes that are not the next ones are refused.
  Islands twin = islands;
  Changes others;
  others.before = world.version() + 1;
  others.after = others.before + 1;
  const Changes made = {{SegmentId{1}}, {SegmentId{1}}, {SegmentId{0xffff'ff00}}, world.version(), world.version()};
  const bool looksAtLists = !world.preserveRelation();  // else it follows a world of its own
  if (twin.update(world, others) || (looksAtLists && twin.update(world, made)))
    return "changes that are none are taken over";
  return wrongParts(world, islands, random);
}

}  // namespace lgs::fuzz
