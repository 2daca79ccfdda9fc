// A side lies between two cells. This walks along it, and finds the spokes of one of the two at each vertex between
// the corners.
#pragma once

#include "outline/fan.h"
#include "outline/outline.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>

namespace lgs::detail {

/// Walks along a side of a cell, from vertex to vertex, by increasing coordinate.
class SideWalk {
 public:
  /// `at` may be without chunk.
  SideWalk(const Ground& ground, const Outline& outline, CellAt at, unsigned side)
      : pool_(outline.segments), content_(ground.content(at)), side_(side), points_(content_.sides[side].points) {
    const CellSegments shown = outline.lists.of(at);
    interior_ = shown.ids();
    ids_ = shown.part(partOf(side));
  }
  bool done() const { return points_.empty(); }
  std::int32_t next() const { return done() ? kUnitsPerCell : points_.front().at; }

  /// Adds the cell's segment along the side that lies beyond the vertex, or the one before it.
  void addSideSpokes(Fan& fan, std::int32_t vertex, bool beyond, std::uint32_t stretch) {
    while (!ids_.empty() && bounds(ids_.front()).second < vertex) ids_ = ids_.subspan(1);
    for (const std::uint32_t id : ids_.first(std::min<std::size_t>(ids_.size(), 2))) {
      const auto [low, high] = bounds(id);
      if ((beyond ? low : high) == vertex)
        fan.add(id, stretch * kStretch, along(side_, pool_[id].start()) == vertex ? 1 : 0, 1);
    }
  }
  void addInteriorSpokes(Fan& fan, std::int32_t vertex, std::uint32_t stretch) const {
    if (next() == vertex) fan.addInterior(content_, points_.front().spokes, interior_, stretch);
  }
  void pass(std::int32_t vertex) {
    if (next() == vertex) points_ = points_.subspan(1);
  }

 private:
  std::pair<std::int32_t, std::int32_t> bounds(std::uint32_t id) const {
    return std::minmax(along(side_, pool_[id].start()), along(side_, pool_[id].end()));
  }

  const SegmentPool& pool_;
  const Content& content_;
  unsigned side_;
  std::span<const RimPoint> points_;
  const std::uint32_t* interior_;
  std::span<const std::uint32_t> ids_;
};

}  // namespace lgs::detail
