// The world changed as a whole, in ways after which the outline is known from the outline before: shifted by whole
// cells, turned, mirrored, with other block numbers, with a polygon split in two, with cells and polygons united.
#include "oracle/generate/generator.h"
#include "oracle/trace/model.h"
#include "random_traces.h"
#include "support.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

namespace lgs::engine_test {
namespace {

using oracle::Edit;
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

CellRect boundsOf(const Trace& trace) {
  CellRect r{{kMaxCell, kMaxCell}, {-kMaxCell, -kMaxCell}};
  for (const Edit& edit : trace.edits) {
    if (edit.kind != Edit::Kind::add) continue;
    const Cell c = edit.polygon.cell;
    r = {{std::min(r.min.i, c.i), std::min(r.min.j, c.j)}, {std::max(r.max.i, c.i), std::max(r.max.j, c.j)}};
  }
  return r;
}

/// The trace with its lower left cell at this one.
Trace movedTo(Trace trace, Cell target) {
  const CellRect bounds = boundsOf(trace);
  for (Edit& edit : trace.edits)
    if (edit.kind == Edit::Kind::add)
      edit.polygon.cell = {edit.polygon.cell.i - bounds.min.i + target.i,
                           edit.polygon.cell.j - bounds.min.j + target.j};
  return trace;
}

template <class Map>
Trace mapPolygons(Trace trace, Map&& map) {
  for (Edit& edit : trace.edits)
    if (edit.kind == Edit::Kind::add) map(edit.polygon);
  return trace;
}

RC_GTEST_PROP(Metamorphic, ShiftedByWholeCells, ()) {
  forRandomTraces("shift", 20, {}, [](const Trace& trace, Random random) -> std::optional<std::string> {
    const CellRect bounds = boundsOf(trace);
    if (isEmpty(bounds)) return std::nullopt;
    const auto target = [&](std::int32_t size) {
      const std::vector<std::int32_t> starts{
          0,         -size,           32 - random.below(size + 1), -64 - random.below(size + 1),
          -kMaxCell, kMaxCell - size, random.below(1 << 20)};
      return random.pick(starts);
    };
    const std::int32_t i = target(bounds.max.i - bounds.min.i);
    const std::int32_t j = target(bounds.max.j - bounds.min.j);
    const std::int64_t dx = (std::int64_t{i} - bounds.min.i) * U, dy = (std::int64_t{j} - bounds.min.j) * U;
    return differenceOf(mapPoints(outlineAfter(trace),
                                  [=](Point p) {
                                    return Point{p.x + dx, p.y + dy};
                                  }),
                        outlineAfter(movedTo(trace, {i, j})));
  });
}

RC_GTEST_PROP(Metamorphic, TurnedByAQuarter, ()) {
  forRandomTraces("turn", 20, {}, [](const Trace& original, Random random) {
    const Trace trace = movedTo(original, {random.below(40) - 36, random.below(40) - 36});
    const Trace turned = mapPolygons(trace, [](oracle::ScenePolygon& p) {
      p.cell = {-p.cell.j - 1, p.cell.i};
      for (LocalPoint& v : p.vertices) v = {U - v.y, v.x};
    });
    return differenceOf(mapPoints(outlineAfter(trace), [](Point p) { return Point{-p.y, p.x}; }), outlineAfter(turned));
  });
}

RC_GTEST_PROP(Metamorphic, Mirrored, ()) {
  forRandomTraces("mirror", 20, {}, [](const Trace& original, Random random) {
    const Trace trace = movedTo(original, {random.below(40) - 36, random.below(40) - 36});
    const Trace mirrored = mapPolygons(trace, [](oracle::ScenePolygon& p) {
      p.cell.i = -p.cell.i - 1;
      for (LocalPoint& v : p.vertices) v.x = U - v.x;
      std::reverse(p.vertices.begin(), p.vertices.end());
    });
    Outline expected = mapPoints(outlineAfter(trace), [](Point p) { return Point{-p.x, p.y}; });
    for (OutlineSegment& s : expected) {
      std::swap(s.start, s.end);
      std::swap(s.ghost1, s.ghost2);
    }
    return differenceOf(expected, outlineAfter(mirrored));
  });
}

RC_GTEST_PROP(Metamorphic, BlocksRenamed, ()) {
  forRandomTraces("blocks", 20, {}, [](const Trace& trace, Random random) {
    const Block factor = 2 * random.below(1U << 31) + 1;  // odd: no two blocks become one
    const Block offset = random.below(0xffff'ffffU);
    const auto rename = [=](Block b) { return b * factor + offset; };
    Trace renamed = mapPolygons(trace, [&](oracle::ScenePolygon& p) { p.block = rename(p.block); });
    renamed.preserve = {};
    for (const auto& [a, b] : trace.preserve.pairs()) renamed.preserve.add(rename(a), rename(b));
    Outline expected = outlineAfter(trace);
    for (OutlineSegment& s : expected) s.block = rename(s.block);
    return differenceOf(expected, outlineAfter(renamed));
  });
}

RC_GTEST_PROP(Metamorphic, VerticesStartElsewhere, ()) {
  forRandomTraces("rotation", 10, {}, [](const Trace& trace, Random random) {
    const Trace rotated = mapPolygons(trace, [&](oracle::ScenePolygon& p) {
      const auto by = static_cast<std::ptrdiff_t>(random.below(p.vertices.size()));
      std::rotate(p.vertices.begin(), p.vertices.begin() + by, p.vertices.end());
    });
    return differenceOf(outlineAfter(trace), outlineAfter(rotated));
  });
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

RC_GTEST_PROP(Metamorphic, SplitAlongAChord, ()) {
  forRandomTraces("split", 20, {}, [](const Trace& trace, Random random) {
    Trace parts{trace.preserve, {}};
    std::vector<std::string> halved;
    for (const Edit& edit : trace.edits) {
      const bool isHalved = std::erase(halved, edit.name) > 0;
      if (isHalved && edit.kind == Edit::Kind::remove) parts.edits.push_back(Edit::remove(edit.name + "'"));
      const Block block = edit.polygon.block;
      if (edit.kind == Edit::Kind::add && !trace.preserve(block, block)) {
        if (const auto two = split(edit.polygon.vertices, random)) {
          parts.edits.push_back(Edit::add(edit.name, {edit.polygon.cell, block, two->first}));
          parts.edits.push_back(Edit::add(edit.name + "'", {edit.polygon.cell, block, two->second}));
          halved.push_back(edit.name);
          continue;
        }
      }
      parts.edits.push_back(edit);
    }
    return differenceOf(outlineAfter(trace), outlineAfter(parts));
  });
}

/// The trace without the polygons that have an odd coordinate: what is left can be drawn at half the size.
Trace withEvenPolygons(const Trace& trace) {
  Trace even{trace.preserve, {}};
  std::set<std::string> dropped;
  for (const Edit& edit : trace.edits) {
    if (edit.kind == Edit::Kind::add) {
      const bool isOdd = std::ranges::any_of(edit.polygon.vertices, [](LocalPoint v) { return (v.x | v.y) & 1; });
      if (!isOdd) dropped.erase(edit.name);
      if (isOdd) dropped.insert(edit.name);
    }
    if (edit.kind == Edit::Kind::commit || !dropped.contains(edit.name)) even.edits.push_back(edit);
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

RC_GTEST_PROP(Metamorphic, FourCellsUnitedInOne, ()) {
  forRandomTraces("cells", 20, {}, [](const Trace& original, Random) {
    const Trace trace = withEvenPolygons(original);
    return differenceOf(mapPoints(outlineAfter(trace),
                                  [](Point p) {
                                    return Point{p.x / 2, p.y / 2};
                                  }),
                        outlineAfter(withCellsUnited(trace)));
  });
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
int unitePolygons(std::vector<Edit>& adds, const oracle::PreservePairs& preserve) {
  int count = 0;
  for (std::size_t k = 0; k < adds.size(); ++k) {
    for (std::size_t m = 0; m < adds.size(); ++m) {
      const oracle::ScenePolygon &p = adds[k].polygon, &q = adds[m].polygon;
      if (m == k || p.cell != q.cell || p.block != q.block || preserve(p.block, p.block)) continue;
      const auto whole = united(p.vertices, q.vertices);
      if (!whole) continue;
      adds[k].polygon.vertices = *whole;
      adds.erase(adds.begin() + static_cast<std::ptrdiff_t>(m));
      if (m < k) --k;
      ++count;
      m = static_cast<std::size_t>(-1);  // from the start: the new one may share edges with those before
    }
  }
  return count;
}

// The cells are united first, so that polygons of what were two cells become one.
std::vector<Edit> survivorsInUnitedCells(const Trace& trace) {
  std::vector<Edit> adds;
  for (const auto& [name, edit] : survivors(withCellsUnited(withEvenPolygons(trace)))) adds.push_back(edit);
  return adds;
}

RC_GTEST_PROP(Metamorphic, PolygonsOfTwoCellsUnited, ()) {
  forRandomTraces("union", 20, {}, [](const Trace& trace, Random) {
    Trace parts{trace.preserve, survivorsInUnitedCells(trace)};
    Trace whole = parts;
    unitePolygons(whole.edits, trace.preserve);
    return differenceOf(outlineAfter(parts), outlineAfter(whole));
  });
}

TEST(Metamorphic, PolygonsToUniteAreNotRare) {
  int cases = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Trace trace = withoutRefused(oracle::randomCase({3, 3, 30}, seed));
    std::vector<Edit> adds = survivorsInUnitedCells(trace);
    if (unitePolygons(adds, trace.preserve) > 0) ++cases;
  }
  EXPECT_GE(cases, 20);
}

}  // namespace
}  // namespace lgs::engine_test
