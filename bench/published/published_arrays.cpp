#include "bench/published/published_arrays.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace lgs::bench {
namespace {

PublishedArrays::Packed packed(Vec2 v) {
  return static_cast<std::uint32_t>(v.x) | static_cast<std::uint32_t>(v.y) << 16;
}

/// The angle from one direction to the other, normalised to [0, 2π), as the article has it.
float turningAngle(Vec2 from, Vec2 to, bool clockwise) {
  const float a = std::atan2(from.y, from.x), b = std::atan2(to.y, to.x);
  const float angle = clockwise ? a - b : b - a;
  return angle < 0 ? angle + 2 * std::numbers::pi_v<float> : angle;
}

}  // namespace

PublishedArrays::PublishedArrays(std::int32_t width, std::int32_t height)
    : width_(static_cast<std::uint32_t>(width)), height_(static_cast<std::uint32_t>(height)) {
  const std::size_t corners = std::size_t{width_ + 1} * (height_ + 1), sides = 2 * corners;
  boundaries_.resize(sides);
  manifold_.resize(corners);
  dirtySides_.is.resize(sides);
  dirtySides_.places.reserve(sides);
  dirtyCorners_.is.resize(corners);
  dirtyCorners_.places.reserve(corners);
  pool_.resize(8 * std::size_t{width_} * height_ + 1);  // of each cell four edges, and what is resolved of them
  for (std::size_t k = pool_.size(); k-- > 0;) free_.push_back(static_cast<Index>(k));
}

bool PublishedArrays::takes(std::span<const Vec2> polygon) {
  return std::ranges::all_of(polygon, [](Vec2 v) {
    return v.x >= 0 && v.y >= 0 && v.x < 0xffff && v.y < 0xffff && v.x == std::floor(v.x) && v.y == std::floor(v.y);
  });
}

std::int64_t PublishedArrays::sideOf(Packed start, Packed end) const {
  const Packed low = std::min(start, end);
  if (start >> 16 == end >> 16) return cornerOf(low);
  if ((start & 0xffff) == (end & 0xffff)) return static_cast<std::int64_t>(manifold_.size()) + cornerOf(low);
  return -1;
}

PublishedArrays::Index PublishedArrays::make(const Segment& segment) {
  const Index k = free_.back();
  free_.pop_back();
  pool_[k] = segment;
  return k;
}

void PublishedArrays::insertIntoManifold(Index k) {
  for (const Packed vertex : {pool_[k].start, pool_[k].end}) {
    manifold_[cornerOf(vertex)].push_back(k);
    dirtyCorners_.insert(cornerOf(vertex));
  }
}

void PublishedArrays::removeFromManifold(Index k) {
  for (const Packed vertex : {pool_[k].start, pool_[k].end}) {
    manifold_[cornerOf(vertex)].erase(k);
    dirtyCorners_.insert(cornerOf(vertex));
  }
  free_.push_back(k);
}

void PublishedArrays::removeResolved(Boundary& boundary) {
  for (const Index k : boundary.resolved) removeFromManifold(k);
  boundary.resolved.clear();
}

void PublishedArrays::add(Cell cell, std::span<const Vec2> polygon, Block block) {
  const auto number = static_cast<std::uint32_t>(cell.j) * width_ + static_cast<std::uint32_t>(cell.i);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Packed start = packed(polygon[i]), end = packed(polygon[i + 1 == polygon.size() ? 0 : i + 1]);
    const Index k = make({start, end, kNone, kNone, number, block});
    const std::int64_t side = sideOf(start, end);
    if (side < 0) {
      insertIntoManifold(k);
      continue;
    }
    Boundary& boundary = boundaries_[static_cast<std::size_t>(side)];
    boundary.segs.push_back(k);
    dirtySides_.insert(static_cast<std::uint32_t>(side));
    removeResolved(boundary);
  }
}

void PublishedArrays::remove(Cell cell, std::span<const Vec2> polygon, Block block) {
  const auto number = static_cast<std::uint32_t>(cell.j) * width_ + static_cast<std::uint32_t>(cell.i);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Packed start = packed(polygon[i]), end = packed(polygon[i + 1 == polygon.size() ? 0 : i + 1]);
    const auto isIt = [&](Index k) {
      const Segment& s = pool_[k];
      return s.cell == number && s.ogBlock == block && s.start == start && s.end == end;
    };
    const std::int64_t side = sideOf(start, end);
    if (side < 0) {
      const auto& at = manifold_[cornerOf(start)];
      const Index* const found = std::find_if(at.begin(), at.end(), isIt);
      if (found != at.end()) removeFromManifold(*found);
      continue;
    }
    Boundary& boundary = boundaries_[static_cast<std::size_t>(side)];
    const Index* const found = std::find_if(boundary.segs.begin(), boundary.segs.end(), isIt);
    if (found == boundary.segs.end()) continue;
    free_.push_back(*found);
    boundary.segs.erase(*found);
    dirtySides_.insert(static_cast<std::uint32_t>(side));
    removeResolved(boundary);
  }
}

/// Section 3.1. Of at most two edges, each as long as the side, the two special cases are all cases: one is copied, two
/// cancel. (Two of the same direction would be two polygons on one another.)
void PublishedArrays::resolve(Boundary& boundary) {
  if (boundary.segs.size() != 1) return;
  const Index copy = make(pool_[boundary.segs[0]]);
  insertIntoManifold(copy);
  boundary.resolved.push_back(copy);
}

/// Section 3.2.
void PublishedArrays::assignGhostVertices(std::uint32_t corner) {
  const auto& segs = manifold_[corner];
  for (const Index k : segs) {
    Segment& seg = pool_[k];
    const bool isOutgoing = cornerOf(seg.start) == corner;
    const Packed here = isOutgoing ? seg.start : seg.end, far = isOutgoing ? seg.end : seg.start;
    const auto direction = [here = unpacked(here)](Packed to) {
      const Vec2 v = unpacked(to);
      return Vec2{v.x - here.x, v.y - here.y};
    };
    float minAngle = std::numeric_limits<float>::infinity();
    for (const Index other : segs) {
      const Segment& cand = pool_[other];
      if ((cand.start == here) == isOutgoing) continue;
      const Packed candFar = isOutgoing ? cand.start : cand.end;
      const float angle = turningAngle(direction(far), direction(candFar), isOutgoing);
      if (angle < 1e-3F || angle >= minAngle) continue;
      minAngle = angle;
      (isOutgoing ? seg.ghost1 : seg.ghost2) = candFar;
    }
  }
}

void PublishedArrays::compute() {
  for (const std::uint32_t side : dirtySides_.places) resolve(boundaries_[side]);
  for (const std::uint32_t corner : dirtyCorners_.places) assignGhostVertices(corner);
  dirtySides_.clear();
  dirtyCorners_.clear();
}

}  // namespace lgs::bench
