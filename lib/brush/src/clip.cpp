#include "clip.h"

#include "geometry/predicates.h"
#include "geometry/ring.h"
#include "geometry/sort.h"
#include "outline.h"
#include "rim.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

namespace lgs::brush {
namespace {

using detail::orientation;
using detail::operator-;

constexpr std::size_t kMostCorners = 64;

/// An edge of the region. Those that follow each other through the cell are a chain.
struct Blade {
  Piece piece;
  std::size_t chain;
};

static_assert(kMostConvexPieces < 32, "a Corner has a bit for each blade");

/// A vertex of an outline, or of another one on an edge of this one. An edge runs from it to the next corner.
struct Corner {
  Point at;
  std::size_t area, next;
  unsigned left;  ///< a bit for each blade: whether the vertex is on its left, and so perhaps in the region
  std::size_t firstCut = 0, endCut = 0;  ///< of the edge
};

/// Which corner and which cut of all is the first one of an outline.
struct Begin {
  std::size_t corner, cut;
};

/// Where the edge of an outline crosses a blade.
struct Cut {
  Point at;
  std::size_t corner;  ///< where the edge begins
  std::size_t blade;
  bool enters;              ///< the edge goes into the region; if not, out of it
  std::size_t next = 0;     ///< along the outline
  std::size_t partner = 0;  ///< of one that enters: where the chain that it meets there came into the area
  bool isWalked = false;    ///< of one that leaves
};

/// The blades of a convex part of the region, in the order of its ring, which begins each chain on the rim. None if the
/// part is another one, reaches no rim, or has a vertex on the rim or an end at a corner of the cell.
List<Blade> bladesOf(PieceSpan region) {
  List<Blade> blades;
  const auto isOfRim = [](const Piece& p) { return !p.isOfRegion; };
  const auto first = static_cast<std::size_t>(std::ranges::find_if(region, isOfRim) - region.begin());
  if (first == region.size() || !isConvexRing(region)) return blades;
  blades.reserve(region.size());
  std::size_t chain = 0;
  for (std::size_t n = 0; n < region.size(); ++n) {
    const Piece& p = region[(first + n) % region.size()];
    if (isOfRim(p)) {
      ++chain;
      continue;
    }
    const bool goesOn = !blades.empty() && blades.back().chain == chain;
    const Piece& before = goesOn ? blades.back().piece : p;
    const bool isBroken = goesOn && (before.end != before.b || p.start != p.a || liesOnRim(p.start) ||
                                     orientation(before.a, before.b, p.b) <= 0);
    if (isBroken || isCorner(p.start) || isCorner(p.end) || runsAlongRim(p.start, p.end)) return {};
    blades.push_back({p, chain});
  }
  return blades;
}

class Clip {
 public:
  Clip(const Ground& ground, PieceSpan region) : ground_(ground), region_(region), blades_(bladesOf(region)) {}

  std::optional<CellEdit> result() {
    if (blades_.empty() || !findCuts() || !bendsNothing()) return std::nullopt;
    CellEdit edit;
    List<Points> rings;
    for (std::size_t o = 0, end = 0; o < ground_.outlines.size(); o = end) {
      const std::size_t group = ground_.outlines[o].area;
      while (end < ground_.outlines.size() && ground_.outlines[end].area == group) ++end;
      if (ground_.groups[group] == kNoGroup) continue;
      List<std::size_t> old;
      for (std::size_t k = group; k < ground_.groups.size(); ++k)
        if (ground_.groups[k] == group) old.push_back(k);
      edit.gone.insert(edit.gone.end(), old.begin(), old.end());
      rings.clear();
      if (!walk(o, end, rings)) return std::nullopt;
      for (Points& ring : rings) {
        List<std::size_t> from = old.size() == 1 ? old : partsIn(ring, old, ground_);
        edit.placed.push_back({std::move(ring), ground_.polygons[group].block, std::move(from)});
      }
    }
    detail::sort(edit.gone);
    return edit;
  }

 private:
  unsigned all() const { return (1U << blades_.size()) - 1; }

