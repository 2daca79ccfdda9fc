// Doors of values: they ask no world.
#include "door.h"

#include <lgs/radial_match.h>
#include <lgs/version.h>

namespace lgs::test {

void addDoorsOfValues(Doors& door) {
  door("ShapeId::operator bool() const", [](Scene&, ShapeId id) { return id ? 1U : 0U; });
  door("PolygonHandle::operator bool() const", [](Scene&, PolygonHandle h) { return h ? 1U : 0U; });
  door("SegmentId::operator bool() const", [](Scene&, SegmentId id) { return id ? 1U : 0U; });
  door("Mark::operator bool() const", [](Scene&, Mark mark) { return mark ? 1U : 0U; });
  door("PolygonHandle::packed() const",
       [](Scene&, PolygonHandle h) { EXPECT_EQ(PolygonHandle::unpack(h.packed()), h); });
  door("PolygonHandle::unpack(uint64_t)",
       [](Scene&, std::uint64_t v) { EXPECT_EQ(PolygonHandle::unpack(v).packed(), v); });
  door("inRange(Cell)", [](Scene&, Cell cell) { return inRange(cell); });
  door("inRange(Point)", [](Scene&, Point p) { return inRange(p); });
  door("contains(const CellRect&, Cell)",
       [](Scene&, const CellRect& r, Cell cell) { EXPECT_FALSE(contains(r, cell) && isEmpty(r)); });
  door("isEmpty(const CellRect&)", [](Scene&, const CellRect& r) { return isEmpty(r); });
  door("toWorld(Cell, LocalPoint)", [](Scene&, Cell cell, LocalPoint p) { return toWorld(cell, p); });
  door("cellAt(Point)", [](Scene&, Point p) {
    EXPECT_TRUE(!inRange(p) || contains({{-kMaxCell - 1, -kMaxCell - 1}, {kMaxCell + 1, kMaxCell + 1}}, cellAt(p)));
  });
  door("latticePoint(DoublePoint)", [](Scene&, DoublePoint p) { return latticePoint(p); });
  door("Error::hasCell() const", [](Scene&, const Error& error) { return error.hasCell(); });
  door("name(ErrorCode)", [](Scene&, ErrorCode code) { EXPECT_NE(name(code), nullptr); });
  door("message(const Error&)", [](Scene&, const Error& error) { EXPECT_FALSE(message(error).empty()); });
  door("message(const SnapshotError&)",
       [](Scene&, const SnapshotError& error) { EXPECT_FALSE(message(error).empty()); });
  door("Segment::length() const", [](Scene&, const Segment& segment) {
    EXPECT_GE(segment.length(), 0);  // and it is a number
  });
  door("Segment::normal() const", [](Scene&, const Segment& segment) {
    EXPECT_TRUE(segment.start == segment.end || std::abs(segment.normal().x) <= 1);
  });
  door("version()", [](Scene&) { EXPECT_EQ(version(), kVersion); });
  door("radialMatch(span<const Point>, span<const DirectedEdge>)",
       [](Scene&, const std::vector<Point>& points, const std::vector<DirectedEdge>& edges) {
         return radialMatch(points, edges);
       });
  door("loopsOf(span<const EdgeLinks>)", [](Scene&, const std::vector<EdgeLinks>& links) { return loopsOf(links); });
}

}  // namespace lgs::test
