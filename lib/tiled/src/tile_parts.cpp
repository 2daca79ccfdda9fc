#include "tile_parts.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace lgs::tiled {
namespace {

/// How far a ring reaches out of its home cell, in pixels.
double reach(const Polygon& ring, const PixelGrid& grid) {
  const Box box = boundingBox(ring);
  const auto out = [](std::int64_t min, std::int64_t max, double tile) {
    const std::int64_t units = std::max({std::int64_t{0}, -min, max - kUnitsPerCell});
    return static_cast<double>(units) / kUnitsPerCell * tile;
  };
  return std::max(out(box.min.x, box.max.x, grid.tile.x), out(box.min.y, box.max.y, grid.tile.y));
}

/// Works on one object; the notes and parts go to the tile's.
class ObjectImport {
 public:
  ObjectImport(const Tile& tile, const CollisionObject& object, TileParts& result)
      : tile_(tile), object_(object), result_(result) {}

  void run(const Frame& frame, const PixelGrid& grid, const Options& options) {
    if (object_.kind == CollisionObject::Kind::unsupported) return note(NoteKind::leftOut, 0, object_.unsupported);
    std::vector<DoublePoint> points = outline(object_);
    for (DoublePoint& p : points) p = frame.toCell(p);
    Snapped snapped = snap(points, grid);
    if (snapped.tooFar) {
      return note(NoteKind::leftOut, 0, "it reaches more than " + std::to_string(kMaxReach) + " cells out of its cell");
    }
    noteSnapping(snapped);
    for (const Polygon& loop : checkedLoops(std::move(snapped.ring))) place(loop, grid, options.outside);
  }

 private:
  void note(NoteKind kind, double amount, std::string text) {
    result_.notes.push_back({kind, object_.id, amount, 0, {}, std::move(text)});
  }

  void noteSnapping(const Snapped& snapped) {
    using Kind = CollisionObject::Kind;
    if (object_.kind == Kind::ellipse || object_.kind == Kind::capsule) {
      note(NoteKind::approximated, 0,
           std::string(object_.kind == Kind::ellipse ? "an ellipse" : "a capsule") + " became a polygon of " +
               std::to_string(kCurveVertices) + " vertices");
    }
    if (snapped.moved > 0) {
      note(NoteKind::snapped, snapped.furthest,
           std::to_string(snapped.moved) + (snapped.moved == 1 ? " coordinate" : " coordinates") +
               " put on the grid, by up to " + pixels(snapped.furthest));
    }
    if (snapped.nearMiss > 0) {
      note(NoteKind::nearMiss, snapped.nearMiss,
           "a vertex misses a corner by " + pixels(snapped.nearMiss) + ": a tolerance of " +
               pixels(std::ceil(snapped.nearMiss * 10) / 10) + " would join it");
    }
  }

  /// The outline as simple counter-clockwise loops; several where it touches itself in a vertex.
  std::vector<Polygon> checkedLoops(Polygon ring) {
    std::vector<Polygon> loops = tidyLoops(std::move(ring));
    if (loops.empty()) note(NoteKind::leftOut, 0, "it has no area once it is on the grid");
    const auto turnsLeft = [](const Polygon& loop) { return doubleArea(loop) > 0; };
    const bool allLeft = std::all_of(loops.begin(), loops.end(), turnsLeft);
    const bool allRight = std::none_of(loops.begin(), loops.end(), turnsLeft);
    bool good = allLeft || allRight;
    for (Polygon& loop : loops) {
      if (allRight) std::reverse(loop.begin(), loop.end());
      good = good && isSimple(loop);
    }
    for (std::size_t i = 0; i < loops.size() && good; ++i) {
      for (std::size_t j = i + 1; j < loops.size() && good; ++j) good = relation(loops[i], loops[j]) == Relation::apart;
    }
    if (good) return loops;
    note(NoteKind::leftOut, 0, "its outline crosses or touches itself");
    return {};
  }

  void place(const Polygon& loop, const PixelGrid& grid, Outside outside) {
    const double out = reach(loop, grid);
    if (out > 0) {
      note(outside == Outside::carry ? NoteKind::carried : NoteKind::clipped, out,
           "reaches up to " + pixels(out) +
               " out of its cell: " + (outside == Outside::carry ? "carried into the neighbouring cells" : "cut off"));
    }
    bool tooThin = false;
    for (CellPart& part : cutAlongGrid(loop)) {
      if (outside == Outside::clip && part.shift != Cell{}) continue;
      if (!isSimple(part.ring)) {
        tooThin = true;
        continue;
      }
      result_.parts.push_back(
          {std::move(part), object_.id, object_.className.empty() ? tile_.className : object_.className});
    }
    if (tooThin) note(NoteKind::leftOut, 0, "a part is so thin that it cannot be told from a line");
  }

  const Tile& tile_;
  const CollisionObject& object_;
  TileParts& result_;
};

}  // namespace

TileParts tileParts(const Tile& tile, const Frame& frame, const PixelGrid& grid, const Options& options) {
  TileParts result;
  for (const CollisionObject& object : tile.objects) ObjectImport(tile, object, result).run(frame, grid, options);
  return result;
}

std::string pixels(double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%.2f", std::fmin(value, 1e9));
  std::string result = text;
  result.erase(result.find_last_not_of('0') + 1);
  if (result.ends_with('.')) result.pop_back();
  return result + " px";
}

}  // namespace lgs::tiled