  /// False if it is too much.
  bool findCuts() {
    std::size_t count = 0;
    for (const Outline& o : ground_.outlines) count += o.ring.size();
    if (count > kMostCorners) return false;
    corners_.reserve(count);
    cuts_.reserve(2 * count);
    begins_.reserve(ground_.outlines.size() + 1);
    if (ground_.outlines.size() > 1) addVertices(ground_.outlines, vertices_);
    for (const auto& [area, ring] : ground_.outlines) {
      const bool cuts = ground_.groups[area] != kNoGroup;
      const std::size_t first = corners_.size(), firstCut = cuts_.size();
      begins_.push_back({first, firstCut});
      for (const Point p : ring) addCorner(p, area, cuts);
      corners_.back().next = first;
      std::size_t k = first;
      do {
        if (cuts) addCuts(k);
        k = corners_[k].next;
      } while (k != first);
      for (std::size_t c = firstCut; c < cuts_.size(); ++c) cuts_[c].next = c + 1 == cuts_.size() ? firstCut : c + 1;
    }
    begins_.push_back({corners_.size(), cuts_.size()});
    return true;
  }

  void addCorner(Point p, std::size_t area, bool cuts) {
    Corner corner{p, area, corners_.size() + 1, 0};
    for (std::size_t b = 0; cuts && b < blades_.size(); ++b)
      corner.left |= (orientation(blades_[b].piece.a, blades_[b].piece.b, p) > 0 ? 1U : 0U) << b;
    corners_.push_back(corner);
  }

  /// Cuts an edge at the vertices of other outlines on it: between two of them it has chains of its own.
  void split(std::size_t k) {
    const std::size_t next = corners_[k].next;
    detail::cutEdge(corners_[k].at, corners_[next].at, vertices_, parts_);
    for (std::size_t n = 1; n + 1 < parts_.size(); ++n) {
      corners_[k].next = corners_.size();
      k = corners_.size();
      addCorner(parts_[n], corners_[next].area, true);
      corners_[k].next = next;
    }
  }

  /// The region is convex: an edge enters it at most once, and then leaves it.
  void addCuts(std::size_t k) {
    if (corners_[k].left != corners_[corners_[k].next].left) split(k);
    const Corner &c = corners_[k], &next = corners_[c.next];
    const unsigned sides = c.left ^ next.left;
    const std::size_t first = cuts_.size();
    for (std::size_t b = 0; sides >> b != 0; ++b) {
      if ((sides >> b & 1) == 0) continue;
      const Piece& p = blades_[b].piece;
      if (const auto pixel =
              crossingPixel({c.at, next.at, c.at, next.at, {}, true}, {p.a, p.b, p.start, p.end, {}, true}))
        cuts_.push_back({*pixel, k, b, (c.left >> b & 1) == 0});
    }
    if (cuts_.size() == first + 2 && cuts_[first + 1].enters) std::swap(cuts_[first], cuts_[first + 1]);
    corners_[k].firstCut = first;
    corners_[k].endCut = cuts_.size();
  }

  /// Whether no edge passes a pixel of another vertex or crossing. Vertices of other groups may lie on it. If one of its
  /// own group does, the outline touches itself there, and so would what is left.
  bool bendsNothing() {
    hot_.reserve(corners_.size() + kCorners.size() + region_.size() + cuts_.size());
    for (const Corner& c : corners_) hot_.push_back(c.at);
    hot_.insert(hot_.end(), kCorners.begin(), kCorners.end());
    ofRegion_ = hot_.size();
    for (const Blade& b : blades_) {
      hot_.push_back(b.piece.start);
      hot_.push_back(b.piece.end);
    }
    ofCuts_ = hot_.size();
    for (const Cut& c : cuts_) hot_.push_back(c.at);
    for (std::size_t b = 0; b < blades_.size(); ++b)
      if (isBent(b)) return false;
    for (const Corner& c : corners_)
      if (isBent(c)) return false;
    return true;
  }

  /// Whether an edge passes a hot pixel that is not its own.
  template <class IsOwn>
  bool passesOther(const Piece& p, IsOwn&& isOwn) const {
    const auto box = detail::boundingBox(std::array{p.start, p.end});
    std::size_t h = 0;
    for (const Point z : hot_) {
      if (z.x >= box.min.x && z.x <= box.max.x && z.y >= box.min.y && z.y <= box.max.y && !isOwn(h, z) &&
          passes(p.a, p.b, z))
        return true;
      ++h;
    }
    return false;
  }

  bool isBent(std::size_t blade) const {
    const Piece& p = blades_[blade].piece;
    return passesOther(p, [&](std::size_t h, Point z) {
      return h < ofCuts_ ? z == p.start || z == p.end : cuts_[h - ofCuts_].blade == blade;
    });
  }

