// Chunks full of slants, where short lists of segments have room in the chunk (outline/segment_lists.h): random worlds
// are too small to have one. Against the naive reference, and by change lists on a mirror.
#include "oracle/calls/shapes.h"
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

void agreesWithTheNaiveReference(const Trace& trace) { expectNoMismatch(trace, {.cgal = false, .unionAtEnd = true}); }

TEST(Slants, AgreeWithTheNaiveReference) { forAll(30, agreesWithTheNaiveReference, traces(amongSlants, {})); }

}  // namespace
}  // namespace lgs::test
