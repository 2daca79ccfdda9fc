// Cutting a simple polygon along a line. On each side the polygon's outline falls into arcs that begin and end on the
// line. Just beside the line, going along it, the arcs' ends alternate between entering and leaving the interior; each
// pair is joined by a stretch of the line, which closes the arcs to the pieces. No degenerate bridges appear.
#include "split.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace lgs::tiled {
namespace {

__extension__ using Wide = __int128;  // products of an edge's length and two distances from a line need up to 104 bits

/// A vertex of the outline, or the point where an edge crosses the line.
struct Node {
  Point point;
  int side = 0;               // 1: left of the line, -1: right, 0: on it
  std::int64_t distance = 0;  // from the line, scaled; of vertices only
  Wide num = 0;               // place along the line: num / den, exact even where `point` is rounded
  std::int64_t den = 1;
};

std::int64_t floorDiv(std::int64_t a, std::int64_t b) {  // b > 0
  return a / b - (a % b < 0);
}

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
    std::size_t first, last;  // nodes on the line; all between them are on the side in question
  };
  struct End {
    std::size_t arc;
    bool arrives;  // the outline comes to the line here; otherwise it leaves
    Wide num;
    std::int64_t den;
    Wide slopeNum;  // progress along the line per distance from it
    std::int64_t slopeDen;
    bool operator<(const End& other) const {
      const Wide l = num * other.den, r = other.num * den;
      return l != r ? l < r : slopeNum * other.slopeDen < other.slopeNum * slopeDen;
    }
  };

  Node vertex(Point p) const {
    const Vector d = line_.direction;
    const std::int64_t distance = cross(d, p - line_.at);
    return {p, sign(distance), distance, dot(d, p - Point{}), 1};
  }

  Node crossing(const Node& u, const Node& v) const;
  std::vector<Arc> arcs(int side) const;
  End end(const std::vector<Arc>& all, std::size_t arc, bool arrives, int side) const;

  int price(Point p) const;

  Line line_;
  Obstacles obstacles_;
  std::vector<Node> nodes_;
};

/// How welcome a lattice point is as a new vertex; less is better.
int Cutter::price(Point p) const {
  const auto hits = [&](const Polygon& ring) { return isStrictlyInside(p, ring); };
  return 2 * std::any_of(obstacles_.begin(), obstacles_.end(), hits) + (vertex(p).side > 0);
}

Node Cutter::crossing(const Node& u, const Node& v) const {
  const int flip = u.distance > v.distance ? 1 : -1;
  Node best;
  best.num = flip * (v.num * u.distance - u.num * v.distance);
  best.den = flip * (u.distance - v.distance);
  const std::int64_t part = flip * u.distance;  // the crossing is u + (v - u) * part / den
  const std::int64_t stepX = (v.point.x - u.point.x) * part, stepY = (v.point.y - u.point.y) * part;
  const std::int64_t lowX = floorDiv(stepX, best.den), lowY = floorDiv(stepY, best.den);
  const Point low{u.point.x + lowX, u.point.y + lowY};
  for (const Polygon& ring : obstacles_) {
    for (Point p : ring) {
      if (p.x < low.x - 1 || p.x > low.x + 2 || p.y < low.y - 1 || p.y > low.y + 2) continue;
      best.point = p;
      return best;
    }
  }
  std::optional<std::pair<int, Wide>> least;
  for (int corner = 0; corner < 4; ++corner) {  // the lattice points around it: one of them is not left of the line
    const Point step{corner & 1, corner >> 1};
    const Wide missX = Wide{lowX + step.x} * best.den - stepX, missY = Wide{lowY + step.y} * best.den - stepY;
    const Point p{low.x + step.x, low.y + step.y};
    const std::pair<int, Wide> cost{price(p), missX * missX + missY * missY};
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
  End result{arc, arrives, side * node.num, node.den, 0, 1};
  if (node.den == 1) {  // a vertex: others can lie there too, told apart by their slopes
    const Node& next = nodes_[(arrives ? all[arc].last - 1 : all[arc].first + 1) % n];
    result.slopeNum = side * (next.num - node.num);
    result.slopeDen = side * next.distance;
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
  std::sort(ends.begin(), ends.end());
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
      if (doubleArea(loop) > 0) result.push_back(std::move(loop));  // the others are turned over by rounding: too thin
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
