#include "by_block.h"

#include <lgs/ground_window.h>
#include <lgs/unloaded.h>

#include <cmath>
#include <memory>

namespace lgs {
namespace {

DoublePoint inCells(Point p) {
  return {static_cast<double>(p.x) / kUnitsPerCell, static_cast<double>(p.y) / kUnitsPerCell};
}

GroundDrawing::Fill fillOf(Block block, Cell cell, std::span<const LocalPoint> vertices) {
  GroundDrawing::Fill fill{block, {}};
  for (const LocalPoint v : vertices) fill.corners.push_back(inCells(toWorld(cell, v)));
  return fill;
}

}  // namespace

Shelf shelfInMemory() {
  const auto chunks = std::make_shared<std::map<Cell, std::vector<std::byte>>>();
  return {.put = [chunks](Cell corner,
                          std::span<const std::byte> bytes) { (*chunks)[corner].assign(bytes.begin(), bytes.end()); },
          .get = [chunks](Cell corner) -> std::optional<std::vector<std::byte>> {
            const auto found = chunks->find(corner);
            if (found == chunks->end()) return std::nullopt;
            return found->second;
          }};
}

GroundDrawing drawingOf(const World& world, const CellRect& cells) {
  GroundDrawing drawing{cells, {}, {}};
  world.forEachPolygon(cells, [&](Cell cell, const PlacedPolygon& polygon) {
    drawing.fills.push_back(fillOf(polygon.block, cell, polygon.vertices));
  });
  for (const SegmentId id : world.segments(cells))
    if (const auto s = world.segment(id)) drawing.lines.push_back({s->block, inCells(s->start), inCells(s->end)});
  return drawing;
}

std::vector<GroundDrawing::Fill> fillsOf(const Body& rock) {
  std::vector<GroundDrawing::Fill> fills;
  for (const BodyPolygon& p : rock.polygons) fills.push_back(fillOf(p.block, p.cell, p.vertices));
  return fills;
}

void ChangedSquares::note(Cell cell) {
  for (const std::int32_t dj : {-1, 1})  // what stands in a cell changes the outline in those around it
    for (const std::int32_t di : {-1, 1}) corners_.insert({(cell.i + di) & -kSide, (cell.j + dj) & -kSide});
}

void ChangedSquares::note(const World& world) {
  world.forEachPolygon([&](Cell cell, const PlacedPolygon&) { note(cell); });
}

void ChangedSquares::noteSides(const CellRect& chunk) {
  const auto [min, max] = chunk;
  for (std::int32_t j = min.j;; j = std::min(j + kSide, max.j)) {
    note({min.i, j}), note({max.i, j});
    if (j == max.j) break;
  }
  for (std::int32_t i = min.i;; i = std::min(i + kSide, max.i)) {
    note({i, min.j}), note({i, max.j});
    if (i == max.i) break;
  }
}

void ChangedSquares::noteBesideUnloaded(const World& world, const CellRect& window) {
  for (const CellRect& chunk : unloadedChunks(world)) {
    const auto [min, max] = chunk;
    const bool isBeside = min.i <= window.max.i + 1 && window.min.i - 1 <= max.i && min.j <= window.max.j + 1 &&
                          window.min.j - 1 <= max.j;
    if (isBeside) noteSides(chunk);
  }
}

std::vector<GroundDrawing> ChangedSquares::draw(const World& world) {
  std::vector<GroundDrawing> drawings;
  for (const Cell corner : std::exchange(corners_, {}))
    drawings.push_back(drawingOf(world, {corner, {corner.i + kSide - 1, corner.j + kSide - 1}}));
  return drawings;
}

Expected<RockInParts> RockInParts::of(Rock rock, const Placing& placing, std::size_t polygonsAtOnce) {
  auto parts = partsAsTheyLie(rock.ground, placing, polygonsAtOnce);
  if (!parts) return tl::unexpected(parts.error());
  RockInParts made;
  made.rock_ = std::move(rock);
  made.placing_ = placing;
  made.atOnce_ = polygonsAtOnce;
  made.parts_ = std::move(*parts);
  bool isFirst = true;
  for (const std::vector<LyingBlock>& part : made.parts_)
    for (const LyingBlock& one : part)
      for (const Ring& ring : one.region.rings)
        for (const Point p : ring) {
          if (std::exchange(isFirst, false)) made.min_ = made.max_ = p;
          made.min_ = {std::min(made.min_.x, p.x), std::min(made.min_.y, p.y)};
          made.max_ = {std::max(made.max_.x, p.x), std::max(made.max_.y, p.y)};
        }
  return made;
}

Rock RockInParts::rest(std::size_t from) const {
  if (from == 0) return rock_;
  Rock rest{rock_.ground, placing_};
  auto& polygons = rest.ground.polygons;
  polygons.erase(polygons.begin(),
                 polygons.begin() + static_cast<std::ptrdiff_t>(std::min(from * atOnce_, polygons.size())));
  rest.ground.cells = detail::cellsOf(rest.ground);
  rest.ground.mass = massOf(polygons);
  return rest;
}

bool RockInParts::isNear(Point min, Point max) const {
  return min.x <= max_.x && min_.x <= max.x && min.y <= max_.y && min_.y <= max.y;
}

CellRect RockInParts::chunks() const {
  return boxOf(chunkAround(cellAt({min_.x - 1, min_.y - 1})), chunkAround(cellAt({max_.x + 1, max_.y + 1})));
}

Expected<void> RockInParts::put(World& world, std::size_t from, std::size_t to) const noexcept {
  Transaction group = world.edit();
  for (std::size_t part = from; part < to; ++part)
    if (const auto done = putPart(world, parts_[part]); !done) return done;
  group.keep();
  return {};
}

NoPhysics::Handle NoPhysics::make(const Rock& rock) {
  rocks_[++last_] = rock;
  return last_;
}

namespace {

/// In cells.
double areaIn(const World& world, const CellRect& cells) {
  std::vector<BodyPolygon> polygons;
  world.forEachPolygon(cells, [&](Cell, const PlacedPolygon& p) {
    polygons.push_back({{}, p.block, {p.vertices.begin(), p.vertices.end()}});
  });
  return massOf(polygons).area;
}
/// How long its outline is, in cells.
double sidesOf(const Body& body) {
  const auto world = detail::worldOf(body, std::vector<Block>(body.polygons.size()));
  if (!world) return 0;
  double sum = 0;
  for (const SegmentId id : world->segments()) {
    const Segment side = world->segment(id).value();
    sum += std::hypot(side.end.x - side.start.x, side.end.y - side.start.y);
  }
  return sum / kUnitsPerCell;
}

/// What is ground already would stay, and that part of the rock be lost: so it is refused.
Expected<void> putWhole(World& world, const Rock& rock) {
  const auto lying = RockInParts::of(rock, rock.placing, rock.ground.polygons.size());
  if (!lying) return tl::unexpected(lying.error());
  const CellRect cells = lying->chunks();
  const double before = areaIn(world, cells);
  Transaction group = world.edit();
  if (const auto done = lying->put(world, 0, lying->count()); !done) return done;
  if (areaIn(world, cells) - before < rock.ground.mass.area - sidesOf(rock.ground) / 100)
    return tl::unexpected(Error{.code = ErrorCode::overlap});
  group.keep();
  return {};
}

}  // namespace

Expected<void> NoPhysics::settle(Handle handle) {
  const Rock& rock = rocks_.at(handle);
  const auto& [ground, placing, velocity, spin] = rock;
  const Point at = latticePoint(placing.origin);
  if (placing.cosine == 1 && inRange(at) && toWorld(cellAt(at), {}) == at) {
    if (const auto done = put(world_, ground, cellAt(at)); !done) return tl::unexpected(done.error());
  } else if (const auto done = putWhole(world_, rock); !done) {
    return done;
  }
  destroy(handle);
  return {};
}

}  // namespace lgs
