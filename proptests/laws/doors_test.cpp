// Calls come through many doors, and mean the same through each: a polygon by its vertices, in lattice units or reals;
// a shape of one or several polygons; a rectangle of cells; many at once; some in the place of others.
#include "oracle/trace/dump.h"
#include "proptests/support/law.h"
#include "proptests/support/played.h"
#include "proptests/support/traces.h"
#include "twins.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lgs::test {

using Kind = Call::Kind;

namespace {

using oracle::areAlike;
using oracle::Outcome;

/// What the parts gave, as the whole call would.
Outcome together(const Call& call, const Outcome& group) {
  Outcome whole;
  for (const Outcome& part : group.parts) {
    if (part.refusal)
      return {.refusal = part.refusal,
              .shape = {},
              .told = {},
              .handles = {},
              .changes = {},
              .chunks = {},
              .brushed = {},
              .parts = {}};
    whole.handles.insert(whole.handles.end(), part.handles.begin(), part.handles.end());
    whole.count += call.kind == Kind::fill ? 1 : 0;
  }
  return whole;
}

/// The error of a part, said of the whole call that takes many: the entry that is refused; and the one that made, or
/// removed, the other polygon of the error.
Error asOfMany(Error error, const Call& call, const std::vector<Outcome>& parts) {
  error.index = static_cast<std::int32_t>(parts.size()) - 1;
  for (std::size_t k = 0; k + 1 < parts.size(); ++k) {
    const bool removedIt = call.kind == Kind::removeMany && call.goes[k].handle == error.other;
    const bool placedIt = std::ranges::count(parts[k].handles, error.other) != 0;
    if (removedIt || placedIt) error.index2 = static_cast<std::int32_t>(k);
  }
  if (error.code == ErrorCode::overlap && error.index2 >= 0) error.other = {};  // a polygon that is undone
  return error;
}

LGS_LAW(Parts, MadeAtOnceOrOneByOneAreTheSame, 2'000,
        (const CallsAndMarks& before, const CallOfParts& drawn, const Calls& after, const Setting& setting)) {
  Caller atOnce = grown(setting, before), oneByOne = grown(setting, before);
  const Call resolved = atOnce.resolved(drawn.call);
  Call call = drawn.call;  // its cells are counted from the corner
  call.goes = resolved.goes;
  if (call.kind == Kind::exchange && call.goes.empty() && call.comes.empty()) return;  // it has no parts
  const bool areShapes = atOnce.makeShapes(resolved);
  ASSERT_EQ(oneByOne.makeShapes(resolved), areShapes);
  const std::uint64_t polygons = atOnce.world.stats().polygons;
  const bool takesFromElsewhere = std::ranges::any_of(call.goes, [&](const oracle::Named& named) {
    const auto cell = atOnce.world.cellOf(named.handle);
    return call.kind == Kind::exchange && cell && *cell != resolved.cells.min;
  });
  // A rectangle of several chunks does not go by rows: handles and ids come in another order.
  const bool isRectangle = call.kind == Kind::fill || call.kind == Kind::clear;
  const Outcome whole = atOnce.make(call), group = oneByOne.make(inParts(call));
  const Outcome parts = together(call, group);
  if (takesFromElsewhere) {  // its parts may
    EXPECT_TRUE(whole.refusal);
    return;
  }
  if (call.kind == Kind::clear && whole.refusal) {  // its parts are only what can be removed
    EXPECT_EQ(whole.refusal->code, ErrorCode::cellOutOfRange);
    return;
  }
  if (!areShapes) {
    EXPECT_TRUE(whole.refusal);
    return expectNoDifference(oneByOne, atOnce, after);
  }
  ASSERT_EQ(whole.refusal.has_value(), parts.refusal.has_value());
  if (!whole.refusal) {
    EXPECT_EQ(whole.handles.size(), parts.handles.size());
    EXPECT_TRUE(isRectangle || whole.handles == parts.handles);
    EXPECT_EQ(whole.count, call.kind == Kind::clear ? polygons - atOnce.world.stats().polygons : parts.count);
  } else if (call.kind == Kind::addMany || call.kind == Kind::removeMany) {
    const Error expected = asOfMany(*parts.refusal, call, group.parts);
    EXPECT_TRUE(areAlike(*whole.refusal, expected)) << message(*whole.refusal) << '\n' << message(expected);
  } else if (call.kind == Kind::fill && whole.refusal->code == ErrorCode::cellOutOfRange) {
    EXPECT_FALSE(inRange(whole.refusal->cell));  // it looks at the corners before it looks at any cell
  } else if (call.kind != Kind::exchange) {      // which may tell any of two faults
    EXPECT_EQ(whole.refusal->code, parts.refusal->code);
    EXPECT_EQ(whole.refusal->cell, parts.refusal->cell);
  }
  if (!isRectangle) return expectNoDifference(oneByOne, atOnce, after);
  for (Caller* caller : {&atOnce, &oneByOne}) caller->world.commit();
  EXPECT_TRUE(samePolygons(atOnce.world, oneByOne.world));
  EXPECT_EQ(oracle::outlineOf(atOnce.world), oracle::outlineOf(oneByOne.world));
}

}  // namespace
}  // namespace lgs::test
