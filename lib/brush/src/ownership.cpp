#include "ownership.h"

#include "geometry/ring.h"
#include "outline.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

namespace lgs::brush {
namespace {

using Owner = std::size_t;  ///< an old polygon by index, what is painted, or nobody

/// An atom's ends and whose its sides are.
struct Sides {
  Point low, high;
  Owner left, right;
};

class Division {
 public:
  Division(const std::vector<CellPolygon>& polygons, const std::vector<bool>& reached, const std::vector<Atom>& atoms,
           const Stroke& stroke)
      : polygons_(polygons), reached_(reached), stroke_(stroke), paint_(polygons.size()), nobody_(paint_ + 1) {
    for (const Atom& a : atoms) sides_.push_back({a.low, a.high, ownerOf(a.left), ownerOf(a.right)});
    groupOf_.resize(nobody_ + 1);
    std::iota(groupOf_.begin(), groupOf_.end(), Owner{0});
    changed_.assign(nobody_, false);
    changed_[paint_] = true;
    for (Owner k = 0; k < paint_; ++k) changed_[k] = reached_[k] && !isAsBefore(k);
    uniteNeighbours();
  }

  CellEdit result() const {
    CellEdit edit;
    for (Owner group = 0; group < nobody_; ++group) {
      if (groupOf_[group] != group) continue;
      bool isChanged = false;
      for (Owner k = group; k < nobody_; ++k) isChanged |= groupOf_[k] == group && changed_[k];
      if (!isChanged) continue;
      const std::size_t first = edit.gone.size();
      for (Owner k = group; k < paint_; ++k)
        if (groupOf_[k] == group) edit.gone.push_back(k);
      const bool isOne = edit.gone.size() == first + 1 && groupOf_[paint_] != group;
      for (Ring& ring : simplePolygons(outlineOf(group))) {
        std::vector<std::size_t> from = isOne ? std::vector{edit.gone[first]} : partsIn(ring, group);
        edit.placed.push_back({std::move(ring), blockOf(group), std::move(from)});
      }
    }
    std::sort(edit.gone.begin(), edit.gone.end());
    return edit;
  }

 private:
  Owner ownerOf(const Sum& sum) const {
    assert(sum.polygons == 0 || (sum.polygons == 1 && sum.numbers >= 1 && std::cmp_less_equal(sum.numbers, paint_)));
    const Owner before = sum.polygons == 0 ? nobody_ : static_cast<Owner>(sum.numbers) - 1;
    if (!isInside(sum.winding, stroke_.rule)) return before;
    switch (stroke_.deed) {
      case Deed::carve:
        return nobody_;
      case Deed::fill:
        return before == nobody_ ? paint_ : before;
      case Deed::replace:
        return paint_;
    }
    return nobody_;
  }

  Block blockOf(Owner owner) const { return owner == paint_ ? stroke_.block : polygons_[owner].block; }

  std::vector<Edge> outlineOf(Owner group) const {
    std::vector<Edge> edges;
    for (const Sides& s : sides_) {
      const bool isLeft = groupOf_[s.left] == group, isRight = groupOf_[s.right] == group;
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

  bool isAsBefore(Owner polygon) const {
    if (doubleAreaOf(polygon) != detail::doubleArea(polygons_[polygon].ring)) return false;  // quicker than outlines
    const std::vector<Ring> rings = simplePolygons(outlineOf(polygon));
    return rings.size() == 1 && rings[0] == straightened(polygons_[polygon].ring);
  }

  /// Unites what shares an edge and has the same block, if one of the two is changed.
  void uniteNeighbours() {
    for (const Sides& s : sides_) {
      if (s.left == s.right || s.left == nobody_ || s.right == nobody_) continue;
      if (blockOf(s.left) != blockOf(s.right) || !(changed_[s.left] || changed_[s.right])) continue;
      const Owner a = groupOf_[s.left], b = groupOf_[s.right];
      for (Owner& group : groupOf_)
        if (group == a || group == b) group = std::min(a, b);
    }
  }

  /// The old polygons of a group with a part in one of its rings. Each part has an atom: the outline of a ring may be
  /// chords on one side, so both sides of atoms count.
  std::vector<std::size_t> partsIn(const Ring& ring, Owner group) const {
    const Pieces outline = piecesOf(ring);
    const auto isOld = [&](Owner owner) { return owner < paint_ && groupOf_[owner] == group; };
    std::vector<std::size_t> parts;
    for (const Sides& s : sides_) {
      const Point middle{s.low.x + s.high.x, s.low.y + s.high.y};
      if (isOld(s.left) && windingLeftOf(middle, outline) != 0) parts.push_back(s.left);
      if (isOld(s.right) && windingRightOf(middle, outline) != 0) parts.push_back(s.right);
    }
    std::sort(parts.begin(), parts.end());
    parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
    return parts;
  }

  const std::vector<CellPolygon>& polygons_;
  const std::vector<bool>& reached_;
  const Stroke& stroke_;
  const Owner paint_, nobody_;
  std::vector<Sides> sides_;
  std::vector<Owner> groupOf_;  ///< the least owner of its group
  std::vector<bool> changed_;
};

}  // namespace

CellEdit divided(const std::vector<CellPolygon>& polygons, const std::vector<bool>& reached,
                 const std::vector<Atom>& atoms, const Stroke& stroke) {
  return Division(polygons, reached, atoms, stroke).result();
}

}  // namespace lgs::brush
