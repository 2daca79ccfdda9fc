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

/// A chunk full of slants, and a row of cells around it. Then a few cells get other shapes, with few segments or many.
Trace amongSlants(int, Random random) {
  Trace trace;
  const std::int32_t i = 32 * (random.below(3) - 1), j = 32 * (random.below(3) - 1);
  const CellRect cells{{i - 1, j - 1}, {i + 32, j + 32}};
  Call fill = Call::of(Call::Kind::fill);
  fill.cells = cells;
  const LocalPolygon ramp{{0, 0}, {kUnitsPerCell, 0}, {kUnitsPerCell, kUnitsPerCell}};
  fill.comes = {{cells.min, {oracle::turned(ramp, random.below(8))}, 0, 0, {}}};
  trace.calls = {fill, Call::commit()};
  const Cell near{i + random.below(28), j + random.below(28)};
  int named = 0;
  for (int batch = 0; batch < 8; ++batch) {
    if (random.chance(20)) trace.calls.push_back(Call::of(random.chance(50) ? Call::Kind::mark : Call::Kind::rollBack));
    for (int edits = 1 + random.below(6); edits != 0; --edits) {
      Call clear = Call::of(Call::Kind::clear);
      const Cell cell{near.i + random.below(4), near.j + random.below(4)};
      clear.cells = {cell, cell};
      trace.calls.push_back(clear);
      if (random.chance(15)) continue;
      for (const LocalPolygon& polygon : random.pick(oracle::degenerateShapes()).polygons)
        trace.calls.push_back(Call::add(fmt::format("p{}", ++named), {cell, 0, polygon}));
    }
    trace.calls.push_back(Call::commit());
  }
  return trace;
}

TEST(Batches, AgreeWithTheNaiveReferenceAmongSlants) {
  forAll(30, agreesWithTheNaiveReference, traces(amongSlants, {}));
}

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
