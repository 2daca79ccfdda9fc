// The world changed as a whole, in ways after which the outline is known from the outline before: with a polygon
// split in two, with cells and polygons united. Moved, turned and mirrored worlds: oracle/check/laws/twins.cpp.
#include "oracle/generate/generator.h"
#include "oracle/trace/model.h"
#include "proptests/support/law.h"
#include "proptests/support/played.h"
#include "proptests/support/traces.h"
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace lgs::test {
namespace {

using oracle::Call;
using oracle::Outline;
using oracle::OutlineSegment;
using oracle::Random;
using oracle::Trace;

Outline mapPoints(Outline outline, const std::function<Point(Point)>& map) {
  for (OutlineSegment& s : outline) {
    s.start = map(s.start);
    s.end = map(s.end);
    if (s.ghost1) s.ghost1 = map(*s.ghost1);
    if (s.ghost2) s.ghost2 = map(*s.ghost2);
  }
  return outline;
}

template <class Map>
Trace mapPolygons(Trace trace, Map&& map) {
  for (Call& edit : trace.calls) {
    if (edit.kind != Call::Kind::add) continue;
    oracle::ScenePolygon polygon = edit.polygon();
    map(polygon);
    edit = Call::add(edit.name(), std::move(polygon));
  }
  return trace;
}

/// Two polygons that a chord between two vertices makes of one, if there is such a chord; a random one.
std::optional<std::pair<LocalPolygon, LocalPolygon>> split(const LocalPolygon& polygon, Random& random) {
  using D = std::ptrdiff_t;
  const std::size_t n = polygon.size();
  for (int attempt = 0; attempt < 6 && n > 3; ++attempt) {
    std::size_t a = random.below(n);
    std::size_t b = random.below(n);
    if (a > b) std::swap(a, b);
    if (b - a < 2 || n - (b - a) < 2) continue;
    const LocalPolygon one(polygon.begin() + static_cast<D>(a), polygon.begin() + static_cast<D>(b) + 1);
    LocalPolygon two(polygon.begin() + static_cast<D>(b), polygon.end());
    two.insert(two.end(), polygon.begin(), polygon.begin() + static_cast<D>(a) + 1);
    if (oracle::faultOf(one) || oracle::faultOf(two) || oracle::overlap(one, two)) continue;
    return std::pair(one, two);
  }
  return std::nullopt;
}

/// Some of the polygons in two halves, except where a polygon keeps its overlap with its own block.
Trace withPolygonsSplit(const Trace& trace, Random& random) {
  Trace parts{trace.preserve, {}};
  std::vector<std::string> halved;
  for (const Call& edit : trace.calls) {
    const bool isHalved = std::erase(halved, edit.name()) > 0;
    if (isHalved && edit.kind == Call::Kind::remove) parts.calls.push_back(Call::remove(edit.name() + "'"));
    const Block block = edit.polygon().block;
    const bool maySplit = edit.kind == Call::Kind::add && !trace.preserve(block, block);
    const auto halves = maySplit ? split(edit.polygon().vertices, random) : std::nullopt;
    if (!halves) {
      parts.calls.push_back(edit);
      continue;
    }
    parts.calls.push_back(Call::add(edit.name(), {edit.polygon().cell, block, halves->first}));
    parts.calls.push_back(Call::add(edit.name() + "'", {edit.polygon().cell, block, halves->second}));
    halved.push_back(edit.name());
  }
  return parts;
}

LGS_LAW(Metamorphic, SplitAlongAChord, 2'000, (const GoodTrace& trace, Chance chance)) {
  expectSame(outlineAfter(trace), outlineAfter(withPolygonsSplit(trace, chance)));
}

/// The trace without the polygons that have an odd coordinate: what is left can be drawn at half the size.
Trace withEvenPolygons(const Trace& trace) {
  Trace even{trace.preserve, {}};
  std::set<std::string> dropped;
  for (const Call& edit : trace.calls) {
    if (edit.kind == Call::Kind::add) {
      const bool isOdd = std::ranges::any_of(edit.polygon().vertices, [](LocalPoint v) { return (v.x | v.y) & 1; });
      if (!isOdd) dropped.erase(edit.name());
      if (isOdd) dropped.insert(edit.name());
    }
    if (edit.kind == Call::Kind::commit || !dropped.contains(edit.name())) even.calls.push_back(edit);
  }
  return even;
}

/// At half the size: four cells become one, and what lay on the rims between them lies inside. Even polygons only.
Trace withCellsUnited(const Trace& trace) {
  return mapPolygons(trace, [](oracle::ScenePolygon& p) {
    for (LocalPoint& v : p.vertices) v = {(v.x + (p.cell.i & 1) * U) / 2, (v.y + (p.cell.j & 1) * U) / 2};
    p.cell = {p.cell.i >> 1, p.cell.j >> 1};
  });
}

LGS_LAW(Metamorphic, FourCellsUnitedInOne, 2'000, (const GoodTrace& any)) {
  const Trace trace = withEvenPolygons(any);
  const auto halve = [](Point p) { return Point{p.x / 2, p.y / 2}; };
  expectSame(mapPoints(outlineAfter(trace), halve), outlineAfter(withCellsUnited(trace)));
}

/// One polygon of two that share exactly one edge, if that is simple.
std::optional<LocalPolygon> united(const LocalPolygon& a, const LocalPolygon& b) {
  for (std::size_t k = 0; k < a.size(); ++k) {
    const LocalPoint from = a[k], to = a[(k + 1) % a.size()];
    for (std::size_t m = 0; m < b.size(); ++m) {
      if (b[m] != to || b[(m + 1) % b.size()] != from) continue;
      LocalPolygon whole;  // all of `a` from `to` on, then what `b` has besides the two
      for (std::size_t n = 0; n < a.size(); ++n) whole.push_back(a[(k + 1 + n) % a.size()]);
      for (std::size_t n = 2; n < b.size(); ++n) whole.push_back(b[(m + n) % b.size()]);
      if (!oracle::faultOf(whole)) return whole;
    }
  }
  return std::nullopt;
}

/// Unites polygons of one cell and block, as long as there are two that share an edge. Says how many there were.
int unitePolygons(std::vector<Call>& adds, const oracle::PreservePairs& preserve) {
  int count = 0;
  for (std::size_t k = 0; k < adds.size(); ++k) {
    for (std::size_t m = 0; m < adds.size(); ++m) {
      const oracle::ScenePolygon p = adds[k].polygon(), q = adds[m].polygon();
      if (m == k || p.cell != q.cell || p.block != q.block || preserve(p.block, p.block)) continue;
      const auto whole = united(p.vertices, q.vertices);
      if (!whole) continue;
      adds[k].comes[0].shape[0] = *whole;
      adds.erase(adds.begin() + static_cast<std::ptrdiff_t>(m));
      if (m < k) --k;
      ++count;
      m = static_cast<std::size_t>(-1);  // from the start: the new one may share edges with those before
    }
  }
  return count;
}

// The cells are united first, so that polygons of what were two cells become one.
std::vector<Call> survivorsInUnitedCells(const Trace& trace) {
  std::vector<Call> adds;
  for (const auto& [name, edit] : survivors(withCellsUnited(withEvenPolygons(trace)))) adds.push_back(edit);
  return adds;
}

LGS_LAW(Metamorphic, PolygonsOfTwoCellsUnited, 2'000, (const GoodTrace& trace)) {
  const Trace parts{trace.preserve, survivorsInUnitedCells(trace)};
  Trace whole = parts;
  unitePolygons(whole.calls, trace.preserve);
  expectSame(outlineAfter(parts), outlineAfter(whole));
}

TEST(Metamorphic, PolygonsToUniteAreNotRare) {
  int cases = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Trace trace = withoutRefused(oracle::randomCase({3, 3, 30}, seed));
    std::vector<Call> adds = survivorsInUnitedCells(trace);
    if (unitePolygons(adds, trace.preserve) > 0) ++cases;
  }
  EXPECT_GE(cases, 20);
}

}  // namespace
}  // namespace lgs::test
