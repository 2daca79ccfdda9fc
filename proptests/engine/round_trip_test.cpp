// Ways there and back: a world through a trace's text, coordinates through floats. (Imported maps:
// proptests/tiled/round_trip_test.cpp.)
#include "oracle/generate/generator.h"
#include "oracle/trace/dump.h"
#include "oracle/trace/model.h"
#include "oracle/trace/player.h"
#include "random_traces.h"
#include "scale.h"
#include "support.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace lgs::engine_test {
namespace {

using oracle::Edit;
using oracle::Random;
using oracle::Trace;

/// What stands in these cells, as the world itself says, in the form of a trace.
Trace traceOf(const World& world, const std::set<Cell>& cells, const oracle::PreservePairs& preserve) {
  Trace trace{preserve, {}};
  for (const Cell& cell : cells)
    for (const auto& [handle, block, vertices] : polygonsIn(world, cell))
      trace.edits.push_back(Edit::add("p" + std::to_string(handle.packed()), {cell, block, vertices}));
  return trace;
}

using Standing = std::multiset<std::tuple<Cell, Block, LocalPolygon>>;

Standing standing(const World& world, const std::set<Cell>& cells) {
  Standing out;
  for (const Cell& cell : cells)
    for (auto& [handle, block, vertices] : polygonsIn(world, cell)) out.emplace(cell, block, vertices);
  return out;
}

RC_GTEST_PROP(RoundTrip, WorldToTraceToWorld, ()) {
  forRandomTraces("world", 20, {}, [](const Trace& trace, Random) -> std::optional<std::string> {
    std::set<Cell> cells;
    for (const Edit& edit : trace.edits)
      if (edit.kind == Edit::Kind::add) cells.insert(edit.polygon.cell);
    oracle::Player player(trace.preserve);
    if (!oracle::play(trace, player)) return "refused";

    const Trace written = traceOf(player.world(), cells, trace.preserve);
    const oracle::ParsedTrace read = oracle::parseTrace(oracle::printTrace(written));
    if (read.error) return "what was written can not be read: " + read.error->text;
    if (read.trace != written) return "another trace is read than was written";
    oracle::Player again(read.trace.preserve);
    if (const auto done = oracle::play(read.trace, again); !done)
      return "refused the second time: " + done.error().text;
    if (standing(again.world(), cells) != standing(player.world(), cells)) return "other polygons stand there";
    return differenceOf(oracle::outlineOf(player.world()), oracle::outlineOf(again.world()));
  });
}

/// Places a polygon of real coordinates, and takes it away. What it was on the lattice.
template <class Real>
tl::expected<LocalPolygon, Error> onLattice(World& world, const std::vector<RealPoint<Real>>& polygon) {
  const auto handle = world.add({}, std::span<const RealPoint<Real>>(polygon), 1);
  if (!handle) return tl::unexpected(handle.error());
  const auto vertices = world.polygon(*handle)->vertices;
  const LocalPolygon result(vertices.begin(), vertices.end());
  static_cast<void>(world.remove(*handle));
  return result;
}

/// Each coordinate of a lattice polygon at most `away` lattice units off, often as much as that.
template <class Real>
std::vector<RealPoint<Real>> near(const LocalPolygon& polygon, Random& random, double away) {
  std::vector<RealPoint<Real>> out;
  const auto real = [&](std::int32_t v) { return static_cast<Real>((v + away * (random.below(5) - 2) / 2) / U); };
  for (const LocalPoint& v : polygon) {
    const Real x = real(v.x);
    out.push_back({x, real(v.y)});
  }
  return out;
}

/// `below` a half, so that rounding gives the polygon again.
template <class Real>
void realsComeBack(const LocalPolygon& polygon, Random& random, double below) {
  static World world;
  for (const double away : {0.0, below}) {
    const auto rounded = onLattice<Real>(world, near<Real>(polygon, random, away));
    RC_ASSERT(rounded.has_value());
    RC_ASSERT(*rounded == polygon);
  }
}

RC_GTEST_PROP(RoundTrip, LatticeToFloatsToLattice, ()) {
  Random random(anySeed());
  for (std::int64_t k = 0; k < scaled(5); ++k) {
    for (const Edit& edit : withoutRefused(oracle::randomCase({1, 1, 8}, random.next())).edits) {
      if (edit.kind != Edit::Kind::add) continue;
      realsComeBack<float>(edit.polygon.vertices, random, 0.49);  // it has room for at least 1/256 of a unit
      realsComeBack<double>(edit.polygon.vertices, random, 0.499'999);
    }
  }
}

/// A coordinate that rounds to one of the cell's lattice points, often one where rounding is easily wrong.
template <class Real>
Real anyReal(Random& random) {
  constexpr Real kEnds[] = {0, Real(-0.0), 1, std::numeric_limits<Real>::denorm_min(),
                            -std::numeric_limits<Real>::denorm_min()};
  if (random.chance(15)) return kEnds[random.below(std::size(kEnds))];
  if (random.chance(30)) return static_cast<Real>(random.next() >> 11) / static_cast<Real>(std::uint64_t{1} << 53);
  // A lattice point, or between two of them (half a unit outside the cell, too), or one step of Real from there.
  const std::int32_t halves = random.chance(50) ? random.below(2 * U + 3) - 1
                                                : random.pick(std::vector{-1, 1, 2, 3, 2 * U - 1, 2 * U, 2 * U + 1});
  const Real real = static_cast<Real>(halves) / (2 * U);
  const int step = halves == -1 ? 1 : halves == 2 * U + 1 ? -1 : random.below(3) - 1;  // what lies outside: inwards
  return step == 0 ? real : std::nextafter(real, step < 0 ? Real(-1) : Real(2));
}

/// What is wrong with `v`, of the lattice, as what became of `real`. All of it is exact; v - units would not be.
template <class Real>
std::optional<std::string> wrongRounding(Real real, std::int32_t v) {
  const double units = double{real} * U, below = v - 0.5, above = v + 0.5;
  const bool isNear = below <= units && units <= above;
  if (isNear && units != (units > 0 ? above : below)) return std::nullopt;
  return fmt::format("{:a} is {} units, and becomes {}: {}", real, units, v,
                     isNear ? "not away from zero" : "more than half a unit away");
}

/// To the lattice and back, which is at most half a unit away; and again, which changes nothing.
template <class Real>
void realsAreRounded(World& world, Random& random) {
  const RealPoint<Real> p{anyReal<Real>(random), anyReal<Real>(random)};
  // A triangle with that side of the cell, lower or upper, that is farther from it.
  const Real side = p.y < Real(0.5) ? 1 : 0;
  const std::vector<RealPoint<Real>> polygon{p, {side, side}, {1 - side, side}};
  const auto rounded = onLattice<Real>(world, polygon);
  if (!rounded) RC_FAIL(fmt::format("({:a}, {:a}): {}", p.x, p.y, message(rounded.error())));
  const LocalPoint v = (*rounded)[0];
  for (const auto& problem : {wrongRounding(p.x, v.x), wrongRounding(p.y, v.y)})
    if (problem) RC_FAIL(*problem);
  std::vector<RealPoint<Real>> back;
  for (const LocalPoint& q : *rounded) back.push_back({static_cast<Real>(q.x) / U, static_cast<Real>(q.y) / U});
  const auto again = onLattice<Real>(world, back);
  RC_ASSERT(again.has_value());
  RC_ASSERT(*again == *rounded);
}

RC_GTEST_PROP(RoundTrip, FloatsToLatticeToFloats, ()) {
  World world;
  Random random(anySeed());
  for (std::int64_t k = 0; k < scaled(200); ++k) {
    realsAreRounded<float>(world, random);
    realsAreRounded<double>(world, random);
  }
}

}  // namespace
}  // namespace lgs::engine_test
