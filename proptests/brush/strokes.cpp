#include "proptests/brush/strokes.h"

#include "geometry/ring.h"
#include "proptests/support/must.h"

#include <gtest/gtest.h>

#include <ostream>

namespace lgs::test {
namespace {

constexpr std::int64_t kUnit = kUnitsPerCell;

rc::Gen<Point> points(std::int64_t step) {
  return rc::gen::map(rc::gen::pair(rc::gen::inRange(-12, 13), rc::gen::inRange(-12, 13)),
                      [step](std::pair<int, int> p) {
                        return Point{kUnit + p.first * step, kUnit + p.second * step};
                      });
}

rc::Gen<Ring> rings(std::int64_t step) {
  return rc::gen::mapcat(rc::gen::inRange<std::size_t>(3, 8),
                         [step](std::size_t count) { return rc::gen::container<Ring>(count, points(step)); });
}

/// Even-odd regions of any rings, and unions of triangles.
rc::Gen<Region> regions(std::int64_t step) {
  const auto any = rc::gen::mapcat(rc::gen::inRange<std::size_t>(1, 3), [step](std::size_t count) {
    return rc::gen::map(rc::gen::container<std::vector<Ring>>(count, rings(step)), [](std::vector<Ring> r) {
      return Region{std::move(r), FillRule::evenOdd};
    });
  });
  const auto triangles = rc::gen::map(rc::gen::container<Ring>(9, points(step)), [](const Ring& corners) {
    Region region;
    for (std::size_t k = 0; k < corners.size(); k += 3) {
      Ring ring(corners.begin() + static_cast<std::ptrdiff_t>(k), corners.begin() + static_cast<std::ptrdiff_t>(k) + 3);
      if (detail::doubleArea(ring) < 0) std::swap(ring[1], ring[2]);
      if (detail::doubleArea(ring) != 0) region.rings.push_back(ring);
    }
    return region;
  });
  return rc::gen::weightedOneOf<Region>({{2, any}, {1, triangles}});
}

rc::Gen<oracle::BrushEdit> strokesOn(std::int64_t step) {
  const auto parts = rc::gen::tuple(rc::gen::element(Deed::carve, Deed::fill, Deed::replace),
                                    rc::gen::inRange<Block>(1, 4), regions(step));
  return rc::gen::map(parts, [](const std::tuple<Deed, Block, Region>& drawn) {
    const auto& [deed, block, region] = drawn;
    return oracle::BrushEdit{deed, block, region.rings, region.rule == FillRule::evenOdd};
  });
}

rc::Gen<std::int64_t> steps() { return rc::gen::element<std::int64_t>(8'192, 10'007, 977, 37, 5, 1); }

void show(const Region& region, std::ostream& out) {
  out << (region.rule == FillRule::evenOdd ? "even-odd" : "non-zero");
  for (const Ring& ring : region.rings) {
    for (const Point p : ring) out << ' ' << p.x << ',' << p.y;
    out << " |";
  }
}

}  // namespace

void showValue(const AnyStrokes& strokes, std::ostream& out) {
  out << "ground " << static_cast<int>(strokes.ground) << '\n';
  for (const oracle::BrushEdit& s : strokes.strokes) {
    constexpr const char* kNames[] = {"carve", "fill", "replace"};
    out << kNames[static_cast<int>(s.deed)] << " block " << s.block << ' ';
    show(regionOf(s), out);
    out << '\n';
  }
}

void showValue(const AnyRegion& region, std::ostream& out) { show(region.region, out); }

World worldOf(Ground ground) {
  World world;
  if (ground == Ground::empty) return world;
  for (std::int32_t i = 0; i < 3; ++i) {
    for (std::int32_t j = 0; j < 3; ++j) {
      const Block block = ground == Ground::slanted ? static_cast<Block>(1 + (i + j) % 3) : 1;
      if (ground == Ground::solid) {
        RC_ASSERT(world.add({i, j}, kUnitSquare, block).has_value());
      } else {  // two ramps, cut near the middle: blocks, if there are three, meet in many ways
        constexpr std::int32_t kEnd = kUnitsPerCell, kLow = kEnd / 3, kHigh = kEnd - 5;
        const Block above = ground == Ground::slanted ? block % 3 + 1 : block;
        RC_ASSERT(world.add({i, j}, {{0, 0}, {kEnd, 0}, {kEnd, kHigh}, {0, kLow}}, block).has_value());
        RC_ASSERT(world.add({i, j}, {{0, kLow}, {kEnd, kHigh}, {kEnd, kEnd}, {0, kEnd}}, above).has_value());
      }
    }
  }
  return world;
}

oracle::Scene sceneOf(const World& world) {
  oracle::Scene scene;
  world.forEachPolygon([&](Cell cell, const PlacedPolygon& p) {
    scene.polygons.push_back({cell, p.block, {p.vertices.begin(), p.vertices.end()}});
  });
  return scene;
}

std::vector<std::vector<Point>> outlines(World& world) {
  world.commit();
  std::vector<std::vector<Point>> all;
  for (const Loop& loop : world.loops(Collinear::merge)) all.push_back(loop.vertices);
  return all;
}

void expectNoSeam(Ground ground, const Region& region) {
  World world = worldOf(ground);
  const auto solid = outlines(world);
  must(carve(world, region));
  world.commit();
  must(paint(world, region, 1, PaintMode::fill));
  EXPECT_EQ(outlines(world), solid);
}

std::map<PolygonHandle, Standing> standingIn(const World& world) {
  std::map<PolygonHandle, Standing> all;
  world.forEachPolygon([&](Cell cell, const PlacedPolygon& p) {
    all[p.handle] = {cell, p.block, {p.vertices.begin(), p.vertices.end()}};
  });
  return all;
}

rc::Gen<AnyStrokes> AnyStrokes::arbitrary() {
  return rc::gen::mapcat(steps(), [](std::int64_t step) {
    const auto grounds = rc::gen::element(Ground::empty, Ground::solid, Ground::slanted, Ground::halved);
    const auto some = rc::gen::mapcat(rc::gen::inRange<std::size_t>(1, 7), [step](std::size_t count) {
      return rc::gen::container<Strokes>(count, strokesOn(step));
    });
    return rc::gen::map(rc::gen::pair(grounds, some), [](std::pair<Ground, Strokes> drawn) {
      return AnyStrokes{drawn.first, std::move(drawn.second)};
    });
  });
}

rc::Gen<AnyRegion> AnyRegion::arbitrary() {
  return rc::gen::mapcat(steps(), [](std::int64_t step) {
    return rc::gen::map(regions(step), [](lgs::Region region) { return AnyRegion{std::move(region)}; });
  });
}

}  // namespace lgs::test
