// Doors that read a world, and change nothing.
#include "door.h"

#include <lgs/debug.h>

#include <cmath>

namespace lgs::test {
namespace {

bool isFar(std::int64_t a, std::int64_t b) {
  return std::max(a, b) - std::min(a, b) > kMaxRay * std::int64_t{kUnitsPerCell};
}

/// Whether the documents say that these segments are refused, with so much room.
bool areUnknown(const Scene& s, const std::vector<SegmentId>& ids, Room room) {
  for (std::size_t k = 0; k < std::min(ids.size(), room.size); ++k)
    if (!s.isAlive(ids[k])) return true;
  return false;
}

}  // namespace

void addDoorsOfReading(Doors& door) {
  const auto isUnknown = [](Scene& s, ShapeId id) { return id.value == 0 || id.value > s.world.stats().shapes; };
  door(
      "World::polygonsOf(ShapeId) const", [](Scene& s, ShapeId id) { return s.world.polygonsOf(id); }, isUnknown);
  door(
      "World::boundingBox(ShapeId) const", [](Scene& s, ShapeId id) { return s.world.boundingBox(id); }, isUnknown);
  door("World::changesOfRollBack() const", [](Scene& s) { return s.world.changesOfRollBack().added.size(); });
  door("World::followsCells() const", [](Scene& s) { return s.world.followsCells(); });
  door("World::hasUncommitted() const", [](Scene& s) { return s.world.hasUncommitted(); });
  door("World::versionBeforeCellChanges() const", [](Scene& s) { return s.world.versionBeforeCellChanges(); });
  door("World::cellChanges() const", [](Scene& s) { return s.world.cellChanges().size(); });
  door("World::save(const ByteSink&) const", [](Scene& s, const ByteSink& sink) { return s.world.save(sink); });
  door("World::polygons(Cell) const",
       [](Scene& s, Cell c) { EXPECT_EQ(s.world.polygons(c).empty(), s.world.isEmpty(c)); });
  door("World::polygons(Cell, vector<PlacedPolygon>&) const", [](Scene& s, Cell c) {
    std::vector<PlacedPolygon> out(77);
    s.world.polygons(c, out);
    EXPECT_EQ(out.size(), s.world.polygons(c).size());
  });
  door("World::isEmpty(Cell) const", [](Scene& s, Cell c) { EXPECT_TRUE(inRange(c) || s.world.isEmpty(c)); });
  door("World::forEachPolygon(const World::PolygonVisitor&) const",
       [](Scene& s, const World::PolygonVisitor& visit) { s.world.forEachPolygon(visit); });
  door("World::forEachPolygon(const CellRect&, const World::PolygonVisitor&) const",
       [](Scene& s, const CellRect& r, const World::PolygonVisitor& visit) {
         s.world.forEachPolygon(r, visit);
         s.world.forEachPolygon(r, [&](Cell cell, const PlacedPolygon&) { EXPECT_TRUE(contains(r, cell)); });
       });
  door("World::bounds() const",
       [](Scene& s) { EXPECT_EQ(s.world.bounds().has_value(), s.world.stats().polygons != 0); });
  const auto isStale = [](Scene& s, PolygonHandle h) { return !s.isAlive(h); };
  door(
      "World::polygon(PolygonHandle) const", [](Scene& s, PolygonHandle h) { return s.world.polygon(h); }, isStale);
  door(
      "World::cellOf(PolygonHandle) const", [](Scene& s, PolygonHandle h) { return s.world.cellOf(h); }, isStale);
  door(
      "World::segment(SegmentId) const", [](Scene& s, SegmentId id) { return s.world.segment(id); },
      [](Scene& s, SegmentId id) { return !s.isAlive(id); });
  door(
      "World::segments(span<const SegmentId>, span<Segment>) const",
      [](Scene& s, const std::vector<SegmentId>& ids, Room room) {
        std::vector<Segment> out(room.size);
        return s.world.segments(ids, out);
      },
      [](Scene& s, const std::vector<SegmentId>& ids, Room room) { return areUnknown(s, ids, room); });
  const auto isBadOrigin = [](Scene& s, const std::vector<SegmentId>& ids, Point origin, Room room) {
    return !inRange(origin) || areUnknown(s, ids, room);
  };
  door(
      "World::segments(span<const SegmentId>, Point, span<FloatSegment>) const",
      [](Scene& s, const std::vector<SegmentId>& ids, Point origin, Room room) {
        std::vector<FloatSegment> out(room.size);
        return s.world.segments(ids, origin, out);
      },
      isBadOrigin);
  door(
      "World::segments(span<const SegmentId>, Point, span<DoubleSegment>) const",
      [](Scene& s, const std::vector<SegmentId>& ids, Point origin, Room room) {
        std::vector<DoubleSegment> out(room.size);
        return s.world.segments(ids, origin, out);
      },
      isBadOrigin);
  door("World::segments() const", [](Scene& s) { return s.world.segments().size(); });
  door("World::segments(const CellRect&) const", [](Scene& s, const CellRect& r) {
    for (const SegmentId id : s.world.segments(r)) EXPECT_TRUE(contains(r, s.world.segment(id)->cell));
  });
  door("World::loops(Collinear) const", [](Scene& s, Collinear collinear) { return s.world.loops(collinear).size(); });
  door("World::at(Point) const", [](Scene& s, Point p) {
    const Spot spot = s.world.at(p);
    EXPECT_EQ(spot.where == Spot::Where::outside, !spot.polygon);
    EXPECT_TRUE(inRange(p) || !spot.polygon);
  });
  door(
      "World::nearest(Point, double) const",
      [](Scene& s, Point p, double radius) {
        const auto found = s.world.nearest(p, radius);
        EXPECT_TRUE(!found || !found->segment || found->distance <= radius + 1.0 / kUnitsPerCell);
        return found;
      },
      [](Scene&, Point p, double radius) {
        return !inRange(p) || std::isnan(radius) || radius < 0 || radius > kMaxRadius;
      });
  door(
      "World::rayCast(Point, Point) const", [](Scene& s, Point from, Point to) { return s.world.rayCast(from, to); },
      [](Scene&, Point from, Point to) {
        return !inRange(from) || !inRange(to) || isFar(from.x, to.x) || isFar(from.y, to.y);
      });
  door("World::preserveRelation() const", [](Scene& s) { return s.world.preserveRelation() ? 1U : 0U; });
  door("World::version() const", [](Scene& s) { return s.world.version(); });
  door("World::maxSegmentId() const", [](Scene& s) { return s.world.maxSegmentId(); });
  door("World::stats() const", [](Scene& s) { return s.world.stats().bytes; });
  door("samePolygons(const World&, const World&)", [](Scene& s, bool isSelf) {
    EXPECT_TRUE(samePolygons(s.world, s.world));
    return samePolygons(s.world, isSelf ? s.world : s.other);
  });
  door("writeTrace(const World&)", [](Scene& s) { return writeTrace(s.world).size(); });
  door("writeSvg(const World&, const SvgOverlay&)",
       [](Scene& s, const SvgOverlay& overlay) { return writeSvg(s.world, overlay).size(); });
}

}  // namespace lgs::test
