// Names for the things in a world. All are plain values: copy, compare, hash and store them as you like.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace lgs {

/// A number of yours that a polygon carries, say of a material, a kind of tile or an entity. The world does not read
/// it.
using Block = std::uint32_t;

/// A set of polygons that a World has validated and stored. It is valid for the world that made it, as long as that
/// world lives. Zero is null.
struct ShapeId {
  std::uint32_t value = 0;                                         ///< for the world that made it
  constexpr explicit operator bool() const { return value != 0; }  ///< whether it is not null
  friend constexpr auto operator<=>(ShapeId, ShapeId) = default;
};

/// One placed polygon. Once the polygon is removed its handle is stale: to use it is an error, and it never names
/// another polygon, unless the world rolls back to a time before that polygon was (World::rollBack()), or forgets the
/// place (World::forgetChunks()). Zero is null. `cellRef` and `serial` mean something to the world only. packed() is
/// for storage, say in the user data of a physics engine.
struct PolygonHandle {
  std::uint32_t cellRef = 0;                                         ///< for the world; 0 in a null handle
  std::uint32_t serial = 0;                                          ///< for the world
  constexpr explicit operator bool() const { return cellRef != 0; }  ///< whether it is not null
  /// All of it in 64 bits; 0 for null.
  constexpr std::uint64_t packed() const { return std::uint64_t{cellRef} << 32 | serial; }
  /// The handle of which packed() made `v`. Another number gives a handle that may name nothing.
  static constexpr PolygonHandle unpack(std::uint64_t v) {
    return {static_cast<std::uint32_t>(v >> 32), static_cast<std::uint32_t>(v)};
  }
  friend constexpr auto operator<=>(PolygonHandle, PolygonHandle) = default;
};

/// One boundary segment. Ids are small dense integers, so an array indexed by `value` can hold what you know of
/// segments. An id stays with its segment until a commit reports it as removed. From the next commit on it may name a
/// new segment. Zero is null.
struct SegmentId {
  std::uint32_t value = 0;  ///< good as an index; World::maxSegmentId() is the highest
  constexpr explicit operator bool() const { return value != 0; }  ///< whether it is not null
  friend constexpr auto operator<=>(SegmentId, SegmentId) = default;
};

/// A moment to which a world can roll back: see World::mark(). Zero is null.
struct Mark {
  std::uint64_t value = 0;                                         ///< for the world that made it
  constexpr explicit operator bool() const { return value != 0; }  ///< whether it is not null
  friend constexpr auto operator<=>(Mark, Mark) = default;
};

}  // namespace lgs

/// Equal handles have equal hashes.
template <>
struct std::hash<lgs::PolygonHandle> {
  std::size_t operator()(lgs::PolygonHandle h) const noexcept { return std::hash<std::uint64_t>{}(h.packed()); }
};
/// Equal ids have equal hashes.
template <>
struct std::hash<lgs::ShapeId> {
  std::size_t operator()(lgs::ShapeId s) const noexcept { return std::hash<std::uint32_t>{}(s.value); }
};
/// Equal ids have equal hashes.
template <>
struct std::hash<lgs::SegmentId> {
  std::size_t operator()(lgs::SegmentId s) const noexcept { return std::hash<std::uint32_t>{}(s.value); }
};
