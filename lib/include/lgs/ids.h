// Names for things in a world. All are plain values: copy, compare, hash and store them as you like.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace lgs {

/// An opaque number of the user's that a polygon carries: a material, a tile kind, an entity.
using Block = std::uint32_t;

/// A set of local polygons that a World has validated and interned. Valid for the world that made it, as long as that
/// world lives. Zero is null.
struct ShapeId {
  std::uint32_t value = 0;
  constexpr explicit operator bool() const { return value != 0; }
  friend constexpr auto operator<=>(ShapeId, ShapeId) = default;
};

/// One placed polygon. Generational: once the polygon is removed its handle is stale for good, and using it is an error,
/// never another polygon. Zero is null. `cellRef` and `serial` are the world's own; packed() is for storage, e.g. in a
/// physics engine's user data.
struct PolygonHandle {
  std::uint32_t cellRef = 0;
  std::uint32_t serial = 0;
  constexpr explicit operator bool() const { return cellRef != 0; }
  constexpr std::uint64_t packed() const { return std::uint64_t{cellRef} << 32 | serial; }
  static constexpr PolygonHandle unpack(std::uint64_t v) {
    return {static_cast<std::uint32_t>(v >> 32), static_cast<std::uint32_t>(v)};
  }
  friend constexpr auto operator<=>(PolygonHandle, PolygonHandle) = default;
};

/// One boundary segment. Ids are small dense integers, so an array indexed by `value` is a good side table. An id stays
/// with its segment until a commit reports it removed; from the next commit on it may name a new segment. Zero is null.
struct SegmentId {
  std::uint32_t value = 0;
  constexpr explicit operator bool() const { return value != 0; }
  friend constexpr auto operator<=>(SegmentId, SegmentId) = default;
};

/// A moment to which a world can go back: see World::checkpoint(). Zero is null.
struct Mark {
  std::uint32_t value = 0;
  constexpr explicit operator bool() const { return value != 0; }
  friend constexpr auto operator<=>(Mark, Mark) = default;
};

}  // namespace lgs

template <>
struct std::hash<lgs::PolygonHandle> {
  std::size_t operator()(lgs::PolygonHandle h) const noexcept { return std::hash<std::uint64_t>{}(h.packed()); }
};
template <>
struct std::hash<lgs::ShapeId> {
  std::size_t operator()(lgs::ShapeId s) const noexcept { return std::hash<std::uint32_t>{}(s.value); }
};
template <>
struct std::hash<lgs::SegmentId> {
  std::size_t operator()(lgs::SegmentId s) const noexcept { return std::hash<std::uint32_t>{}(s.value); }
};
