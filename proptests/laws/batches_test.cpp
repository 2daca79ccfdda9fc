// Commits of many edits at once, in rows across the borders of chunks: a commit then goes by whole rows of cells, and
// passes over what is buried. Against the naive reference, and by change lists on a mirror.
#include "proptests/support/law.h"
#include "proptests/support/played.h"
#include "proptests/support/traces.h"
#include "proptests/support/worlds.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace lgs::test {
namespace {

using oracle::Call;
using oracle::Random;
using oracle::Trace;

/// A strip of cells, edited in batches.
class Strip {
 public:
  Strip(Random random, const oracle::PreservePairs& preserve) : random_(random), trace_{preserve, {}} {
    const std::int32_t i = random_.below(40) - 50;
    const std::int32_t j = random_.below(36) - 36;
    const std::int32_t height = 2 + random_.below(5);
    cells_ = {{i, j}, {i + 30 + random_.below(20), j + height}};
    solidPercent_ = random_.chance(50) ? 90 : 30;
  }

  Trace inBatches(int batches) {
    for (int batch = 0; batch < batches; ++batch) {
      const int percent = random_.chance(50) ? 100 : 3 + random_.below(60);
      for (const Cell& cell : cellsOf(cells_))
        if (random_.chance(percent)) change(cell);
      trace_.calls.push_back(Call::commit());
    }
    return trace_;
  }

 private:
  void change(Cell cell) {
    for (const std::string& name : there_[cell]) trace_.calls.push_back(Call::remove(name));
    there_[cell].clear();
    if (random_.chance(15)) return;
    const oracle::NamedShape& any = random_.pick(oracle::degenerateShapes());
    const std::vector<LocalPolygon>& shape =
        random_.chance(solidPercent_) ? oracle::degenerateShapes()[0].polygons : any.polygons;
    for (const LocalPolygon& polygon : shape) {
      const std::string name = fmt::format("p{}", ++named_);
      trace_.calls.push_back(Call::add(name, {cell, random_.below(3U), polygon}));
      there_[cell].push_back(name);
    }
  }

  Random random_;
  Trace trace_;
  CellRect cells_;
  int solidPercent_ = 0;
  int named_ = 0;
  std::map<Cell, std::vector<std::string>> there_;
};

rc::Gen<Trace> batchesUnder(const oracle::PreservePairs& preserve) {
  return traces([=](int, Random random) { return Strip(random, preserve).inBatches(4); });
}

void agreesWithTheNaiveReference(const Trace& trace) { expectNoMismatch(trace, {.cgal = false, .unionAtEnd = true}); }

TEST(Batches, AgreeWithTheNaiveReference) { forAll(200, agreesWithTheNaiveReference, batchesUnder({})); }

TEST(Batches, AgreeWithTheNaiveReferenceUnderPreserve) {
  oracle::PreservePairs preserve;
  preserve.add(0, 1);
  forAll(100, agreesWithTheNaiveReference, batchesUnder(preserve));
  preserve.add(2, 2);
  forAll(100, agreesWithTheNaiveReference, batchesUnder(preserve));
}

}  // namespace
}  // namespace lgs::test
