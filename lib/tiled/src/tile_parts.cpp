#include "tile_parts.h"

#include "snapping_notes.h"

#include <algorithm>
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

/// Imports one object. Its parts and notes go to those of the tile.
class ObjectImport {
 public:
  ObjectImport(const Tile& tile, const CollisionObject& object, TileParts& result)
      : tile_(tile), object_(object), result_(result) {}

  void run(const ImageFrame& frame, const PixelGrid& grid, const Options& options) {
    if (object_.kind == CollisionObject::Kind::tile) {
      return note(NoteKind::leftOut, 0, "it is a tile object: draw a shape instead");
    }
    if (object_.kind == CollisionObject::Kind::unsupported) return note(NoteKind::leftOut, 0, object_.unsupported);
    std::vector<DoublePoint> points = outline(object_);
    for (DoublePoint& p : points) p = frame.toCell(p);
    Snapped snapped = snap(points, grid, kMaxReach);
    if (snapped.tooFar) {
      return note(NoteKind::leftOut, 0, "it reaches more than " + std::to_string(kMaxReach) + " cells out of its cell");
    }
    noteSnapping(object_, snapped, result_.notes);
    for (const Polygon& loop : checkedLoops(std::move(snapped.ring))) place(loop, grid, options.outside);
  }

 private:
  void note(NoteKind kind, double amount, std::string text) {
    result_.notes.push_back({kind, object_.id, amount, 0, {}, std::move(text)});
  }

  /// The outline as simple counter-clockwise loops; there are several if it touches itself in a vertex. None if it
  /// crosses itself or has no area, with a note.
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

TileParts tileParts(const Tile& tile, const ImageFrame& frame, const PixelGrid& grid, const Options& options) {
  TileParts result;
  for (const CollisionObject& object : tile.objects) ObjectImport(tile, object, result).run(frame, grid, options);
  return result;
}

}  // namespace lgs::tiled
