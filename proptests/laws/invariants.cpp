#include "invariants.h"

#include "oracle/calls/random.h"
#include "oracle/reference/vector.h"
#include "oracle/reference/words.h"

#include <vector>

namespace lgs::test {
namespace {

using oracle::inWords;
using oracle::operator-;
using Complaint = std::optional<std::string>;

Complaint brokenLink(const World& world, const Segment& s) {
  const auto complaint = [&](const char* what) { return inWords(s.start, s.end) + what; };
  const auto before = world.segment(s.predecessor), after = world.segment(s.successor);
  if (!before || !after) return complaint(" has a link to nothing");
  if (before->successor != s.id || after->predecessor != s.id) return complaint(" has a link that is not mutual");
  if (before->end != s.start || after->start != s.end)
    return complaint(" has a link to a segment that does not meet it");
  if (before->start != s.ghost1 || after->end != s.ghost2)
    return complaint(" has a ghost that is not its neighbour's end");
  return std::nullopt;
}

// Sums are modulo 2^64; their true values are far below that.
std::uint64_t doubleArea(const std::vector<Point>& cycle) {
  std::uint64_t sum = 0;
  for (std::size_t k = 0; k < cycle.size(); ++k) {
    const Point a = cycle[k], b = cycle[k + 1 == cycle.size() ? 0 : k + 1];
    sum += static_cast<std::uint64_t>(a.x * b.y) - static_cast<std::uint64_t>(b.x * a.y);
  }
  return sum;
}

/// A number for a point, so mixed that sums of them are equal only where the points are.
std::uint64_t mixed(Point p) {
  return oracle::Random(oracle::Random(static_cast<std::uint64_t>(p.x)).next() ^ static_cast<std::uint64_t>(p.y))
      .next();
}

/// Vertices by the cells of a rectangle that they touch.
class Vertices {
 public:
  explicit Vertices(const CellRect& cells)
      : min_(cells.min),
        columns_(std::int64_t{cells.max.i} - min_.i + 1),
        rows_(std::int64_t{cells.max.j} - min_.j + 1),
        touching_(static_cast<std::size_t>(columns_ * rows_)) {}

  void add(Point p) {
    const auto i = oracle::cellIndex(p.x), j = oracle::cellIndex(p.y);
    const bool onColumn = p.x == i * kUnitsPerCell, onRow = p.y == j * kUnitsPerCell;
    for (std::int64_t di = onColumn ? -1 : 0; di <= 0; ++di)
      for (std::int64_t dj = onRow ? -1 : 0; dj <= 0; ++dj)
        if (const auto k = indexOf(i + di, j + dj)) touching_[*k].push_back(p);
  }
  /// One inside the segment, which lies in this cell.
  std::optional<Point> inside(const Segment& s) const {
    if (const auto k = indexOf(s.cell.i, s.cell.j))
      for (const Point& p : touching_[*k])
        if (p != s.start && p != s.end && oracle::isOnSegment(p, s.start, s.end)) return p;
    return std::nullopt;
  }

 private:
  std::optional<std::size_t> indexOf(std::int64_t i, std::int64_t j) const {
    const std::int64_t column = i - min_.i, row = j - min_.j;
    if (column < 0 || column >= columns_ || row < 0 || row >= rows_) return std::nullopt;
    return static_cast<std::size_t>(row * columns_ + column);
  }
  Cell min_;
  std::int64_t columns_, rows_;
  std::vector<std::vector<Point>> touching_;
};

}  // namespace

std::optional<std::string> brokenInvariant(const World& world, const CellRect& cells) {
  Vertices vertices(cells);
  std::uint64_t polygonArea = 0, polygonCount = 0;
  std::vector<PlacedPolygon> polygons;
  std::vector<Point> points;
  for (std::int32_t j = cells.min.j; j <= cells.max.j; ++j) {
    for (std::int32_t i = cells.min.i; i <= cells.max.i; ++i) {
      world.polygons({i, j}, polygons);
      polygonCount += polygons.size();
      for (const PlacedPolygon& p : polygons) {
        points.clear();
        for (const LocalPoint v : p.vertices) points.push_back(toWorld({i, j}, v));
        for (const Point& v : points) vertices.add(v);
        polygonArea += doubleArea(points);
      }
    }
  }

  // Of the segments alone, before their links: where those are mutual and meet, the degrees can not but be equal.
  const std::vector<SegmentId> ids = world.segments();
  std::uint64_t starts = 0, ends = 0;
  for (const SegmentId id : ids) {
    const Segment s = *world.segment(id);
    if (s.id != id) return inWords(s.start, s.end) + " says another id";
    if (const auto v = vertices.inside(s)) return inWords(s.start, s.end) + " is not cut at " + inWords(*v);
    starts += mixed(s.start);
    ends += mixed(s.end);
  }
  if (starts != ends) return "at some vertex the in-degree is not the out-degree";
  for (const SegmentId id : ids)
    if (auto complaint = brokenLink(world, *world.segment(id))) return complaint;

  std::uint64_t loopArea = 0;
  std::vector<std::uint8_t> seen(world.maxSegmentId() + std::size_t{1});
  std::size_t inLoops = 0;
  for (const Loop& loop : world.loops()) {
    loopArea += doubleArea(loop.vertices);
    for (std::size_t k = 0; k < loop.segments.size(); ++k) {
      const Segment s = *world.segment(loop.segments[k]);
      if (s.start != loop.vertices[k] || s.successor != loop.segments[(k + 1) % loop.segments.size()])
        return "a loop is not closed at " + inWords(s.start, s.end);
      if (seen[s.id.value]++) return inWords(s.start, s.end) + " is in two loops";
      ++inLoops;
    }
  }
  if (inLoops != ids.size()) return "some segments are in no loop";
  if (loopArea != polygonArea) return "the loops enclose another area than the polygons have";

  const Stats stats = world.stats();
  if (stats.segments != ids.size() || stats.polygons != polygonCount) return "the statistics count something else";
  return std::nullopt;
}

}  // namespace lgs::test
