// The world changed as a whole, in ways after which the outline is known from the outline before: shifted by whole
// cells, turned, mirrored, with other block numbers, with a polygon split in two.
#include "random_traces.h"
#include "support.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <functional>

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

}  // namespace
}  // namespace lgs::engine_test
