#include "bench/published/published_player.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <unordered_map>

namespace lgs::bench {
namespace {

using oracle::Edit;
using oracle::Outline;
using oracle::Scene;
using oracle::ScenePolygon;

Published::ShouldPreserve callback(const oracle::PreservePairs& preserve) {
  if (preserve.empty()) return {};
  return [preserve](Block a, Block b) { return preserve(a, b); };
}

std::optional<Point> toLattice(const std::optional<Vec2>& v) { return v ? std::optional(toLattice(*v)) : std::nullopt; }

}  // namespace

Point toLattice(Vec2 v) {
  const auto round = [](float c) { return std::llround(double{c} * kUnitsPerCell); };
  return {round(v.x), round(v.y)};
}

std::vector<Vec2> floatVertices(const ScenePolygon& polygon) {
  std::vector<Vec2> out;
  for (const LocalPoint v : polygon.vertices) {
    const Point p = toWorld(polygon.cell, v);
    out.push_back({static_cast<float>(static_cast<double>(p.x) / kUnitsPerCell),
                   static_cast<float>(static_cast<double>(p.y) / kUnitsPerCell)});
  }
  return out;
}

Outline outlineOf(const Published& published) {
  Outline out;
  published.forEachSegment([&](const PublishedSegment& s) {
    out.push_back({toLattice(s.start), toLattice(s.end), s.ogBlock, toLattice(s.ghost1), toLattice(s.ghost2)});
  });
  std::sort(out.begin(), out.end());
  return out;
}

Outline publishedOutline(const oracle::Trace& trace) {
  Published published(callback(trace.preserve));
  std::unordered_map<std::string, const ScenePolygon*> placed;
  for (const Edit& edit : trace.edits) {
    switch (edit.kind) {
      case Edit::Kind::add:
        placed[edit.name] = &edit.polygon;
        published.add(edit.polygon.cell, floatVertices(edit.polygon), edit.polygon.block);
        break;
      case Edit::Kind::remove: {
        const ScenePolygon& polygon = *placed.at(edit.name);
        published.remove(polygon.cell, floatVertices(polygon), polygon.block);
        break;
      }
      case Edit::Kind::commit:
        published.compute();
        break;
    }
  }
  published.compute();
  return outlineOf(published);
}

Outline publishedOutline(const Scene& scene) {
  Published published(callback(scene.preserve));
  for (const ScenePolygon& p : scene.polygons) published.add(p.cell, floatVertices(p), p.block);
  published.compute();
  return outlineOf(published);
}

}  // namespace lgs::bench
