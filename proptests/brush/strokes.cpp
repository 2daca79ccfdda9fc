#include "proptests/brush/strokes.h"

#include "oracle/generate/strokes.h"
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

Trace groundOf(Ground ground) {
  Trace trace;
  const auto add = [&](Cell cell, Block block, std::vector<LocalPoint> vertices) {
    trace.calls.push_back(Call::add("p" + std::to_string(trace.calls.size()), {cell, block, std::move(vertices)}));
  };
  for (std::int32_t i = 0; i < 3; ++i) {
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

// The one maker's, on a tight lattice.
Trace oneStroke(int, Random random) {
  const oracle::Tight lattice = oracle::tightAt(toWorld({1, 1}, {0, 0}), random);
  return {{}, {Call::byBrush({.rings = oracle::crossingRings(lattice, random)})}};
}

bool isOneStroke(const Trace& trace) { return trace.calls.size() == 1 && hasBrushes(trace); }

}  // namespace

rc::Gen<AnyRegion> AnyRegion::arbitrary() {
  return rc::gen::map(traces(oneStroke, isOneStroke), [](Trace&& trace) { return AnyRegion{std::move(trace)}; });
}

World worldOf(Ground ground) { return worldOf(groundOf(ground)); }

std::map<PolygonHandle, Standing> standingIn(const World& world) {
  std::map<PolygonHandle, Standing> all;
  world.forEachPolygon([&](Cell cell, const PlacedPolygon& p) {
    all[p.handle] = {cell, p.block, {p.vertices.begin(), p.vertices.end()}};
  });
  return all;
}

}  // namespace lgs::test
