#include "fuzz/strokes.h"

#include "fuzz/questions.h"
#include "fuzz/same.h"
#include "fuzz/units.h"
#include "oracle/check/questions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace lgs::fuzz {
namespace {

using oracle::Random;

Point near(Point p, std::int64_t reach, Random& random) {
  const std::int64_t x = random.between(-reach, reach), y = random.between(-reach, reach);
  return {std::clamp(p.x + x, -kMaxCoordinate, kMaxCoordinate), std::clamp(p.y + y, -kMaxCoordinate, kMaxCoordinate)};
}

Region drawRegion(const World& world, Random& random) {
  constexpr std::array<std::int64_t, 6> kSizes{3 * kCell, kCell, kCell / 3, kCell / 16, 40, 2};
  const std::int64_t size = kSizes[random.below(kSizes.size())];
  Point at = oracle::somePoint(world, random);
  if (random.chance(40)) at = {at.x & ~(kCell / 4 - 1), at.y & ~(kCell / 4 - 1)};
  Region region;
  switch (random.below(6)) {
    case 0:
      return circle(at, size, 8 + random.below(25));
    case 1:
      return rectangle(at, random.chance(50) ? Point{random.below(2), random.below(2)} : near({}, 100, random), size,
                       1 + random.below(size));
    case 2: {
      std::vector<Point> line{at};
      for (int k = random.below(4); k > 0; --k) line.push_back(near(line.back(), 2 * size, random));
      return thickLine(line, 1 + random.below(size), 8 + random.below(9));
    }
    case 3: {  // in cells, and now and then beyond all of them
      std::vector<std::vector<DoublePoint>> rings(1);
      for (int k = 3 + random.below(3); k > 0; --k) {
        const Point p = near(at, size, random);
        rings[0].push_back({static_cast<double>(p.x) / kCell, static_cast<double>(p.y) / kCell});
      }
      if (random.chance(5)) rings[0][0].x = random.chance(50) ? 1e300 : std::nan("");
      return lgs::region(rings);
    }
    default: {  // on a coarse lattice, so that they touch and cross
      const std::int64_t step = std::max<std::int64_t>(size / 8, 1);
      for (int rings = 1 + random.below(3); rings > 0; --rings) {
        Ring& ring = region.rings.emplace_back();
        for (int k = random.between(2, 8); k > 0; --k) {
          const std::int64_t x = random.between(-10, 10), y = random.between(-10, 10);
          ring.push_back({at.x + step * x, at.y + step * y});
        }
      }
      if (random.chance(50)) region.rule = FillRule::evenOdd;
      return region;
    }
  }
}

std::set<PolygonHandle> handlesIn(const World& world) {
  std::set<PolygonHandle> all;
  world.forEachPolygon([&](Cell, const PlacedPolygon& p) { all.insert(p.handle); });
  return all;
}

/// What the result must tell: which polygons are no more, and which are new.
std::string wrongResult(const World& before, const World& after, const BrushResult& result) {
  std::set<PolygonHandle> old = handlesIn(before), now = handlesIn(after);
  for (const PolygonHandle handle : result.removed)
    if (old.erase(handle) == 0 || now.contains(handle)) return "names a polygon that has not gone";
  for (const PolygonHandle handle : result.added)
    if (now.erase(handle) == 0 || old.contains(handle)) return "names a polygon that has not come";
  for (const BrushChange& change : result.changed) {
    if (change.now.empty() || old.erase(change.old) == 0) return "names a polygon as changed that was not there";
    for (const PolygonHandle handle : change.now) now.erase(handle);  // several may become one
  }
  if (old != now) return "does not name all that it changed";
  for (const PolygonHandle handle : old) {
    const auto was = before.polygon(handle), is = after.polygon(handle);
    if (!is || was->block != is->block || !std::ranges::equal(was->vertices, is->vertices))
      return "does not name a polygon that it changed";
  }
  return "";
}

/// Only cells that have a part of the region change.
std::string wrongCells(const World& before, const World& after, const Region& region) {
  const auto cells = cellsOf(region);
  const auto bounds = boundsOf(region);
  if (!cells || !bounds) return "cellsOf() refuses what is painted";
  const std::set<Cell> all(cells->begin(), cells->end());
  if (all.size() != cells->size()) return "cellsOf() names a cell twice";
  for (const Cell cell : all)
    if (!contains(*bounds, cell)) return "boundsOf() has not all cells";
  std::string wrong;
  for (const World* world : {&before, &after}) {
    world->forEachPolygon([&](Cell cell, const PlacedPolygon& p) {
      const World& other = world == &before ? after : before;
      if (!all.contains(cell) && !other.polygon(p.handle)) wrong = "a cell changed that has no part of the region";
    });
  }
  return wrong;
}

/// All blocks stay: it is as to fill. None do: it is as without that.
std::string wrongStaying(const World& before, const World& after, const Stroke& stroke) {
  Stroke twin = stroke;
  if (!stroke.staying) {
    World none = before;
    twin.staying = [](Block) { return false; };
    if (!twin.make(none) || !samePolygons(none, after)) return "no block stays, and it matters";
  }
  if (stroke.deed == Stroke::Deed::carve) return "";
  World around = before, filled = before;
  twin.deed = Stroke::Deed::replace;
  twin.staying = [](Block) { return true; };
  const bool isAround = twin.make(around).has_value();
  twin.deed = Stroke::Deed::fill;
  twin.staying = {};
  if (twin.make(filled).has_value() != isAround) return "to fill is refused, or to replace where all blocks stay";
  return samePolygons(around, filled) ? "" : "to replace where all blocks stay is not to fill";
}

/// Twice the area of each block that stays, and how long the edges of all polygons are.
struct Extent {
  double area = 0, length = 0;
};
Extent extentOf(const World& world, const StayingBlocks& staying) {
  Extent extent;
  world.forEachPolygon([&](Cell, const PlacedPolygon& p) {
    for (std::size_t k = 0; k < p.vertices.size(); ++k) {
      const LocalPoint a = p.vertices[k], b = p.vertices[(k + 1) % p.vertices.size()];
      if (staying(p.block)) extent.area += double{1} * a.x * b.y - double{1} * a.y * b.x;
      extent.length += std::hypot(a.x - b.x, a.y - b.y);
    }
  });
  return extent;
}

/// Law 8 for what stays, as far as an area shows it: it is bent by a unit along its edges at most.
bool keepsWhatStays(const World& before, const World& after, const Stroke& stroke) {
  if (!stroke.staying) return true;
  const Extent was = extentOf(before, stroke.staying), is = extentOf(after, stroke.staying);
  const bool paintsIt = stroke.deed != Stroke::Deed::carve && stroke.staying(stroke.block);
  const double most = 2 * (was.length + is.length);
  return is.area >= was.area - most && (paintsIt || is.area <= was.area + most);
}

/// A region but for another one: points in the one, far from all edges, are in the rest or in the other one.
std::string wrongRest(const Region& region, const World& world, Random& random) {
  const Region except = drawRegion(world, random);
  const auto rest = without(region, except);
  World all, hole, left;
  const bool isMade = paint(all, region, 1, PaintMode::fill) && paint(hole, except, 1, PaintMode::fill);
  if (!rest) return isMade && rest.error().code != ErrorCode::capacity ? "without() refuses what can be painted" : "";
  if (!isMade || !paint(left, *rest, 1, PaintMode::fill)) return "";  // a cell may get too full
  for (World* w : {&all, &hole, &left}) w->commit();
  const auto in = [](const World& w, Point p) { return w.at(p).where != Spot::Where::outside; };
  for (int k = 0; k < 20; ++k) {
    const Point p = oracle::somePoint(all, random);
    const double away = 8.0 / kCell;
    if (all.nearest(p, away)->segment || hole.nearest(p, away)->segment) continue;
    if (!inRange(p) || all.at(p).where == Spot::Where::edge || hole.at(p).where == Spot::Where::edge) continue;
    if (in(left, p) != (in(all, p) && !in(hole, p))) return "without() is not the difference";
  }
  return "";
}

bool meetsAll(const World& painted, const Region& region) {
  bool all = true;
  painted.forEachPolygon([&](Cell cell, const PlacedPolygon& p) {
    Ring ring;
    for (const LocalPoint v : p.vertices) ring.push_back(toWorld(cell, v));
    all = all && meets(region, ring);
  });
  return all;
}

}  // namespace

