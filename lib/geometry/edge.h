// The sides of a cell, and the ends of an edge in it.
#pragma once

#include <lgs/lattice.h>

#include <array>
#include <cstdint>

namespace lgs::detail {

/// The four sides, counter-clockwise. Edges along them run counter-clockwise too: to the right along the south side.
enum SideIndex : unsigned { kSouth, kEast, kNorth, kWest, kSides };

constexpr unsigned opposite(unsigned side) { return (side + 2) % kSides; }
constexpr unsigned sideBefore(unsigned side) { return (side + 3) % kSides; }
constexpr bool isVertical(unsigned side) { return side % 2 == 1; }

/// The corners, counter-clockwise. Side k starts at corner k.
constexpr std::array<LocalPoint, 4> kCorners{
    {{0, 0}, {kUnitsPerCell, 0}, {kUnitsPerCell, kUnitsPerCell}, {0, kUnitsPerCell}}};

/// Where on a side a point is, by its x or its y; and the point there.
constexpr std::int32_t along(unsigned side, LocalPoint p) { return isVertical(side) ? p.y : p.x; }
constexpr LocalPoint pointAt(unsigned side, std::int32_t at) {
  switch (side) {
    case kSouth:
      return {at, 0};
    case kEast:
      return {kUnitsPerCell, at};
    case kNorth:
      return {at, kUnitsPerCell};
    default:
      return {0, at};
  }
}
/// Whether edges along this side run towards increasing x or y.
constexpr bool runsForward(unsigned side) { return side == kSouth || side == kEast; }

/// The ends of an edge in one cell. A coordinate is 0 … 65,536. Its 17th bit is in `high`.
struct PackedEnds {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  std::uint32_t high = 0;

  static constexpr PackedEnds of(LocalPoint start, LocalPoint end) {
    const auto bits = [](std::int32_t v) { return static_cast<std::uint32_t>(v); };
    const auto low = [&](LocalPoint p) { return (bits(p.x) & 0xffffu) | (bits(p.y) & 0xffffu) << 16; };
    return {low(start), low(end),
            bits(start.x) >> 16 | bits(start.y) >> 16 << 1 | bits(end.x) >> 16 << 2 | bits(end.y) >> 16 << 3};
  }
  constexpr LocalPoint start() const { return point(from, high); }
  constexpr LocalPoint end() const { return point(to, high >> 2); }
  friend constexpr bool operator==(const PackedEnds&, const PackedEnds&) = default;

 private:
  static constexpr LocalPoint point(std::uint32_t low, std::uint32_t high) {
    return {static_cast<std::int32_t>((low & 0xffffu) | (high & 1u) << 16),
            static_cast<std::int32_t>(low >> 16 | (high >> 1 & 1u) << 16)};
  }
};

/// The edge along a whole side, as its cell has it.
constexpr std::array<PackedEnds, 4> kSideEnds{
    {PackedEnds::of(kCorners[0], kCorners[1]), PackedEnds::of(kCorners[1], kCorners[2]),
     PackedEnds::of(kCorners[2], kCorners[3]), PackedEnds::of(kCorners[3], kCorners[0])}};

}  // namespace lgs::detail
