#include "oracle/generate/features.h"

#include "oracle/reference/vector.h"

#include <fmt/format.h>
#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>

namespace lgs::oracle {
namespace {

struct Edge {
  Point from;
  Point to;
};

// Neighbours only, so that nothing overflows: see note().
bool between(Point p, Point a, Point b) { return p != a && p != b && isOnSegment(p, a, b); }

using Edges = std::vector<Edge>;

Edges edgesOf(const ScenePolygon& polygon) {
  Edges edges;
  const std::size_t n = polygon.vertices.size();
  for (std::size_t k = 0; k < n; ++k) {
    edges.push_back({toWorld(polygon.cell, polygon.vertices[k]), toWorld(polygon.cell, polygon.vertices[(k + 1) % n])});
  }
  return edges;
}

class Noter {
 public:
  explicit Noter(Features& features) : features_(features) {}

  void mark(Feature feature) { features_[static_cast<std::size_t>(feature)] = true; }

  /// Whether pairs have shown already all that they can.
  bool knowsPairs() const {
    using enum Feature;
    constexpr std::array kOfPairs{midEdge, partialOverlap, sharedInCell, sharedSlope, manyInCell};
    return std::ranges::all_of(kOfPairs, [&](Feature f) { return features_[static_cast<std::size_t>(f)]; });
  }

  void pair(const Edges& p, const Edges& q, bool sameCell) {
    if (sameCell) mark(Feature::manyInCell);
    for (const Edge& a : p) {
      for (const Edge& b : q) edges(a, b, sameCell);
    }
  }

 private:
  void edges(const Edge& a, const Edge& b, bool sameCell) {
    const bool aCut = between(b.from, a.from, a.to) || between(b.to, a.from, a.to);
    const bool bCut = between(a.from, b.from, b.to) || between(a.to, b.from, b.to);
    if ((aCut || bCut) && !sameCell) mark(Feature::midEdge);
    const bool collinear = cross(a.to - a.from, b.from - a.from) == 0 && cross(a.to - a.from, b.to - a.from) == 0;
    const bool equal = a.from == b.to && a.to == b.from;
    // Edges that are collinear and cut share a part. If they run the same way they do not: two solids meet end to end.
    if (!collinear || (!equal && !aCut && !bCut)) return;
    if (!equal) mark(Feature::partialOverlap);
    if (sameCell) mark(Feature::sharedInCell);
    if (sameCell && a.from.x != a.to.x && a.from.y != a.to.y) mark(Feature::sharedSlope);
  }

  Features& features_;
};

}  // namespace

const char* describe(Feature feature) {
  constexpr std::array kWords{
      "a vertex in mid-edge of a neighbour", "edges that overlap in part", "an edge shared inside a cell",
      "a slanted edge shared inside a cell", "four solids at a corner",    "several polygons in a cell",
      "a preserve relation at work",         "edits that are refused"};
  static_assert(kWords.size() == static_cast<std::size_t>(Feature::count));
  return kWords[static_cast<std::size_t>(feature)];
}

void note(const Scene& scene, Features& features) {
  const auto isBeside = [](std::int64_t a, std::int64_t b) { return std::abs(a - b) <= 1; };
  Noter noter(features);
  std::map<Point, std::set<Cell>> corners;
  std::set<Block> blocks;
  std::vector<Edges> edges;
  for (const ScenePolygon& p : scene.polygons) edges.push_back(edgesOf(p));
  for (std::size_t k = 0; k < scene.polygons.size(); ++k) {
    const ScenePolygon& p = scene.polygons[k];
    blocks.insert(p.block);
    for (const LocalPoint& v : p.vertices) {
      if (v.x % kUnitsPerCell == 0 && v.y % kUnitsPerCell == 0) corners[toWorld(p.cell, v)].insert(p.cell);
    }
    for (std::size_t l = 0; l < k && !noter.knowsPairs(); ++l) {
      const ScenePolygon& q = scene.polygons[l];
      if (isBeside(p.cell.i, q.cell.i) && isBeside(p.cell.j, q.cell.j))
        noter.pair(edges[k], edges[l], p.cell == q.cell);
    }
  }
  for (const auto& entry : corners) {
    if (entry.second.size() == 4) noter.mark(Feature::fourSolids);
  }
  for (const auto& [a, b] : scene.preserve.pairs()) {
    if (blocks.contains(a) && blocks.contains(b)) noter.mark(Feature::preserve);
  }
}

void Distribution::add(const Features& features) {
  ++cases;
  for (std::size_t k = 0; k < features.size(); ++k) with[k] += features[k] ? 1 : 0;
}

double Distribution::percent(Feature feature) const {
  return 100.0 * static_cast<double>(with[static_cast<std::size_t>(feature)]) / static_cast<double>(cases);
}

std::string table(const Distribution& distribution) {
  std::string text;
  for (std::size_t k = 0; k < distribution.with.size(); ++k) {
    text += fmt::format("  {:4.0f}%    {}\n", distribution.percent(Feature{k}), describe(Feature{k}));
  }
  return text;
}

}  // namespace lgs::oracle
