// The pieces of all chains of a cell, each once, and what is on either side of them.
#pragma once

#include "snap.h"

#include <vector>

namespace lgs::brush {

/// Lower by y, then by x.
constexpr bool isLower(Point u, Point v) { return u.y != v.y ? u.y < v.y : u.x < v.x; }

/// A directed edge, with what it bounds on its left.
struct Edge {
  Point from, to;
  friend constexpr auto operator<=>(const Edge&, const Edge&) = default;
};

/// A straight piece of one chain or of several that came to lie on each other, from its lower end to the other one.
struct Atom {
  Point low, high;
  Sum sum;
  Sum left, right;  ///< what there is on either side
};

/// Adds the pieces of a chain.
void addAtoms(const std::vector<Point>& chain, const Sum& sum, std::vector<Atom>& atoms);

/// What is just to the left of a place: above it, where an atom runs to the left from there. Coordinates are doubled.
Sum sumLeftOf(Point doubled, const std::vector<Atom>& atoms);

/// Adds up atoms that are equal, and finds out what is on their sides. No two of the others may cross. Cost: O(n²).
void settle(std::vector<Atom>& atoms);

}  // namespace lgs::brush
