// The pieces of all chains of a cell, each once, and what is on either side of them.
#pragma once

#include "snap.h"

namespace lgs::brush {

/// Lower by y, then by x.
constexpr bool isLower(Point u, Point v) { return u.y != v.y ? u.y < v.y : u.x < v.x; }

/// A directed edge, with what it bounds on its left.
struct HalfEdge {
  Point from, to;
  friend constexpr auto operator<=>(const HalfEdge&, const HalfEdge&) = default;
};

/// A straight piece of one chain or of several that came to lie on each other, from its lower end to the other one.
struct Atom {
  Point low, high;
  Sum sum;
  Sum left, right;  ///< what there is on either side
};

/// Adds the pieces of a chain.
void addAtoms(const Points& chain, const Sum& sum, List<Atom>& atoms);

/// What is just to the left of a place: above it, where an atom runs to the left from there. Coordinates are doubled.
Sum sumLeftOf(Point doubled, const List<Atom>& atoms);

/// Adds up atoms that are equal, and sorts them.
void merge(List<Atom>& atoms);

/// Finds out what is on the sides of atoms. No two may meet but in their ends. A line sweeps over them, by y, then x.
/// It leans a little, so that it passes the left end of a level atom first.
void findSides(List<Atom>& atoms);

}  // namespace lgs::brush
