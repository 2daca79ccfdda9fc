#include "atoms.h"

#include "geometry/predicates.h"
#include "geometry/sort.h"

namespace lgs::brush {

Sum sumLeftOf(Point doubled, const std::vector<Atom>& atoms) {
  // A ray from there to the far left passes other atoms; beyond all of them is nothing.
  const auto twice = [](Point p) { return Point{2 * p.x, 2 * p.y}; };
  Sum sum;
  for (const Atom& other : atoms) {
    if (2 * other.low.y > doubled.y || 2 * other.high.y <= doubled.y) continue;
    if (detail::orientation(twice(other.low), twice(other.high), doubled) < 0) sum += -other.sum;
  }
  return sum;
}

void addAtoms(const std::vector<Point>& chain, const Sum& sum, std::vector<Atom>& atoms) {
  for (std::size_t k = 1; k < chain.size(); ++k) {
    const Point u = chain[k - 1], v = chain[k];
    if (isLower(u, v)) {
      atoms.push_back({u, v, sum, {}, {}});
    } else {
      atoms.push_back({v, u, -sum, {}, {}});
    }
  }
}

void settle(std::vector<Atom>& atoms) {
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
  for (Atom& atom : atoms) {
    atom.left = sumLeftOf({atom.low.x + atom.high.x, atom.low.y + atom.high.y}, atoms);
    atom.right = atom.left;
    atom.right += -atom.sum;
  }
}

}  // namespace lgs::brush
