// What must be refused whatever stands in a world, or comes to nothing: ends of numbers, unknown names, too much at
// once. Each refusal has its reason and says it in words; afterwards nothing has changed (law 7).
#include "fuzz/beside.h"
#include "fuzz/questions.h"
#include "fuzz/same.h"
#include "fuzz/units.h"

#include <lgs/brush.h>
#include <lgs/debug.h>
#include <array>
#include <limits>

namespace lgs::fuzz {
namespace {

constexpr CellRect kNone{{1, 0}, {0, 0}}, kBeyond{{0, 0}, {kMaxCell + 1, 0}};
constexpr CellRect kAll{{-kMaxCell, -kMaxCell}, {kMaxCell, kMaxCell}};

template <class Answer>
bool isRefused(const Answer& answer, ErrorCode code) {
  return !answer && answer.error().code == code && !message(answer.error()).empty() && *name(code) != '\0';
}

std::vector<LocalPoint> manyVertices() {
  std::vector<LocalPoint> ring;
  for (std::int32_t k = 0; k <= static_cast<std::int32_t>(kMaxVerticesPerCell); ++k) ring.push_back({k, k % 2});
  return ring;
}

bool refusesMarks(World& world) {
  return isRefused(world.rollBack({}), ErrorCode::unknownMark) && isRefused(world.redo({}), ErrorCode::unknownMark) &&
         isRefused(world.forget({}), ErrorCode::unknownMark);
}

bool refusesPlaces(World& world) {
  const auto sink = [](Cell, auto) {};
  return isRefused(world.unload(kBeyond, sink), ErrorCode::cellOutOfRange) &&
         isRefused(world.reloadEmpty(kBeyond), ErrorCode::cellOutOfRange) &&
         isRefused(world.clear(kBeyond), ErrorCode::cellOutOfRange) && world.unload(kNone, sink).value_or(1) == 0 &&
         world.reloadEmpty(kNone).value_or(1) == 0 && world.clear(kNone).value_or(1) == 0 &&
         world.forgetChunks(kNone).value_or(1) == 0 && !world.firstUnloaded(kNone) && world.isEmpty(kBeyond.max) &&
         world.polygons(kBeyond.max).empty() && world.segments(kNone).empty();
}

bool refusesShapes(World& world) {
  const std::vector<LocalPoint> many = manyVertices();
  const std::array<FloatPoint, 3> none{{{0, 0}, {1, 0}, {0, std::numeric_limits<float>::quiet_NaN()}}};
  const std::vector<DoublePoint> reals(many.size());
  const Cell cell = world.bounds().value_or(CellRect{}).min;
  return isRefused(world.shape(many), ErrorCode::capacity) &&
         isRefused(world.add(cell, many, 1), ErrorCode::capacity) &&
         isRefused(world.shape(reals), ErrorCode::capacity) &&
         isRefused(world.add(cell, none, 1), ErrorCode::notFinite) &&
         isRefused(world.shape(std::vector<std::vector<LocalPoint>>()), ErrorCode::emptyShape) &&
         isRefused(world.fill(kAll, ShapeId{0x7fff'ffff}, 1), ErrorCode::unknownShape) &&
         isRefused(world.addMany(std::array{Placement{cell, ShapeId{}, 1}}), ErrorCode::unknownShape) &&
         isRefused(world.boundingBox({}), ErrorCode::unknownShape);
}

bool refusesNames(World& world) {
  const std::vector<SegmentId> none{{}};
  std::vector<Segment> out(1);
  std::vector<FloatSegment> reals(1);
  bool isTold = isRefused(world.segment({}), ErrorCode::unknownSegment) &&
                isRefused(world.segments(none, out), ErrorCode::unknownSegment) &&
                isRefused(world.segments(none, {kMaxCoordinate + 1, 0}, reals), ErrorCode::outOfReach) &&
                isRefused(world.remove({}), ErrorCode::staleHandle);
  PolygonHandle any{};
  world.forEachPolygon([&](Cell, const PlacedPolygon& p) { any = p.handle; });
  if (!any.cellRef) return isTold;
  const std::array twice{any, any};
  const auto done = world.removeMany(twice);
  return isTold && isRefused(done, ErrorCode::staleHandle) && done.error().index == 1 && done.error().index2 == 0;
}

/// Regions that are none: too large, too far, made with a length that is none, too much for a cell.
bool refusesRegions(World& world) {
  constexpr std::int64_t kTooLong = (kMaxRegionCells / 2 + 1) * kCell;
  const Point far{kMaxCoordinate + 1, 0};
  const std::array line{Point{}, far}, still{Point{}, Point{}};
  Region crowded;
  for (std::int64_t k = 0; k <= 3'000; ++k)
    crowded.rings.push_back({{1, 2 * k}, {kCell - 1, 2 * k + 1}, {kCell - 1, 2 * k + 2}});
  const Region wide{{{{0, 0}, {2 * kTooLong, 0}, {0, kCell}}}}, high{{{{0, 0}, {kCell, 0}, {0, 2 * kTooLong}}}};
  for (const Region& region : {circle({}, 0), circle({}, kTooLong), circle(far, kCell), rectangle({}, {1, 0}, 0, kCell),
                               rectangle({}, {1, 0}, kCell, 0), rectangle(far, {1, 0}, kCell, kCell),
                               thickLine(line, kCell), thickLine(still, 0), wide, high}) {
    if (!isRefused(carve(world, region), ErrorCode::outOfReach) || !isRefused(cellsOf(region), ErrorCode::outOfReach) ||
        !isRefused(without(region, crowded), ErrorCode::outOfReach) || meets(region, {{0, 0}, {1, 0}, {0, 1}}))
      return false;
  }
  if (!isRefused(without(circle({}, kCell), wide), ErrorCode::outOfReach)) return false;
  World empty;
  const bool isCrowded = isRefused(paint(empty, crowded, 1, PaintMode::fill), ErrorCode::capacity) &&
                         isRefused(cellsOf(crowded), ErrorCode::capacity);
  const Region tiny = rectangle({9, 9}, {std::int64_t{1} << 40, 1}, 99, 9), flat{{{{0, 0}, {kCell, 0}, {9, 0}}}};
  const auto nothing = paint(empty, flat, 1, PaintMode::fill);
  return isCrowded && boundsOf(tiny) && nothing && empty.stats().polygons == 0 && samePolygons(empty, World()) &&
         !meets(tiny, {{0, 0}, {1, 0}}) && thickLine({}, kCell).rings.empty();
}

}  // namespace

std::string refuseAll(World& world) {
  const World before = world;
  const bool hasSelf = &(world = static_cast<const World&>(world)) == &world;
  if (!hasSelf || !refusesMarks(world)) return "an unknown mark is taken";
  if (!refusesPlaces(world)) return "a place that is none is taken";
  if (!refusesShapes(world)) return "a shape that is none is taken";
  if (!refusesNames(world)) return "a name that names nothing is taken";
  if (!refusesRegions(world)) return "a region that is none is taken";
  const Mark mark = world.mark();
  if (!isRefused(world.followCells(true), ErrorCode::uncommitted)) return "cells are followed from a mark on";
  if (!isRefused(world.forgetChunks(kAll), ErrorCode::uncommitted)) return "chunks are forgotten while there is a mark";
  if (!world.forget(mark)) return "a mark is lost";
  if (!writeSvg(world, {"<g/>", 2, {}}).ends_with("</svg>\n") || !writeSvg(world, {"<g/>", -1, {}}).starts_with("<svg"))
    return "a picture has no end";
  const std::string wrong = differenceOf(before, world);
  return wrong.empty() ? wrong : "what was refused leaves " + wrong;
}

}  // namespace lgs::fuzz
