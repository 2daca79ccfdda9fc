// Ways there and back: a world through a trace's text, coordinates through floats. (Imported maps:
// proptests/tiled/round_trip_test.cpp.)
#include "oracle/check/generator.h"
#include "oracle/check/model.h"
#include "oracle/trace/dump.h"
#include "oracle/trace/player.h"
#include "random_traces.h"
#include "scale.h"
#include "support.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
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

RC_GTEST_PROP(RoundTrip, FloatsToLatticeToFloats, ()) {
  Random random(anySeed());
  for (std::int64_t k = 0; k < scaled(5); ++k) {
    for (const Edit& edit : withoutRefused(oracle::randomCase({1, 1, 8}, random.next())).edits) {
      if (edit.kind != Edit::Kind::add) continue;
      realsComeBack<float>(edit.polygon.vertices, random, 0.49);  // it has room for at least 1/256 of a unit
      realsComeBack<double>(edit.polygon.vertices, random, 0.499'999);
    }
  }
}

}  // namespace
}  // namespace lgs::engine_test