  /// Of an edge of an outline. Cuts of the same edge of another outline are its own, too.
  bool isBent(const Corner& edge) const {
    const Corner& next = corners_[edge.next];
    const Point from = edge.at, to = next.at;
    return passesOther({from, to, from, to}, [&](std::size_t h, Point z) {
      if (h < corners_.size() && corners_[h].area == edge.area) return &corners_[h] == &edge || &corners_[h] == &next;
      if (h < ofRegion_) return orientation(from, to, z) == 0;
      if (h < ofCuts_) {
        bool isCut = false;
        for (std::size_t c = edge.firstCut; c < edge.endCut; ++c) isCut |= cuts_[c].at == z;
        return isCut && runsAlongRim(from, to);
      }
      const Corner& other = corners_[cuts_[h - ofCuts_].corner];
      return &other == &edge || (other.at == to && corners_[other.next].at == from);
    });
  }

  /// Adds what is left of a group, by least vertex. A blade runs through the group from one cut to the next one. So one
  /// goes along an outline up to where it enters the region, and back along the chain. False if the region only touches
  /// the group, or if a hole of it stays.
  bool walk(std::size_t firstOutline, std::size_t endOutline, List<Points>& rings) {
    for (std::size_t o = firstOutline; o < endOutline; ++o)
      if (begins_[o].cut == begins_[o + 1].cut && corners_[begins_[o].corner].left != all()) return false;
    const std::size_t first = begins_[firstOutline].cut, end = begins_[endOutline].cut;
    List<std::size_t> along;
    along.reserve(end - first);
    for (std::size_t c = first; c < end; ++c) along.push_back(c);
    detail::sort(along, [&](std::size_t c, std::size_t d) {
      const Cut &u = cuts_[c], &v = cuts_[d];
      if (u.blade != v.blade) return u.blade < v.blade;
      const Piece& p = blades_[u.blade].piece;
      return dot(u.at - v.at, p.b - p.a) < 0;
    });
    for (std::size_t k = 1; k < along.size(); k += 2) {
      assert(!cuts_[along[k - 1]].enters && cuts_[along[k]].enters && "a blade goes in and out by turns");
      cuts_[along[k]].partner = along[k - 1];
    }
    for (std::size_t c = first; c < end; ++c) {
      if (cuts_[c].enters || cuts_[c].isWalked) continue;
      Points ring;
      ring.reserve(begins_[endOutline].corner - begins_[firstOutline].corner + (end - first) + blades_.size());
      for (std::size_t leaves = c; !cuts_[leaves].isWalked;) {
        cuts_[leaves].isWalked = true;
        const std::size_t enters = cuts_[leaves].next;
        assert(cuts_[enters].enters);
        ring.push_back(cuts_[leaves].at);
        if (cuts_[enters].corner != cuts_[leaves].corner || enters < leaves) {
          std::size_t k = cuts_[leaves].corner;
          do {
            k = corners_[k].next;
            ring.push_back(corners_[k].at);
          } while (k != cuts_[enters].corner);
        }
        ring.push_back(cuts_[enters].at);
        leaves = cuts_[enters].partner;
        for (std::size_t b = cuts_[enters].blade; b > cuts_[leaves].blade; --b) ring.push_back(blades_[b].piece.start);
      }
      rings.push_back(straightened(ring));
    }
    detail::sort(rings, [](const Points& a, const Points& b) { return a.front() < b.front(); });
    return true;
  }

  const Ground& ground_;
  PieceSpan region_;
  List<Blade> blades_;
  List<Corner> corners_;
  Points vertices_, parts_;  ///< of all outlines if there are several, and of an edge that they part
  List<Cut> cuts_;
  List<Begin> begins_;  ///< by outline, with the end of the last one
  Points hot_;  ///< corners, then those of the cell, then ends of blades from ofRegion_ on, then cuts from ofCuts_ on
  std::size_t ofRegion_ = 0, ofCuts_ = 0;
};

}  // namespace

std::optional<CellEdit> clippedEdit(const Ground& ground, PieceSpan region, const Stroke& stroke) {
  if (stroke.deed != Deed::carve) return std::nullopt;
  for (std::size_t k = 0; k < ground.polygons.size(); ++k)
    if (ground.groups[k] != kNoGroup && stroke.stays(ground.polygons[k].block)) return std::nullopt;
  return Clip(ground, region).result();
}

}  // namespace lgs::brush
