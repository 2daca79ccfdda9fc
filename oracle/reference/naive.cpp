#include "oracle/reference/naive.h"

#include "oracle/reference/vector.h"

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>

namespace lgs::oracle {
namespace {

// The order of vertices: by column of cells, then from bottom to top. Bisection then finds those near a cell. This
// makes the reference fast, and does not change what it computes.
bool byColumnThenHeight(Point a, Point b) {
  return std::tuple(cellIndex(a.x), a.y, a.x) < std::tuple(cellIndex(b.x), b.y, b.x);
}

enum class Turn { clockwise, counterClockwise };

// Whether, turning from `from`, direction a is met before direction b. Neither may be the direction of `from` itself.
bool isMetBefore(Turn turn, Vector from, Vector a, Vector b) {
  // Positive where the second direction is ahead of the first by less than half a turn.
  const auto ahead = [turn](Vector v, Vector w) { return turn == Turn::counterClockwise ? cross(v, w) : cross(w, v); };
  const bool aInFirstHalf = ahead(from, a) >= 0;  // by an angle in (0, π]; 0 is exactly opposite
  const bool bInFirstHalf = ahead(from, b) >= 0;
  return aInFirstHalf != bInFirstHalf ? aInFirstHalf : ahead(a, b) > 0;
}

bool coincide(Vector a, Vector b) { return cross(a, b) == 0 && dot(a, b) > 0; }

// Finds the far end that is met first when turning about `vertex`, from the direction of `own`, by an angle in (0, 2π).
class FirstMet {
 public:
  FirstMet(Turn turn, Point vertex, Point own) : turn_(turn), vertex_(vertex), from_(own - vertex) {}

  void consider(Point farEnd) {
    const Vector direction = farEnd - vertex_;
    if (coincide(from_, direction)) return;
    if (!best_ || isMetBefore(turn_, from_, direction, *best_ - vertex_)) best_ = farEnd;
  }
  std::optional<Point> result() const { return best_; }

