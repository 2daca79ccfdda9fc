#include "atoms.h"

#include "geometry/predicates.h"
#include "geometry/sort.h"

#include <algorithm>

namespace lgs::brush {

using detail::operator-;  // NOLINT(misc-unused-using-decls): of points

Sum sumLeftOf(Point doubled, const List<Atom>& atoms) {
  // A ray from there to the far left passes other atoms; beyond all of them is nothing.
  const auto twice = [](Point p) { return Point{2 * p.x, 2 * p.y}; };
  Sum sum;
  for (const Atom& other : atoms) {
    if (2 * other.low.y > doubled.y || 2 * other.high.y <= doubled.y) continue;
    if (detail::orientation(twice(other.low), twice(other.high), doubled) < 0) sum += -other.sum;
  }
  return sum;
}

void addAtoms(const Points& chain, const Sum& sum, List<Atom>& atoms) {
  for (std::size_t k = 1; k < chain.size(); ++k) {
    const Point u = chain[k - 1], v = chain[k];
    if (isLower(u, v)) {
      atoms.push_back({u, v, sum, {}, {}});
    } else {
      atoms.push_back({v, u, -sum, {}, {}});
    }
  }
}

void merge(List<Atom>& atoms) {
  detail::sort(atoms, [](const Atom& a, const Atom& b) { return a.low != b.low ? a.low < b.low : a.high < b.high; });
  std::size_t count = 0;
  for (const Atom& atom : atoms) {
    if (count != 0 && atoms[count - 1].low == atom.low && atoms[count - 1].high == atom.high) {
      atoms[count - 1].sum += atom.sum;
    } else {
      if (count != 0 && atoms[count - 1].sum == Sum{}) --count;  // nothing changes across it
      atoms[count++] = atom;
    }
  }
  if (count != 0 && atoms[count - 1].sum == Sum{}) --count;
  atoms.resize(count);
}

void findSides(List<Atom>& atoms) {
  struct End {
    Point at;
    std::size_t atom;
  };
  List<End> ends;
  ends.reserve(2 * atoms.size());
  for (std::size_t k = 0; k < atoms.size(); ++k) ends.insert(ends.end(), {{atoms[k].low, k}, {atoms[k].high, k}});
  detail::sort(ends, [](const End& a, const End& b) { return isLower(a.at, b.at); });
  List<std::size_t> line, begun;  // those that the line cuts now, from the left; and those that begin at a vertex
  for (std::size_t k = 0; k < ends.size();) {
    const Point v = ends[k].at;
    begun.clear();
    for (; k < ends.size() && ends[k].at == v; ++k)
      if (atoms[ends[k].atom].low == v) begun.push_back(ends[k].atom);
    detail::sort(begun, [&](std::size_t a, std::size_t b) { return cross(atoms[a].high - v, atoms[b].high - v) < 0; });
    const auto here = std::partition_point(line.begin(), line.end(), [&](std::size_t a) {
      return detail::orientation(atoms[a].low, atoms[a].high, v) < 0;
    });
    auto ended = here;
    while (ended != line.end() && atoms[*ended].high == v) ++ended;
    Sum sum = here == line.begin() ? Sum{} : atoms[*(here - 1)].right;
    for (const std::size_t a : begun) {
      atoms[a].left = sum;
      sum += -atoms[a].sum;
      atoms[a].right = sum;
    }
    line.insert(line.erase(here, ended), begun.begin(), begun.end());
  }
}

}  // namespace lgs::brush
