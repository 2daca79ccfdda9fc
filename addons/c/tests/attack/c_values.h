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
inline lgs_world* worldOf(Scene& s, Given given) { return given ? s.c.get() : nullptr; }

/// What a function says that must refuse a NULL for its world, or another pointer that must not be NULL.
inline lgs_status checked(lgs_status status, bool areGiven) {
  if (!areGiven) {
    EXPECT_EQ(status, LGS_BAD_ARGUMENT);
  }
  return status;
}
inline lgs_status checked(lgs_status status, Given world) { return checked(status, bool{world}); }

/// The vertices of a polygon in C, or NULL for them.
template <class T>
struct Ring : Space<T> {};

template <class T>
struct Hostile<Ring<T>> {
  using From = std::conditional_t<std::is_same_v<T, lgs_local_point>, Points,
                                  std::conditional_t<std::is_same_v<T, lgs_float_point>, Reals<float>, Reals<double>>>;
  static const std::vector<Ring<T>>& values(Scene& scene) {
    static const std::vector<Ring<T>> kAll = [&] {
      std::vector<Ring<T>> all;
      for (const From& points : Hostile<From>::values(scene)) all.push_back({{listOf<T>(points), true}});
      all.push_back({{all.front().items, false}});
      all.push_back({});
      all.back().isGiven = false;
      return all;
    }();
    return kAll;
  }
  static std::string told(const Ring<T>& ring) {
    return fmt::format("{} vertices{}", ring.size(), ring.isGiven ? "" : " at NULL");
  }
};

}  // namespace lgs::test
