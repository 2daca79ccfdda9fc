#include "proptests/brush/strokes.h"

#include "geometry/ring.h"
#include "proptests/support/must.h"
#include "proptests/support/played.h"
#include "proptests/support/traces.h"

#include <gtest/gtest.h>

#include <array>

namespace lgs::test {
namespace {

using oracle::Call;
using oracle::Random;
using oracle::Trace;

Point pointNear(Random& random, std::int64_t step) {
  const std::int64_t x = random.between(-12, 12);
  return {kUnitsPerCell + x * step, kUnitsPerCell + random.between(-12, 12) * step};
}

/// An even-odd region of any rings, or a union of triangles.
oracle::BrushEdit strokeNear(Random& random, std::int64_t step) {
  constexpr std::array kDeeds{Deed::carve, Deed::fill, Deed::replace};
  oracle::BrushEdit brush;
  brush.deed = kDeeds[random.below(kDeeds.size())];
  brush.block = brush.deed == Deed::carve ? 0 : random.between<Block>(1, 3);
  brush.isEvenOdd = random.below(3) > 0;
  brush.rings.resize(brush.isEvenOdd ? 1 + random.below(2U) : 3U);
  for (Ring& ring : brush.rings) {
    for (int k = brush.isEvenOdd ? random.between(3, 7) : 3; k > 0; --k) ring.push_back(pointNear(random, step));
    if (!brush.isEvenOdd && detail::doubleArea(ring) < 0) std::swap(ring[1], ring[2]);
  }
  if (!brush.isEvenOdd) std::erase_if(brush.rings, [](const Ring& ring) { return detail::doubleArea(ring) == 0; });
  return brush;
}

Trace groundOf(Ground ground) {
  Trace trace;
  const auto add = [&](Cell cell, Block block, std::vector<LocalPoint> vertices) {
    trace.calls.push_back(Call::add("p" + std::to_string(trace.calls.size()), {cell, block, std::move(vertices)}));
  };
  for (std::int32_t i = 0; i < 3 && ground != Ground::empty; ++i) {
    for (std::int32_t j = 0; j < 3; ++j) {
      const Block block = ground == Ground::slanted ? static_cast<Block>(1 + (i + j) % 3) : 1;
      // Two ramps, cut near the middle: blocks, if there are three, meet in many ways.
      constexpr std::int32_t kEnd = kUnitsPerCell, kLow = kEnd / 3, kHigh = kEnd - 5;
      if (ground == Ground::solid) {
        add({i, j}, block, {kUnitSquare.begin(), kUnitSquare.end()});
      } else {
        add({i, j}, block, {{0, 0}, {kEnd, 0}, {kEnd, kHigh}, {0, kLow}});
        add({i, j}, ground == Ground::slanted ? block % 3 + 1 : block,
            {{0, kLow}, {kEnd, kHigh}, {kEnd, kEnd}, {0, kEnd}});
      }
    }
  }
  return trace;
}

World worldOf(const Trace& trace) {
  oracle::Player player(trace.preserve);
  playAll(trace, player);
  return player.world();
}

std::int64_t anyStep(Random& random) {
  constexpr std::array<std::int64_t, 6> kSteps{8'192, 10'007, 977, 37, 5, 1};
  return kSteps[random.below(kSteps.size())];
}

Trace strokesOnGround(int, Random random) {
  constexpr std::array kGrounds{Ground::empty, Ground::solid, Ground::slanted, Ground::halved};
  Trace trace = groundOf(kGrounds[random.below(kGrounds.size())]);
  const std::int64_t step = anyStep(random);
  for (int k = random.between(1, 6); k > 0; --k) trace.calls.push_back(Call::byBrush(strokeNear(random, step)));
  return trace;
}

Trace oneStroke(int, Random random) {
  const std::int64_t step = anyStep(random);
  return {{}, {Call::byBrush(strokeNear(random, step))}};
}

bool isOneStroke(const Trace& trace) { return trace.calls.size() == 1 && hasBrushes(trace); }

}  // namespace

World AnyStrokes::ground() const {
  Trace start = *this;
  std::erase_if(start.calls, [](const Call& call) { return call.kind == Call::Kind::brush; });
  return worldOf(start);
}

Strokes AnyStrokes::strokes() const {
  Strokes all;
  for (const Call& call : calls)
    if (call.kind == Call::Kind::brush) all.push_back(call.brush);
  return all;
}

rc::Gen<AnyStrokes> AnyStrokes::arbitrary() {
  return rc::gen::map(traces(strokesOnGround, {}), [](Trace&& trace) { return AnyStrokes{std::move(trace)}; });
}

rc::Gen<AnyRegion> AnyRegion::arbitrary() {
  return rc::gen::map(traces(oneStroke, isOneStroke), [](Trace&& trace) { return AnyRegion{std::move(trace)}; });
}

World worldOf(Ground ground) { return worldOf(groundOf(ground)); }

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

}  // namespace lgs::test
