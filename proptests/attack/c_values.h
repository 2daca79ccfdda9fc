// What doors of the C interface share: values of C++ as those of C, and what a call says that is handed a NULL.
#pragma once

#include "door.h"

#include <lgs/lgs.h>

namespace lgs::test {

constexpr lgs_cell toC(Cell c) { return {c.i, c.j}; }
constexpr lgs_cell_rect toC(const CellRect& r) { return {toC(r.min), toC(r.max)}; }
constexpr lgs_point toC(Point p) { return {p.x, p.y}; }
constexpr lgs_polygon_id toC(PolygonHandle h) { return {h.cellRef, h.serial}; }
constexpr lgs_segment_id toC(SegmentId id) { return {id.value}; }
constexpr lgs_shape_id toC(ShapeId id) { return {id.value}; }

template <class To, class From>
std::vector<To> listOf(const std::vector<From>& from) {
  std::vector<To> list;
  for (const From& each : from) list.push_back({each.x, each.y});
  return list;
}
template <class To, class From>
std::vector<To> idsOf(const std::vector<From>& from) {
  std::vector<To> list;
  for (const From& each : from) list.push_back(toC(each));
  return list;
}

/// The world, or none.
inline lgs_world* worldOf(Scene& s, Given given) { return given.isGiven ? s.c.get() : nullptr; }

/// What a function says that must refuse a NULL for its world, or another pointer that must not be NULL.
inline lgs_status checked(lgs_status status, bool areGiven) {
  if (!areGiven) {
    EXPECT_EQ(status, LGS_BAD_ARGUMENT);
  }
  return status;
}
inline lgs_status checked(lgs_status status, Given world) { return checked(status, world.isGiven); }

/// Makes a polygon's points in C, and calls with them, with their number, and perhaps with NULL for them.
template <class To, class From, class Call>
lgs_status withPoints(const std::vector<From>& points, Given given, Call call) {
  const std::vector<To> list = listOf<To>(points);
  return checked(call(given.isGiven ? list.data() : nullptr, list.size()), given.isGiven || list.empty());
}

}  // namespace lgs::test
