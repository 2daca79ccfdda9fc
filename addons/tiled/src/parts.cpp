#include "parts.h"

#include <lgs/brush.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace lgs::tiled {
namespace {

using Kind = CollisionObject::Kind;

void addNote(std::vector<Note>& notes, const CollisionObject& object, NoteKind kind, double amount, std::string text) {
  notes.push_back({kind, object.id, amount, 0, {}, std::move(text)});
}

/// What is to be said of the kind of an object.
void noteKind(std::vector<Note>& notes, const CollisionObject& object) {
  const auto note = [&](NoteKind kind, std::string text) { addNote(notes, object, kind, 0, std::move(text)); };
  if (object.kind == Kind::ellipse || object.kind == Kind::capsule)
    note(NoteKind::approximated, concat(object.kind == Kind::ellipse ? "an ellipse" : "a capsule",
                                        " became a polygon of ", kCurveVertices, " vertices"));
  if (object.thickness > 0)
    note(NoteKind::approximated, "an open polyline became " + pixels(object.thickness) + " thick");
  if (object.hidden) note(NoteKind::hidden, "is hidden, and counts all the same; --visible leaves it out");
}

void noteSnapping(std::vector<Note>& notes, const CollisionObject& object, const Snapped& snapped) {
  if (snapped.takenBack) {
    addNote(notes, object, NoteKind::takenBack, snapped.furthest,
            concat("stays as drawn: snapping by up to ", pixels(snapped.furthest),
                   " would press sides of it together. A smaller --tolerance may snap the rest"));
  } else if (snapped.moved > 0) {
    addNote(notes, object, NoteKind::snapped, snapped.furthest,
            counted(snapped.moved, "coordinate") + " put on the grid, by up to " + pixels(snapped.furthest));
  }
  if (snapped.nearMiss > 0)
    addNote(notes, object, NoteKind::nearMiss, snapped.nearMiss,
            concat("a vertex misses a corner by ", pixels(snapped.nearMiss), ": a tolerance of ",
                   pixels(std::ceil(snapped.nearMiss * 10) / 10), " would join it"));
}

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

}  // namespace

void cutObject(const CollisionObject& object, const std::vector<Outline>& outlines, const PixelGrid& grid, double most,
               Budget& budget, std::vector<Note>& notes, const PartSink& sink) {
  /// Of one outline. Returns why nothing of it is taken; or "".
  const auto cut = [&](const Outline& outline) -> std::string {
    if (!budget.shape(outline.size())) return {};
    const auto snapped = snap(outline, grid, most);
    if (!snapped) return snapped.error();
    if (&outline == &outlines.front()) noteKind(notes, object);
    noteSnapping(notes, object, *snapped);
    if (isTangled(snapped->ring)) return "its outline crosses itself more than 1024 times";
    if (tidied(snapped->ring).size() < 3) return "it has no area once it is on the grid";
    if (!budget.stroke(snapped->ring)) return {};
    const auto parts = cutAlongGrid(snapped->ring, sink);
    if (!parts) return "a cell holds as many polygons or vertices as it can";
    return *parts > 0 ? "" : "it has no area: what its outline goes around twice is not solid";
  };
  const auto leaveOut = [&](std::string why) {
    if (!why.empty()) addNote(notes, object, NoteKind::leftOut, 0, std::move(why));
  };
  if (object.kind == Kind::unsupported) return leaveOut(object.unsupported);
  if (object.kind == Kind::tile) return leaveOut("it is a tile object: draw a shape instead");
  for (const Outline& outline : outlines) leaveOut(cut(outline));
}

void cutTile(const Tile& tile, const ImageFrame& frame, const PixelGrid& grid, const Options& options, Budget& budget,
             std::vector<Note>& notes, const TilePartSink& sink) {
  if (isLeftOut(tile, options)) return;
  for (const CollisionObject& drawn : tile.objects) {
    CollisionObject object = asAsked(drawn, options);
    if (object.className.empty()) object.className = tile.className;
    std::vector<Outline> points = outlines(object);
    for (Outline& outline : points)
      for (DoublePoint& p : outline) p = frame.toCell(p);
    double out = 0;
    cutObject(object, points, grid, kMaxReach, budget, notes, [&](Cell shift, const Polygon& ring) {
      out = std::max(out, reach(shift, ring, grid));
      sink(shift, ring, object);
    });
    if (out > 0)
      addNote(notes, object, NoteKind::carried, out,
              concat("reaches up to ", pixels(out), " out of its cell: carried into the neighbouring cells"));
  }
}

std::string pixels(double value) {
  return numberText(static_cast<double>(std::llround(std::fmin(value, 1e9) * 100)) / 100) + " px";
}

}  // namespace lgs::tiled
