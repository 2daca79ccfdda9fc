// What stands behind the C interface: a World, the lists of its last commit as C sees them, and the ways between the
// values of both sides. Values are copied, never cast, so that no compiler is misled about what a pointer leads to.
#pragma once

#include <lgs/lgs.h>
#include <lgs/world.h>

#include <algorithm>
#include <cstring>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

struct lgs_world {
  explicit lgs_world(lgs::World w) : world(std::move(w)) {}

  lgs::World world;
  /// The lists of the last commit or roll-back, one after the other. It only grows.
  std::vector<lgs_segment_id> changed;
  // Working memory. It is kept from one call to the next, to spare allocations.
  std::vector<lgs::LocalPoint> points;
  std::vector<lgs::FloatPoint> floats;
  std::vector<lgs::DoublePoint> doubles;
};

namespace lgs::c {

// --- Values ----------------------------------------------------------------------------------------------------------

inline lgs_polygon_id toC(PolygonHandle v) { return {v.cellRef, v.serial}; }
inline lgs_segment_id toC(SegmentId v) { return {v.value}; }
inline lgs_cell toC(Cell v) { return {v.i, v.j}; }
inline lgs_local_point toC(LocalPoint v) { return {v.x, v.y}; }
inline lgs_point toC(Point v) { return {v.x, v.y}; }
inline lgs_float_point toC(FloatPoint v) { return {v.x, v.y}; }
inline lgs_double_point toC(DoublePoint v) { return {v.x, v.y}; }

inline PolygonHandle fromC(lgs_polygon_id v) { return {v.cell_ref, v.serial}; }
inline SegmentId fromC(lgs_segment_id v) { return {v.value}; }
inline ShapeId fromC(lgs_shape_id v) { return {v.value}; }
inline Mark fromC(lgs_mark v) { return {v.value}; }
inline Cell fromC(lgs_cell v) { return {v.i, v.j}; }
inline CellRect fromC(lgs_cell_rect v) { return {fromC(v.min), fromC(v.max)}; }
inline Point fromC(lgs_point v) { return {v.x, v.y}; }
inline DoublePoint fromC(lgs_double_point v) { return {v.x, v.y}; }

/// Copies an array of values that are the same bytes on both sides.
template <class From, class To>
void copyBytes(const From* from, std::size_t count, std::vector<To>& to) {
  static_assert(sizeof(From) == sizeof(To) && std::is_trivially_copyable_v<From> && std::is_trivially_copyable_v<To>);
  to.resize(count);
  if (count != 0) std::memcpy(static_cast<void*>(to.data()), from, count * sizeof(To));
}

// --- Answers ---------------------------------------------------------------------------------------------------------

/// Writes an output that may not be wanted.
template <class T>
void put(T* out, const T& value) {
  if (out) *out = value;
}

/// Writes the error, where it is wanted, and returns its code.
lgs_status refuse(const Error& error, lgs_error* out);
lgs_status refuse(const SnapshotError& error, lgs_error* out);
lgs_status refuse(lgs_status status, lgs_error* out);

/// Whether an array may be read.
template <class T>
bool isArray(const T* first, std::size_t count) {
  return first || count == 0;
}

/// Writes what there is room for, as a list. `convert` makes a value of C of each.
template <class Values, class Out, class Convert>
lgs_status putList(const Values& values, Out* out, std::size_t capacity, std::size_t* count, Convert&& convert) {
  if (!isArray(out, capacity)) return LGS_BAD_ARGUMENT;
  put(count, values.size());
  const std::size_t room = std::min(values.size(), capacity);
  for (std::size_t k = 0; k < room; ++k) out[k] = convert(values[k]);
  return values.size() <= capacity ? LGS_OK : LGS_SHORT_BUFFER;
}
template <class Values, class Out>
lgs_status putList(const Values& values, Out* out, std::size_t capacity, std::size_t* count) {
  return putList(values, out, capacity, count, [](const auto& value) { return toC(value); });
}

/// What a polygon shows of itself.
lgs_polygon described(Cell cell, const PlacedPolygon& polygon);

}  // namespace lgs::c
