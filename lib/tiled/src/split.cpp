// On each side of the line the outline of the polygon falls into arcs, which begin and end on the line. Walk along the
// line, just beside it: at the ends of the arcs you enter and leave the interior by turns. A stretch of the line joins
// each entrance to the exit that follows. These stretches close the arcs to the pieces.
#include "split.h"

#include "fraction.h"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <utility>

namespace lgs::tiled {
namespace {

/// A vertex of the outline, or the point where an edge crosses the line.
struct Node {
  Point point;
  int side = 0;               // 1: left of the line, -1: right of it, 0: on it
  std::int64_t distance = 0;  // from the line, times the length of its direction; of vertices only
  Fraction place;             // along the line, scaled alike; exact even where `point` is rounded
};

class Cutter {
 public:
  Cutter(const Polygon& ring, const Line& line, Obstacles obstacles) : line_(line), obstacles_(obstacles) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Node u = vertex(ring[i]), v = vertex(nextVertex(ring, i));
      nodes_.push_back(u);
      if (u.side * v.side < 0) nodes_.push_back(u.point < v.point ? crossing(u, v) : crossing(v, u));
    }
  }

  bool reaches(int side) const {
    return std::any_of(nodes_.begin(), nodes_.end(), [&](const Node& n) { return n.side == side; });
  }

  std::vector<Polygon> pieces(int side) const;

 private:
  struct Arc {
    std::size_t first, last;  // nodes on the line; all nodes between them are on one side of it
  };
  struct End {
    std::size_t arc;
    bool arrives;    // the outline comes to the line here; otherwise it leaves the line
    Fraction place;  // along the line
    Fraction slope;  // of the arc: how far it goes along the line, per distance from it
  };

  Node vertex(Point p) const {
    const Vector d = line_.direction;
    const std::int64_t distance = cross(d, p - line_.at);
    return {p, sign(distance), distance, {dot(d, p - Point{})}};
  }

  Node crossing(const Node& u, const Node& v) const;
  std::vector<Arc> arcs(int side) const;
  End end(const std::vector<Arc>& all, std::size_t arc, bool arrives, int side) const;

  int price(Point p) const;

  Line line_;
  Obstacles obstacles_;
  std::vector<Node> nodes_;
};

/// How bad a lattice point is as a new vertex.
int Cutter::price(Point p) const {
  const auto hits = [&](const Polygon& ring) { return isStrictlyInside(p, ring); };
  return 2 * std::any_of(obstacles_.begin(), obstacles_.end(), hits) + (vertex(p).side > 0);
}

Node Cutter::crossing(const Node& u, const Node& v) const {
  // The crossing is u + (v - u) · part / whole.
  const std::int64_t part = std::abs(u.distance), whole = part + std::abs(v.distance);
  Node best;
  best.place = fractionOfProduct(v.place.whole - u.place.whole, part, whole);
  best.place.whole += u.place.whole;
  const Quotient x = divide((v.point.x - u.point.x) * part, whole), y = divide((v.point.y - u.point.y) * part, whole);
  const Point low{u.point.x + x.whole, u.point.y + y.whole};
  for (const Polygon& ring : obstacles_) {
    for (Point p : ring) {
      if (p.x < low.x - 1 || p.x > low.x + 2 || p.y < low.y - 1 || p.y > low.y + 2) continue;
      best.point = p;
      return best;
    }
  }
  // Of the four lattice points around it at least one is not left of the line. By how much the square of a point's
  // distance exceeds that of `low` is a multiple of `whole`; so it is enough to compare the multiples.
  std::optional<std::pair<int, std::int64_t>> least;
  for (const Point step : {Point{0, 0}, Point{1, 0}, Point{0, 1}, Point{1, 1}}) {
    const Point p{low.x + step.x, low.y + step.y};
    const std::pair cost{price(p), step.x * (whole - 2 * x.rest) + step.y * (whole - 2 * y.rest)};
    if (least && *least <= cost) continue;
    least = cost;
    best.point = p;
  }
  return best;
}

std::vector<Cutter::Arc> Cutter::arcs(int side) const {
  std::vector<Arc> found;
  const std::size_t n = nodes_.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (nodes_[i].side != 0 || nodes_[(i + 1) % n].side != side) continue;
    std::size_t last = i + 1;
    while (nodes_[last % n].side == side) ++last;
    found.push_back({i, last});
  }
  return found;
}

Cutter::End Cutter::end(const std::vector<Arc>& all, std::size_t arc, bool arrives, int side) const {
  const std::size_t n = nodes_.size();
  const Node& node = nodes_[(arrives ? all[arc].last : all[arc].first) % n];
  End result{arc, arrives, node.place, {}};
  if (node.place.divisor == 1) {  // a vertex. Other arcs can end there, too; then the slopes decide
    const Node& next = nodes_[(arrives ? all[arc].last - 1 : all[arc].first + 1) % n];
    result.slope = fraction(side * (next.place.whole - node.place.whole), std::abs(next.distance));
  }
  return result;
}

std::vector<Polygon> Cutter::pieces(int side) const {
  const std::vector<Arc> all = arcs(side);
  std::vector<End> ends;
  for (std::size_t i = 0; i < all.size(); ++i) {
    ends.push_back(end(all, i, true, side));
    ends.push_back(end(all, i, false, side));
  }
  // Seen from the right, the line runs the other way.
  std::sort(ends.begin(), ends.end(), [&](const End& a, const End& b) {
    if (a.place != b.place) return side > 0 ? a.place < b.place : b.place < a.place;
    return a.slope < b.slope;
  });
  std::vector<std::size_t> next(all.size(), all.size());
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
    if (!ends[i].arrives || ends[i + 1].arrives) return {};  // not simple: no pieces rather than wrong ones
    next[ends[i].arc] = ends[i + 1].arc;
  }
  std::vector<Polygon> result;
  std::vector<bool> used(all.size(), false);
  for (std::size_t begin = 0; begin < all.size(); ++begin) {
    Polygon ring;
    for (std::size_t arc = begin; !used[arc]; arc = next[arc]) {
      used[arc] = true;
      for (std::size_t i = all[arc].first; i <= all[arc].last; ++i) ring.push_back(nodes_[i % nodes_.size()].point);
    }
    for (Polygon& loop : tidyLoops(std::move(ring))) {
      if (doubleArea(loop) > 0) result.push_back(std::move(loop));  // rounding turned the others over: too thin
    }
  }
  return result;
}

}  // namespace

Halves split(const Polygon& ring, const Line& line, Obstacles obstacles) {
  const Cutter cutter(ring, line, obstacles);
  if (!cutter.reaches(-1)) return {{ring}, {}};
  if (!cutter.reaches(1)) return {{}, {ring}};
  return {cutter.pieces(1), cutter.pieces(-1)};
}

}  // namespace lgs::tiled
