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

/// Which point of a tile object is its place: the part of its width and height that lies left of it and below it.
DoublePoint anchor(const std::string& alignment) {
  if (alignment.empty() || alignment == "unspecified") return {0, 0};
  const auto has = [&](const char* word) { return alignment.find(word) != std::string::npos; };
  return {has("left") ? 0 : has("right") ? 1 : 0.5, has("bottom") ? 0 : has("top") ? 1 : 0.5};
}

/// The tileset of a tile object; null if it has none. A problem is kept by the template.
const Tileset* tilesetOf(const CollisionObject& object, MapSource& source, const Options& options) {
  Template* const origin = object.gidFrom;
  if (!origin) return tilesetOf(source.tilesets, tileNumber(object.gid));
  const auto node = origin->file.root().child("tileset");
  const auto [at, isNew] = source.tilesetsOfTemplates.try_emplace(origin);
  if (isNew && node) at->second = readTileset(origin->file, node, source.templates, options.tiles);
  return node ? &at->second : nullptr;
}

/// Gives the shapes of a tile object.
void readTileObject(CollisionObject object, MapSource& source, const Properties& ofLayer, const Options& options,
                    Budget& budget, const ShapeSink& sink) {
  const auto leftOut = [&](std::string reason) {
    leaveOut(object, std::move(reason));
    sink(object, {});
  };
  const std::uint32_t number = tileNumber(object.gid);
  const Tileset* const tileset = tilesetOf(object, source, options);
  if (object.gidFrom && object.gidFrom->error) return leftOut("its template " + message(*object.gidFrom->error));
  if (!tileset || number < tileset->firstGid) return leftOut("its tile belongs to no tileset");
  if (!budget.tile(*tileset, number - tileset->firstGid)) return;
  Tile tile = tileset->tile(number - tileset->firstGid);
  if (isLeftOut(tile, options)) tile.objects.clear();
  squareAsAsked(tile, ofLayer, options);
  if (tile.objects.empty()) return leftOut("its tile has no collision shapes");
  const DoublePoint size{object.size.x > 0 ? object.size.x : tile.size.x,
                         object.size.y > 0 ? object.size.y : tile.size.y};
  ImageFrame frame{tile.size, object.gid, {1, 1}, {}};
  frame.scaleTo(size);
  frame.shift = {tileset->offset.x * frame.scale.x, tileset->offset.y * frame.scale.y};
  const DoublePoint part = anchor(tileset->alignment);
  for (CollisionObject& drawn : tile.objects) {
    drawn.hidden |= object.hidden;
    CollisionObject shape = asAsked(drawn, options);
    if (!budget.shape(shape.points.size())) return;
    const std::vector<Outline> all = outlines(shape, [&](DoublePoint p) {
      const DoublePoint inBox = frame.toCell(p);
      const DoublePoint q = turned({inBox.x - part.x * size.x, part.y * size.y - inBox.y}, object.rotation);
      return DoublePoint{object.at.x + q.x, -(object.at.y + q.y)};
    });
    shape.id = object.id;
    for (const std::string& name : {object.className, tile.className})
      if (shape.className.empty()) shape.className = name;
    if (shape.kind == Kind::tile) leaveOut(shape, "a shape of its tile is a tile object");
    sink(shape, all);
  }
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
    constexpr std::size_t kTwice = 2 * kMaxCrossings;  // each crossing is seen from both of its edges
    const bool isTangled =
        crossings(snapped->ring, snapped->ring, kTwice) > kTwice;  // no drawing: a brush takes minutes
    if (isTangled) return "its outline crosses itself more than 1024 times";
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
    const auto toCell = [&](DoublePoint p) { return frame.toCell(p); };
    double out = 0;
    cutObject(object, outlines(object, toCell), grid, kMaxReach, budget, notes, [&](Cell shift, const Polygon& ring) {
      out = std::max(out, reach(shift, ring, grid));
      sink(shift, ring, object);
    });
    if (out > 0)
      addNote(notes, object, NoteKind::carried, out,
              concat("reaches up to ", pixels(out), " out of its cell: carried into the neighbouring cells"));
  }
}

void readObjects(MapSource& source, const Layer& layer, const Options& options, Budget& budget, const ShapeSink& sink) {
  for (const auto node : layer.node.children("object")) {
    CollisionObject object = readObject(*source.file, node, layer.offset, source.templates);
    if (source.file->failed()) return;
    if (layer.isPicked && !isPicked(object, options)) continue;
    object = asAsked(std::move(object), options);
    if (object.kind == Kind::tile) {
      readTileObject(std::move(object), source, {{kLayerProperty, layer.pathInMap}}, options, budget, sink);
      continue;
    }
    sink(object, outlines(object, [](DoublePoint p) { return DoublePoint{p.x, -p.y}; }));
  }
}

std::string pixels(double value) {
  return numberText(static_cast<double>(std::llround(std::fmin(value, 1e9) * 100)) / 100) + " px";
}

}  // namespace lgs::tiled