 private:
  Turn turn_;
  Point vertex_;
  Vector from_;
  std::optional<Point> best_;
};

}  // namespace

const OwnedOutline& NaiveReference::operator()(const Scene& scene) {
  collectVertices(scene);
  cutEdges(scene);
  leaving_.group(edges_, &AtomicEdge::from, vertices_.size());
  arriving_.group(edges_, &AtomicEdge::to, vertices_.size());
  expose(scene);
  linkAndSort(scene);
  return result_;
}

void NaiveReference::collectVertices(const Scene& scene) {
  vertices_.clear();
  for (const ScenePolygon& polygon : scene.polygons) {
    for (const LocalPoint vertex : polygon.vertices) vertices_.push_back(toWorld(polygon.cell, vertex));
  }
  std::sort(vertices_.begin(), vertices_.end(), byColumnThenHeight);
  vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
}

void NaiveReference::cutEdges(const Scene& scene) {
  edges_.clear();
  for (std::size_t p = 0; p < scene.polygons.size(); ++p) {
    const ScenePolygon& polygon = scene.polygons[p];
    const Point low = toWorld(polygon.cell, {0, 0});
    const Point high = toWorld(polygon.cell, {kUnitsPerCell, kUnitsPerCell});

    nearby_.clear();
    for (const std::int64_t columnStart : {low.x, high.x}) {  // the right side belongs to the next column
      const Point first{columnStart, low.y};
      for (auto v = std::lower_bound(vertices_.begin(), vertices_.end(), first, byColumnThenHeight);
           v != vertices_.end() && v->x < columnStart + kUnitsPerCell && v->y <= high.y; ++v) {
        if (v->x <= high.x) nearby_.push_back(static_cast<Index>(v - vertices_.begin()));
      }
    }

    Point previous = toWorld(polygon.cell, polygon.vertices.back());
    for (const LocalPoint vertex : polygon.vertices) {
      const Point next = toWorld(polygon.cell, vertex);
      cutEdge(previous, next, static_cast<Index>(p));
      previous = next;
    }
  }
}

void NaiveReference::cutEdge(Point a, Point b, Index owner) {
  cuts_.clear();  // a and b will be among them: they are vertices that lie on the edge
  for (const Index v : nearby_) {
    if (isOnSegment(vertices_[v], a, b)) cuts_.push_back({dot(vertices_[v] - a, b - a), v});
  }
  std::sort(cuts_.begin(), cuts_.end(), [](const Cut& l, const Cut& r) { return l.along < r.along; });
  for (std::size_t k = 1; k < cuts_.size(); ++k) edges_.push_back({cuts_[k - 1].vertex, cuts_[k].vertex, owner, true});
}

void NaiveReference::expose(const Scene& scene) {
  const auto blockOf = [&](const AtomicEdge& edge) { return scene.polygons[edge.owner].block; };
  for (AtomicEdge& edge : edges_) {
    for (const Index k : leaving_[edge.to]) {
      const AtomicEdge& other = edges_[k];
      if (other.to == edge.from && !scene.preserve(blockOf(edge), blockOf(other))) edge.exposed = false;
    }
  }
}

void NaiveReference::linkAndSort(const Scene& scene) {
  order_.clear();
  for (Index k = 0; k < edges_.size(); ++k) {
    if (edges_[k].exposed) order_.push_back(k);
  }
  const auto key = [this](Index k) {
    const AtomicEdge& edge = edges_[k];
    return std::tie(vertices_[edge.from], vertices_[edge.to], edge.owner);
  };
  std::sort(order_.begin(), order_.end(), [&](Index a, Index b) { return key(a) < key(b); });

  result_.outline.clear();
  result_.owner.clear();
  for (const Index k : order_) {
    const AtomicEdge& edge = edges_[k];
    const Point start = vertices_[edge.from];
    const Point end = vertices_[edge.to];

    FirstMet predecessor(Turn::clockwise, start, end);
    for (const Index other : arriving_[edge.from]) {
      if (edges_[other].exposed) predecessor.consider(vertices_[edges_[other].from]);
    }
    FirstMet successor(Turn::counterClockwise, end, start);
    for (const Index other : leaving_[edge.to]) {
      if (edges_[other].exposed) successor.consider(vertices_[edges_[other].to]);
    }
    result_.outline.push_back({start, end, scene.polygons[edge.owner].block, predecessor.result(), successor.result()});
    result_.owner.push_back(edge.owner);
  }
}

void NaiveReference::EdgesByVertex::group(const std::vector<AtomicEdge>& edges, Index AtomicEdge::*vertex,
                                          std::size_t vertexCount) {
  starts.assign(vertexCount + 1, 0);
  for (const AtomicEdge& edge : edges) ++starts[edge.*vertex];
  for (std::size_t v = 1; v <= vertexCount; ++v) starts[v] += starts[v - 1];  // now the end of each group
  list.resize(edges.size());
  for (std::size_t k = edges.size(); k-- > 0;) list[--starts[edges[k].*vertex]] = static_cast<Index>(k);
}

Outline linked(Outline outline) {
  std::multimap<Point, Point> arriving, leaving;  // by the vertex, the far end
  for (const OutlineSegment& s : outline) {
    leaving.emplace(s.start, s.end);
    arriving.emplace(s.end, s.start);
  }
  const auto met = [](FirstMet first, const auto& farEnds, Point vertex) {
    for (auto [at, end] = farEnds.equal_range(vertex); at != end; ++at) first.consider(at->second);
    return first.result();
  };
  for (OutlineSegment& s : outline) {
    s.ghost1 = met(FirstMet(Turn::clockwise, s.start, s.end), arriving, s.start);
    s.ghost2 = met(FirstMet(Turn::counterClockwise, s.end, s.start), leaving, s.end);
  }
  return outline;
}

Outline naiveOutline(const Scene& scene) { return NaiveReference{}(scene).outline; }

}  // namespace lgs::oracle
