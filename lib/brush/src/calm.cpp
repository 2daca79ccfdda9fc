#include "calm.h"

#include "geometry/predicates.h"
#include "rim.h"

#include <algorithm>
#include <utility>

namespace lgs::brush {
namespace {

/// Whether an edge crosses a part of a chain.
bool crossesChain(Point from, Point to, const Segment& part) {
  return detail::boxesMeet(from, to, part.start, part.end) && detail::crossProperly(from, to, part.start, part.end);
}

/// Whether a side crosses a part of the region's edge, or the chain of that. In the pixel where both end it may.
bool crosses(const Side& side, const Segment& part) {
  if (crossesChain(side.low, side.high, part)) return true;
  const auto pixel = crossingPixel({side.low, side.high, side.low, side.high, {}, true}, part);
  if (!pixel) return false;
  return (*pixel != part.start && *pixel != part.end) || (*pixel != side.low && *pixel != side.high);
}

/// Whether a side is the piece of a chain that this part of the region's edge becomes. Both are cut at all known points.
bool isChainOf(const Side& side, const Segment& part) {
  return (part.start == side.low && part.end == side.high) || (part.start == side.high && part.end == side.low);
}

/// The region through the known points of a cell, together with the outlines of groups as they are.
class RoundedRegion {
 public:
  RoundedRegion(const Ground& ground, PieceSpan region, const Stroke& stroke)
      : ground_(ground), region_(region), stroke_(stroke) {
    Points chain;
    atoms_.reserve(ground.known.size() + ground.sides.size());
    parts_.reserve(ground.known.size());
    for (const Piece& p : region) {
      route({p.a, p.b, p.start, p.end, {}, true}, ground.known, chain);
      addAtoms(chain, {1, 0}, atoms_);
      for (std::size_t k = 1; k < chain.size(); ++k) parts_.push_back({p.a, p.b, chain[k - 1], chain[k], {}, true});
    }
    const List<Segment> outlines = groupSegments(ground);
    hasCrossing_ = std::ranges::any_of(outlines, [&](const Segment& s) {
      return std::ranges::any_of(parts_, [&](const Segment& p) { return crossesChain(s.start, s.end, p); });
    });
    if (hasCrossing_) return;
    for (const Segment& s : outlines) addAtoms({s.start, s.end}, s.sum, atoms_);
    merge(atoms_);
    findSides(atoms_);
  }

  /// Whether a chain crosses the outline of a group.
  bool hasCrossing() const { return hasCrossing_; }

  /// Whether a side is no obstacle. The rim is none: where the region crosses it is known. An edge of a polygon that must
  /// stay has to be outside.
  bool isFree(const Side& side) const {
    const Point middle = doubledMiddle(side);
    const auto at = std::lower_bound(atoms_.begin(), atoms_.end(), side, [](const Atom& atom, const Side& s) {
      return atom.low != s.low ? atom.low < s.low : atom.high < s.high;
    });
    const bool isAtom = at != atoms_.end() && at->low == side.low && at->high == side.high;
    const Sum left = isAtom ? at->left : sumLeftOf(middle, atoms_), right = isAtom ? at->right : left;
    const bool isFilledLeft = isFilled(left.winding), isFilledRight = isFilled(right.winding);
    const bool isInside = side.isLeft ? isFilledLeft : isFilledRight, isOutline = isFilledLeft != isFilledRight;
    if (isInside && ground_.groups[side.area] == kNoGroup) return false;
    return runsAlongRim(side.low, side.high) ||
           (isOutline ? isFreeOutline(side, isInside, (isFilledLeft ? right : left).group)
                      : isFreeLine(side, isInside));
  }

  List<Atom> atoms() && { return std::move(atoms_); }

 private:
  bool isFilled(std::int64_t winding) const { return brush::isFilled(winding, stroke_.rule); }

  static Point doubledMiddle(const Side& side) { return {side.low.x + side.high.x, side.low.y + side.high.y}; }

  /// An edge of the rounded region is free, unless another edge of the exact one crosses it, and what is outside would
  /// have to change there: then what is between that edge and its chain is on the wrong side of this one. If what is
  /// outside stays, and not what is inside, that would be a slit between them.
  bool isFreeOutline(const Side& side, bool isInside, std::int64_t groupOutside) const {
    const Block block = ground_.polygons[side.area].block;
    const bool isSlit = isInside && groupOutside > 0 && stroke_.changes(block) &&
                        stroke_.stays(ground_.polygons[static_cast<std::size_t>(groupOutside) - 1].block);
    const bool changes = isSlit || (isInside ? groupOutside == 0 && stroke_.fillsFreePlaces()
                                             : ground_.groups[side.area] != kNoGroup && stroke_.changes(block));
    return !changes || std::none_of(parts_.begin(), parts_.end(),
                                    [&](const Segment& part) { return !isChainOf(side, part) && crosses(side, part); });
  }

  /// Any other edge may not be where the exact region is and the rounded one is not. If nothing crosses it, one place
  /// tells of all of it.
  bool isFreeLine(const Side& side, bool isInside) const {
    if (std::any_of(parts_.begin(), parts_.end(), [&](const Segment& part) { return crosses(side, part); }))
      return false;
    const Point middle = doubledMiddle(side);
    return isInside || (!isFilled(windingLeftOf(middle, region_)) && !isFilled(windingRightOf(middle, region_)));
  }

  const Ground& ground_;
  PieceSpan region_;
  const Stroke& stroke_;
  List<Segment> parts_;
  List<Atom> atoms_;
  bool hasCrossing_ = false;
};

}  // namespace

std::optional<List<Atom>> calmAtoms(const Ground& ground, PieceSpan region, const Stroke& stroke) {
  RoundedRegion rounded(ground, region, stroke);
  if (rounded.hasCrossing() ||
      !std::all_of(ground.sides.begin(), ground.sides.end(), [&](const Side& s) { return rounded.isFree(s); }))
    return std::nullopt;
  return std::move(rounded).atoms();
}

}  // namespace lgs::brush
