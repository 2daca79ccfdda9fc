#include "ownership.h"

#include "geometry/ring.h"
#include "geometry/sort.h"
#include "outline.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace lgs::brush {
namespace {

using Owner = std::size_t;  ///< a group by its least polygon, what is painted, or none

/// Whether edges are the same outline as before. Those of before are not cut yet where rounding found hot points.
bool isSameOutline(List<HalfEdge> now, const List<HalfEdge>& before) {
  Points vertices, cuts;
  for (const HalfEdge& e : now) vertices.push_back(e.from);
  List<HalfEdge> parts;
  for (const HalfEdge& e : before) {
    detail::cutEdge(e.from, e.to, vertices, cuts);
    for (std::size_t k = 1; k < cuts.size(); ++k) parts.push_back({cuts[k - 1], cuts[k]});
  }
  detail::sort(now);
  detail::sort(parts);
  return now == parts;
}

std::size_t cornersOf(const List<HalfEdge>& outline) {
  std::size_t count = 0;
  for (const Points& ring : ringsOf(outline)) count += ring.size();
  return count;
}

/// An atom's ends and whose its sides are.
struct Sides {
  Point low, high;
  Owner left, right;
};

class Division {
 public:
  Division(const Ground& ground, const List<Atom>& atoms, const Stroke& stroke)
      : ground_(ground), stroke_(stroke), paint_(ground.polygons.size()), none_(paint_ + 1) {
    sides_.reserve(atoms.size());
    for (const Atom& a : atoms) sides_.push_back({a.low, a.high, ownerOf(a.left), ownerOf(a.right)});
    unionOf_ = ground.groups;
    unionOf_.insert(unionOf_.end(), {paint_, none_});
    changed_.assign(none_, false);
    changed_[paint_] = true;
    for (Owner k = 0; k < paint_; ++k) changed_[k] = unionOf_[k] == k && !isAsBefore(k);
    uniteNeighbours();
  }

  CellEdit result() const {
    CellEdit edit;
    List<std::size_t> old;
    for (Owner all = 0; all < none_; ++all) {
      if (unionOf_[all] != all) continue;
      bool isChanged = false;
      for (Owner k = all; k < none_; ++k) isChanged |= unionOf_[k] == all && changed_[k];
      if (!isChanged) continue;
      old.clear();
      for (Owner k = all; k < paint_; ++k)
        if (unionOf_[k] == all) old.push_back(k);
      edit.gone.insert(edit.gone.end(), old.begin(), old.end());
      const bool isOne = old.size() == 1 && unionOf_[paint_] != all;
      List<HalfEdge> outline = outlineOf(all);
      edit.isTooMuch = outline.size() > kMaxVerticesPerCell && cornersOf(outline) > kMaxVerticesPerCell;
      if (edit.isTooMuch) return edit;  // chords make it no less
      for (Points& ring : simplePolygons(std::move(outline))) {
        List<std::size_t> from = isOne ? old : partsIn(ring, old, ground_);
        edit.placed.push_back({std::move(ring), blockOf(all), std::move(from)});
      }
    }
    detail::sort(edit.gone);
    return edit;
  }

 private:
  Owner ownerOf(const Sum& sum) const {
    assert(sum.group >= 0 && std::cmp_less_equal(sum.group, paint_));
    const Owner before = sum.group == 0 ? none_ : static_cast<Owner>(sum.group) - 1;
    if (!isFilled(sum.winding, stroke_.rule)) return before;
    if (before != none_ && stroke_.stays(ground_.polygons[before].block)) return before;
    switch (stroke_.deed) {
      case Deed::carve:
        return none_;
      case Deed::fill:
        return before == none_ ? paint_ : before;
      case Deed::replace:
        return paint_;
    }
    return none_;
  }

  Block blockOf(Owner owner) const { return owner == paint_ ? stroke_.block : ground_.polygons[owner].block; }

  List<HalfEdge> outlineOf(Owner all) const {
    List<HalfEdge> edges;
    edges.reserve(sides_.size());
    for (const Sides& s : sides_) {
      const bool isLeft = unionOf_[s.left] == all, isRight = unionOf_[s.right] == all;
      if (isLeft && !isRight) edges.push_back({s.low, s.high});
      if (isRight && !isLeft) edges.push_back({s.high, s.low});
    }
    return edges;
  }

  /// Twice the area that an owner has now.
  std::int64_t doubleAreaOf(Owner owner) const {
    std::int64_t area = 0;
    for (const Sides& s : sides_) {
      const std::int64_t part = s.low.x * s.high.y - s.low.y * s.high.x;
      if (s.left == owner) area += part;
      if (s.right == owner) area -= part;
    }
    return area;
  }

  bool isAsBefore(Owner group) const {
    std::int64_t area = 0;
    for (Owner k = group; k < paint_; ++k)
      if (unionOf_[k] == group) area += detail::doubleArea(ground_.polygons[k].ring);
    // Areas are quicker to compare, and mostly tell.
    return doubleAreaOf(group) == area && isSameOutline(outlineOf(group), oldOutline(ground_, group));
  }

  /// Unites what shares an edge and has the same block.
  void uniteNeighbours() {
    for (const Sides& s : sides_) {
      if (s.left == none_ || s.right == none_ || blockOf(s.left) != blockOf(s.right)) continue;
      const Owner a = unionOf_[s.left], b = unionOf_[s.right];
      for (Owner& all : unionOf_)
        if (all == a || all == b) all = std::min(a, b);
    }
  }

  const Ground& ground_;
  const Stroke& stroke_;
  const Owner paint_, none_;
  List<Sides> sides_;
  List<Owner> unionOf_;  ///< by old polygon and owner: the least owner of the union that it is in
  List<bool> changed_;
};

}  // namespace

CellEdit divided(const Ground& ground, const List<Atom>& atoms, const Stroke& stroke) {
  return Division(ground, atoms, stroke).result();
}

}  // namespace lgs::brush