Expected<BrushResult> Stroke::make(World& world) const {
  if (deed == Deed::carve) return carve(world, region, staying);
  return paint(world, region, block, deed == Deed::fill ? PaintMode::fill : PaintMode::replace, staying);
}

Stroke drawStroke(const World& world, Random& random) {
  Stroke stroke;
  stroke.region = drawRegion(world, random);
  stroke.deed = static_cast<Stroke::Deed>(random.below(3));
  stroke.block = random.below(4U);
  if (random.chance(40)) stroke.staying = [stays = random.below(4U)](Block block) { return block == stays; };
  return stroke;
}

std::string strokeAndGoBack(World& world, Random& random, bool stays) {
  const World before = world;
  const Stroke stroke = drawStroke(world, random);
  const Mark mark = world.mark();
  const auto done = stroke.make(world);
  if (!done) {
    const bool isKnown = done.error().code == ErrorCode::capacity || done.error().code == ErrorCode::outOfReach;
    if (!isKnown || message(done.error()).empty()) return "a stroke is refused: " + message(done.error());
    if (done.error().code == ErrorCode::outOfReach && (cellsOf(stroke.region) || boundsOf(stroke.region)))
      return "cellsOf() takes what is out of reach";
    if (!world.forget(mark)) return "a mark is lost by a refused stroke";
    const std::string wrong = differenceOf(before, world);
    return wrong.empty() ? wrong : "a refused stroke leaves " + wrong;
  }
  if (std::string wrong = wrongResult(before, world, *done); !wrong.empty()) return "a stroke " + wrong;
  if (std::string wrong = wrongCells(before, world, stroke.region); !wrong.empty()) return wrong;
  if (std::string wrong = wrongStaying(before, world, stroke); !wrong.empty()) return wrong;
  if (!keepsWhatStays(before, world, stroke)) return "a stroke changes a block that stays";
  if (std::string wrong = wrongRest(stroke.region, world, random); !wrong.empty()) return wrong;
  World painted;
  if (paint(painted, stroke.region, 1, PaintMode::fill) && !meetsAll(painted, stroke.region))
    return "meets() does not meet what is painted";
  world.commit();
  if (std::string wrong = differenceByLaws(world); !wrong.empty()) return "after a stroke " + wrong;
  const World after = world;
  if (!world.rollBack(mark, Undone::keep)) return "a stroke can not be undone";
  if (std::string wrong = differenceOf(before, world); !wrong.empty()) return "a stroke was undone: " + wrong;
  if (!stays) return world.forget(mark) ? "" : "a mark is lost";
  // Only a mark that is ahead leads forward; so it is made again.
  if (!stroke.make(world) || !world.forget(mark)) return "a stroke can not be made again";
  world.commit();
  const std::string wrong = differenceOf(after, world);
  return wrong.empty() ? wrong : "a stroke that was undone and made again leaves " + wrong;
}

}  // namespace lgs::fuzz
