#include "parts.h"

#include <lgs/brush.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace lgs::tiled {
namespace {

using Kind = CollisionObject::Kind;

/// Collects the notes on one object.
class Noter {
 public:
  Noter(const CollisionObject& object, std::vector<Note>& notes) : object_(object), notes_(notes) {}

  void note(NoteKind kind, double amount, std::string text) const {
    notes_.push_back({kind, object_.id, amount, 0, {}, std::move(text)});
  }

  void leaveOut(std::string why) const { note(NoteKind::leftOut, 0, std::move(why)); }

  void noteKind() const {
    if (object_.kind == Kind::ellipse || object_.kind == Kind::capsule) {
      note(NoteKind::approximated, 0,
           concat(object_.kind == Kind::ellipse ? "an ellipse" : "a capsule", " became a polygon of ", kCurveVertices,
                  " vertices"));
    }
    if (object_.thickness > 0) {
      note(NoteKind::approximated, 0, "an open polyline became " + pixels(object_.thickness) + " thick");
    }
    if (object_.hidden) note(NoteKind::hidden, 0, "is hidden, and counts all the same; --visible leaves it out");
  }

  void noteSnapping(const Snapped& snapped) const {
    if (snapped.takenBack) {
      note(NoteKind::takenBack, snapped.furthest,
           concat("stays as drawn: snapping by up to ", pixels(snapped.furthest),
                  " would press sides of it together. A smaller --tolerance may snap the rest"));
    } else if (snapped.moved > 0) {
      note(NoteKind::snapped, snapped.furthest,
           counted(snapped.moved, "coordinate") + " put on the grid, by up to " + pixels(snapped.furthest));
    }
    if (snapped.nearMiss > 0) {
      note(NoteKind::nearMiss, snapped.nearMiss,
           concat("a vertex misses a corner by ", pixels(snapped.nearMiss), ": a tolerance of ",
                  pixels(std::ceil(snapped.nearMiss * 10) / 10), " would join it"));
    }
  }

 private:
  const CollisionObject& object_;
  std::vector<Note>& notes_;
};

/// How far a part reaches out of the home cell, in pixels.
double reach(Cell shift, const Polygon& ring, const PixelGrid& grid) {
  const Box box = boundingBox(ring);
  const auto out = [](std::int32_t cells, std::int64_t min, std::int64_t max, double tile) {
    const std::int64_t from = cells * std::int64_t{kUnitsPerCell};
    const std::int64_t units = std::max({std::int64_t{0}, -(from + min), from + max - kUnitsPerCell});
    return static_cast<double>(units) / kUnitsPerCell * tile;
  };
  return std::max(out(shift.i, box.min.x, box.max.x, grid.tile.x), out(shift.j, box.min.y, box.max.y, grid.tile.y));
}

/// One outline of an object. Returns why nothing of it is taken; or "".
std::string cutOutline(const Noter& noter, const Outline& outline, const PixelGrid& grid, double most, Budget& budget,
                       const PartSink& sink, bool isFirst) {
  if (!budget.shape(outline.size())) return {};
  Snapped snapped = snap(outline, grid, most);
  if (snapped.tooFar)
    return most > kMaxReach ? "it is too far away"
                            : concat("it reaches more than ", kMaxReach, " cells out of its cell");
  constexpr std::int64_t kExtent = kMaxRegionCells * kUnitsPerCell;
  const Box box = boundingBox(snapped.ring);
  if (box.max.x - box.min.x > kExtent || box.max.y - box.min.y > kExtent)
    return concat("it is more than ", kMaxRegionCells, " cells wide or high");
  takeBackCollapse(snapped);
  if (isFirst) noter.noteKind();
  noter.noteSnapping(snapped);
  if (isTangled(snapped.ring)) return "its outline crosses itself more than 1024 times";
  if (tidyLoops(snapped.ring).empty()) return "it has no area once it is on the grid";
  if (!budget.stroke(snapped.ring)) return {};
  const auto parts = cutAlongGrid(snapped.ring, sink);
  if (!parts) return "a cell holds as many polygons or vertices as it can";
  return *parts > 0 ? "" : "it has no area: what its outline goes around twice is not solid";
}

}  // namespace

void cutObject(const CollisionObject& object, const std::vector<Outline>& outlines, const PixelGrid& grid, double most,
               Budget& budget, std::vector<Note>& notes, const PartSink& sink) {
  const Noter noter(object, notes);
  if (object.kind == Kind::unsupported) return noter.leaveOut(object.unsupported);
  if (object.kind == Kind::tile) return noter.leaveOut("it is a tile object: draw a shape instead");
  for (const Outline& outline : outlines) {
    std::string why = cutOutline(noter, outline, grid, most, budget, sink, &outline == &outlines.front());
    if (!why.empty()) noter.leaveOut(std::move(why));
  }
}

TileParts tileParts(const Tile& tile, const ImageFrame& frame, const PixelGrid& grid, const Options& options,
                    Budget& budget) {
  TileParts result;
  if (isLeftOut(tile, options)) return result;
  const bool carries = options.outside == Outside::carry;
  for (const CollisionObject& drawn : tile.objects) {
    const CollisionObject object = asAsked(drawn, options);
    std::vector<Outline> points = outlines(object);
    for (Outline& outline : points)
      for (DoublePoint& p : outline) p = frame.toCell(p);
    double out = 0;
    cutObject(object, points, grid, kMaxReach, budget, result.notes, [&](Cell shift, const Polygon& ring) {
      out = std::max(out, reach(shift, ring, grid));
      if (!carries && shift != Cell{}) return;
      const std::string& className = object.className.empty() ? tile.className : object.className;
      result.parts.push_back({shift, ring, object.id, className});
    });
    if (out == 0) continue;
    Noter(object, result.notes)
        .note(carries ? NoteKind::carried : NoteKind::clipped, out,
              concat("reaches up to ", pixels(out),
                     " out of its cell: ", carries ? "carried into the neighbouring cells" : "cut off"));
  }
  return result;
}

std::string pixels(double value) {
  return numberText(static_cast<double>(std::llround(std::fmin(value, 1e9) * 100)) / 100) + " px";
}

}  // namespace lgs::tiled
