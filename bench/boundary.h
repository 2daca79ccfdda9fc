// A boundary that can be compared, whoever computed it. The libraries differ in two ways: how they chain rings where
// solids touch in one point, and whether they keep vertices in straight runs. So all rings are taken apart into edges,
// and an edge that goes on straight where another one ends is joined to it. What is left are the corners.
#pragma once

#include <lgs/lattice.h>

#include <cstdint>
#include <string>
#include <vector>

namespace lgs::bench {

/// Directed, the solid on its left.
struct Edge {
  Point start;
  Point end;
  friend auto operator<=>(const Edge&, const Edge&) = default;
};
using Edges = std::vector<Edge>;
using Ring = std::vector<Point>;

/// Adds the edges of a ring. Turns the ring round if it does not wind as asked for, and skips repeated vertices.
enum class Winding { asItIs, counterClockwise, clockwise };
void addRing(Ring ring, Winding winding, Edges& edges);

struct Boundary {
  Edges straight;              ///< each as long as possible; sorted
  std::int64_t twiceArea = 0;  ///< twice the area of the solids, in square lattice units, modulo 2^64
  friend bool operator==(const Boundary&, const Boundary&) = default;

  std::uint64_t checksum() const;
};

/// The edges may come in any order. They must not overlap.
Boundary boundaryOf(const Edges& edges);

/// Says in a few words what differs; empty if nothing does.
std::string difference(const Boundary& expected, const Boundary& actual);

}  // namespace lgs::bench
