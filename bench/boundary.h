// A boundary that can be compared, whoever computed it. The libraries chain their rings differently where solids touch in
// one point, and keep or drop vertices in straight runs. Both are gone when all edges are taken apart, put on their
// lines, and joined wherever one goes on where another ends: what is left are the corners.
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

/// The edges of a ring; turned round where it does not run in the direction asked for. Repeated vertices are skipped.
enum class Turn { asItIs, counterClockwise, clockwise };
void addRing(Ring ring, Turn turn, Edges& edges);

struct Boundary {
  Edges straight;              ///< each as long as it can be; sorted
  std::int64_t twiceArea = 0;  ///< of the solids, in lattice units; modulo 2^64
  friend bool operator==(const Boundary&, const Boundary&) = default;

  std::uint64_t checksum() const;
};

/// Edges need not be sorted, and must not overlap.
Boundary boundaryOf(const Edges& edges);

/// What differs, in a few words; empty if nothing does.
std::string difference(const Boundary& expected, const Boundary& actual);

}  // namespace lgs::bench
