// Commits of many edits at once, in rows across the borders of chunks: a commit then goes by whole rows of cells, and
// passes over what is buried. Against the naive reference, and by change lists on a mirror.
#include "oracle/reference/compare.h"
#include "oracle/reference/naive.h"
#include "oracle/trace/dump.h"
#include "oracle/trace/mirror.h"
#include "random_traces.h"
#include "scale.h"
#include "support.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>

namespace lgs::engine_test {
namespace {

using oracle::Random;

/// A strip of cells, edited in batches.
class Strip {
 public:
  Strip(Random& random, const oracle::PreservePairs& preserve)
      : random_(random), world_([&]() -> PreserveRelation {
          if (preserve.empty()) return {};
          return [preserve](Block a, Block b) { return preserve(a, b); };
        }()) {
    scene_.preserve = preserve;
    const std::int32_t i = random.below(40) - 50;
    const std::int32_t j = random.below(36) - 36;
    const std::int32_t height = 2 + random.below(5);
    cells_ = {{i, j}, {i + 30 + random.below(20), j + height}};
    solidPercent_ = random.chance(50) ? 90 : 30;
  }

  /// Changes some of the cells, and commits. What is wrong then, if anything.
  std::optional<std::string> batch() {
    const int percent = random_.chance(50) ? 100 : 3 + random_.below(60);
    for (const Cell& cell : cellsOf(cells_))
      if (random_.chance(percent)) change(cell);
    const Changes& changes = world_.commit();
    if (auto problem = mirror_.update(world_, changes)) return problem;
    scene_.polygons.clear();
    for (const auto& [cell, polygons] : there_)
      scene_.polygons.insert(scene_.polygons.end(), polygons.begin(), polygons.end());
    const oracle::Outline& expected = naive_(scene_).outline;
    return differenceOf(expected, oracle::outlineOf(world_));
  }

 private:
  void change(Cell cell) {
    removeAll(world_, cell);
    there_[cell].clear();
    if (random_.chance(15)) return;
    const oracle::PaletteShape& any = random_.pick(oracle::palette());
    const std::vector<LocalPolygon>& shape =
        random_.chance(solidPercent_) ? oracle::palette()[0].polygons : any.polygons;
    for (const LocalPolygon& polygon : shape) {
      const Block block = random_.below(3U);
      place(world_, cell, polygon, block);
      there_[cell].push_back({cell, block, polygon});
    }
  }

  Random& random_;
  World world_;
  CellRect cells_;
  int solidPercent_ = 0;
  std::map<Cell, std::vector<oracle::ScenePolygon>> there_;
  oracle::Scene scene_;
  oracle::NaiveReference naive_;
  oracle::Mirror mirror_;
};

void checkBatches(const oracle::PreservePairs& preserve) {
  Random random(anySeed());
  for (std::int64_t k = 0; k < scaled(2); ++k) {
    Strip strip(random, preserve);
    for (int batch = 0; batch < 4; ++batch)
      if (const auto problem = strip.batch()) RC_FAIL(*problem);
  }
}

RC_GTEST_PROP(Batches, AgreeWithTheNaiveReference, ()) { checkBatches({}); }

RC_GTEST_PROP(Batches, AgreeWithTheNaiveReferenceUnderPreserve, ()) {
  oracle::PreservePairs preserve;
  preserve.add(0, 1);
  if (*rc::gen::arbitrary<bool>()) preserve.add(2, 2);
  checkBatches(preserve);
}

}  // namespace
}  // namespace lgs::engine_test
