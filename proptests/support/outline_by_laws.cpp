#include "proptests/support/outline_by_laws.h"

#include "oracle/reference/naive.h"

namespace lgs::test {

oracle::Outline outlineByLaws(const World& world, const oracle::PreservePairs& preserve) {
  oracle::Scene scene{{}, preserve};
  world.forEachPolygon([&](Cell cell, const PlacedPolygon& p) {
    scene.polygons.push_back({cell, p.block, {p.vertices.begin(), p.vertices.end()}});
  });
  return oracle::NaiveReference()(scene).outline;
}

}  // namespace lgs::test
