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

/// A vertex of an outline, from which an edge runs to the next one.
struct Corner {
  Point at;
  std::size_t area, next;
  unsigned left;  ///< a bit for each blade: whether the vertex is on its left, and so perhaps in the region
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
  std::size_t partner = 0;  ///< of one that enters: where the chain that it meets there came into the outline
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
    for (std::size_t o = 0; o < ground_.outlines.size(); ++o) {
      const std::size_t group = ground_.outlines[o].area;
      if (ground_.groups[group] == kNoGroup) continue;
      List<std::size_t> old;
      for (std::size_t k = group; k < ground_.groups.size(); ++k)
        if (ground_.groups[k] == group) old.push_back(k);
      edit.gone.insert(edit.gone.end(), old.begin(), old.end());
      rings.clear();
      if (!walk(o, rings)) return std::nullopt;
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

  /// False if a group has more than one ring, or if it is too much.
  bool findCuts() {
    std::size_t count = 0;
    for (const Outline& o : ground_.outlines) count += o.ring.size();
    if (count > kMostCorners) return false;
    corners_.reserve(count);
    cuts_.reserve(2 * count);
    begins_.reserve(ground_.outlines.size() + 1);
    for (std::size_t o = 0; o < ground_.outlines.size(); ++o) {
      const auto& [area, ring] = ground_.outlines[o];
      const bool cuts = ground_.groups[area] != kNoGroup;
      if (cuts && o + 1 < ground_.outlines.size() && ground_.outlines[o + 1].area == area) return false;
      const std::size_t first = corners_.size();
      begins_.push_back({first, cuts_.size()});
      for (const Point p : ring) addCorner(p, area, cuts);
      corners_.back().next = first;
      for (std::size_t k = first; cuts && k < corners_.size(); ++k) addCuts(k);
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

  /// The region is convex: an edge enters it at most once, and then leaves it.
  void addCuts(std::size_t k) {
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
  }

  /// Whether no edge passes a pixel of another vertex or crossing. It may have vertices of other groups on it if nothing
  /// crosses it. If a vertex of its own group lies on it, the outline touches itself there, and so would what is left.
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
    std::size_t cut = 0;
    for (std::size_t k = 0; k < corners_.size(); ++k) {
      const std::size_t first = cut;
      while (cut < cuts_.size() && cuts_[cut].corner == k) ++cut;
      if (isBent(k, first, cut)) return false;
    }
    return true;
  }

  /// Whether an edge passes a hot pixel that is not its own.
  template <class IsOwn>
  bool passesOther(const Piece& p, IsOwn&& isOwn) const {
    const auto box = detail::boundingBox(std::array{p.start, p.end});
    for (std::size_t h = 0; h < hot_.size(); ++h) {
      const Point z = hot_[h];
      if (z.x >= box.min.x && z.x <= box.max.x && z.y >= box.min.y && z.y <= box.max.y && !isOwn(h, z) &&
          passes(p.a, p.b, z))
        return true;
    }
    return false;
  }

  bool isBent(std::size_t blade) const {
    const Piece& p = blades_[blade].piece;
    return passesOther(p, [&](std::size_t h, Point z) {
      return h < ofCuts_ ? z == p.start || z == p.end : cuts_[h - ofCuts_].blade == blade;
    });
  }

  /// Of an edge of an outline, with its cuts. Those of the same edge of another outline are its own, too.
  bool isBent(std::size_t k, std::size_t firstCut, std::size_t endCut) const {
    const Corner& edge = corners_[k];
    const Point from = edge.at, to = corners_[edge.next].at;
    return passesOther({from, to, from, to}, [&](std::size_t h, Point z) {
      if (h < corners_.size() && corners_[h].area == edge.area) return h == k || h == edge.next;
      if (h < ofRegion_) return z == from || z == to || (firstCut == endCut && orientation(from, to, z) == 0);
      if (h < ofCuts_) {
        bool isCut = false;
        for (std::size_t c = firstCut; c < endCut; ++c) isCut |= cuts_[c].at == z;
        return isCut && runsAlongRim(from, to);
      }
      const Corner& other = corners_[cuts_[h - ofCuts_].corner];
      return &other == &edge || (other.at == to && corners_[other.next].at == from);
    });
  }

  /// Adds what is left of a group's outline, by least vertex. A blade runs through the outline from one cut to the next
  /// one. So one goes along the outline up to where it enters the region, and back along the chain. False if it is not
  /// cut, but touched.
  bool walk(std::size_t o, List<Points>& rings) {
    const std::size_t first = begins_[o].cut, end = begins_[o + 1].cut;
    if (first == end) return corners_[begins_[o].corner].left == all();  // nothing is left
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
    const std::size_t firstCorner = begins_[o].corner, endCorner = begins_[o + 1].corner;
    for (std::size_t c = first; c < end; ++c) {
      if (cuts_[c].enters || cuts_[c].isWalked) continue;
      Points ring;
      ring.reserve(endCorner - firstCorner + (end - first) + blades_.size());
      for (std::size_t leaves = c; !cuts_[leaves].isWalked;) {
        cuts_[leaves].isWalked = true;
        const std::size_t enters = leaves + 1 == end ? first : leaves + 1;
        assert(cuts_[enters].enters);
        ring.push_back(cuts_[leaves].at);
        if (cuts_[enters].corner != cuts_[leaves].corner || enters < leaves) {
          std::size_t k = cuts_[leaves].corner;
          do {
            k = k + 1 == endCorner ? firstCorner : k + 1;
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
