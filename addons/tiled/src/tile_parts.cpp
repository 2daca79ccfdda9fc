#include "tile_parts.h"

#include "snapping_notes.h"

#include <algorithm>
#include <utility>

namespace lgs::tiled {
namespace {

/// How far a part reaches out of the home cell, in pixels.
double reach(const CellPart& part, const PixelGrid& grid) {
  const Box box = boundingBox(part.ring);
  const auto out = [](std::int32_t cells, std::int64_t min, std::int64_t max, double tile) {
    const std::int64_t shift = cells * std::int64_t{kUnitsPerCell};
    const std::int64_t units = std::max({std::int64_t{0}, -(shift + min), shift + max - kUnitsPerCell});
    return static_cast<double>(units) / kUnitsPerCell * tile;
  };
  return std::max(out(part.shift.i, box.min.x, box.max.x, grid.tile.x),
                  out(part.shift.j, box.min.y, box.max.y, grid.tile.y));
}

/// Imports one object. Its parts and notes go to those of the tile.
class ObjectImport {
 public:
  ObjectImport(const Tile& tile, const CollisionObject& object, Budget& budget, TileParts& result)
      : tile_(tile), object_(object), budget_(budget), result_(result) {}

  void run(const ImageFrame& frame, const PixelGrid& grid, const Options& options) {
    if (object_.kind == CollisionObject::Kind::tile) {
      return note(NoteKind::leftOut, 0, "it is a tile object: draw a shape instead");
    }
    if (object_.kind == CollisionObject::Kind::unsupported) return note(NoteKind::leftOut, 0, object_.unsupported);
    std::vector<DoublePoint> points = outline(object_);
    if (!budget_.shape(points.size())) return;
    for (DoublePoint& p : points) p = frame.toCell(p);
    Snapped snapped = snap(points, grid, kMaxReach);
    if (snapped.tooFar) {
      return note(NoteKind::leftOut, 0, "it reaches more than " + std::to_string(kMaxReach) + " cells out of its cell");
    }
    takeBackCollapse(snapped);
    noteSnapping(object_, snapped, result_.notes);
    place(snapped.ring, grid, options.outside);
  }

 private:
  void note(NoteKind kind, double amount, std::string text) {
    result_.notes.push_back({kind, object_.id, amount, 0, {}, std::move(text)});
  }

  void place(const Polygon& ring, const PixelGrid& grid, Outside outside) {
    if (isTangled(ring)) return note(NoteKind::leftOut, 0, "its outline crosses itself more than 1024 times");
    if (!budget_.stroke(ring, nullptr)) return;
    std::optional<std::vector<CellPart>> parts = cutAlongGrid(ring);
    if (!parts) return note(NoteKind::leftOut, 0, "a cell holds as many polygons or vertices as it can");
    if (parts->empty()) return note(NoteKind::leftOut, 0, "it has no area once it is on the grid");
    double out = 0;
    for (CellPart& part : *parts) {
      out = std::max(out, reach(part, grid));
      if (outside == Outside::clip && part.shift != Cell{}) continue;
      result_.parts.push_back(
          {std::move(part), object_.id, object_.className.empty() ? tile_.className : object_.className});
    }
    if (out == 0) return;
    note(outside == Outside::carry ? NoteKind::carried : NoteKind::clipped, out,
         "reaches up to " + pixels(out) +
             " out of its cell: " + (outside == Outside::carry ? "carried into the neighbouring cells" : "cut off"));
  }

  const Tile& tile_;
  const CollisionObject& object_;
  Budget& budget_;
  TileParts& result_;
};

}  // namespace

TileParts tileParts(const Tile& tile, const ImageFrame& frame, const PixelGrid& grid, const Options& options,
                    Budget& budget) {
  TileParts result;
  if (isLeftOut(tile, options)) return result;
  for (const CollisionObject& drawn : tile.objects) {
    const CollisionObject object = asAsked(drawn, options);
    ObjectImport(tile, object, budget, result).run(frame, grid, options);
  }
  return result;
}

}  // namespace lgs::tiled
