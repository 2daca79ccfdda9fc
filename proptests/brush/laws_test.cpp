// Laws 8 to 11: what a brush leaves of the ground.
#include "oracle/check/reach.h"
#include "proptests/brush/strokes.h"
#include "proptests/support/law.h"
#include "proptests/support/must.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace lgs::test {
namespace {

LGS_LAW(Brush, Law8RoundsByAUnitAtMost, 400, (const AnyStrokes& strokes)) {
  World world = worldOf(strokes.ground);
  for (const oracle::BrushEdit& edit : strokes.strokes) {
    const oracle::Scene before = sceneOf(world);
    must(stroke(world, edit));
    failIf(farFromExact(before, edit, sceneOf(world)));
  }
}

/// Makes the strokes. Looks at what stood before each of them and what stands afterwards.
template <class Look>
void afterEach(const AnyStrokes& strokes, const Look& look) {
  World world = worldOf(strokes.ground);
  for (const oracle::BrushEdit& edit : strokes.strokes) {
    const auto before = standingIn(world);
    const auto result = must(stroke(world, edit));
    look(edit, result, before, standingIn(world));
  }
}

LGS_LAW(Brush, Law9WhatIsNotReachedStays, 3'000, (const AnyStrokes& strokes)) {
  afterEach(strokes,
            [](const oracle::BrushEdit& edit, const BrushResult& result, const auto& before, const auto& after) {
              for (const auto& [handle, standing] : before) {
                const auto now = after.find(handle);
                if (now != after.end() && now->second == standing) continue;
                const bool isTold = std::ranges::find(result.bent, handle) != result.bent.end();
                failUnless(isTold || oracle::mayMeet(edit, {standing.cell, standing.block, standing.vertices}),
                           "a polygon changed that the region does not reach");
              }
            });
}

LGS_LAW(Brush, TheResultTellsWhatHappened, 1'000, (const AnyStrokes& strokes)) {
  afterEach(strokes, [](const oracle::BrushEdit&, const BrushResult& result, const auto& before, const auto& after) {
    std::set<PolygonHandle> old(result.went.begin(), result.went.end());
    std::set<PolygonHandle> now(result.came.begin(), result.came.end());
    EXPECT_EQ(old.size(), result.went.size());
    for (const BrushChange& change : result.changed) {
      EXPECT_TRUE(old.insert(change.old).second) << "it is told twice";
      EXPECT_FALSE(change.now.empty());
      now.insert(change.now.begin(), change.now.end());
    }
    for (const PolygonHandle handle : result.bent) EXPECT_TRUE(old.contains(handle));
    for (const auto& [handle, standing] : before) {
      if (!old.contains(handle)) {
        ASSERT_TRUE(after.contains(handle)) << "gone, and not told";
        EXPECT_EQ(after.at(handle), standing);
      } else if (after.contains(handle)) {
        EXPECT_NE(after.at(handle).block, standing.block) << "told, and the same";
      }
    }
    for (const auto& [handle, standing] : after) EXPECT_TRUE(before.contains(handle) || now.contains(handle));
    for (const PolygonHandle handle : now) EXPECT_TRUE(after.contains(handle));
  });
}

/// The region, as far as it lies over the ground.
Region within(Region region) {
  constexpr std::int64_t kEnd = 3 * kUnitsPerCell;
  for (Ring& ring : region.rings)
    for (Point& p : ring) p = {std::clamp<std::int64_t>(p.x, 0, kEnd), std::clamp<std::int64_t>(p.y, 0, kEnd)};
  return region;
}

LGS_LAW(Brush, Law10CarveAndPaintLeavesNoSeam, 3'000, (const AnyRegion& any)) {
  for (const Ground ground : {Ground::solid, Ground::halved}) expectNoSeam(ground, within(any.region));
}

LGS_LAW(Brush, Law10AnotherBlockLeavesNoSeam, 3'000, (const AnyStrokes& strokes)) {
  World world = worldOf(Ground::slanted);
  const auto solid = outlines(world);
  for (const oracle::BrushEdit& edit : strokes.strokes) {
    must(paint(world, within(regionOf(edit)), edit.block, PaintMode::replace));
    EXPECT_EQ(outlines(world), solid);
  }
}

LGS_LAW(Brush, Law11IsNeverRefused, 3'000, (const AnyStrokes& strokes)) {
  World world = worldOf(strokes.ground);
  for (const oracle::BrushEdit& edit : strokes.strokes) {
    must(stroke(world, edit));
    world.commit();
  }
}

}  // namespace
}  // namespace lgs::test
