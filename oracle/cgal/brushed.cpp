#include "oracle/cgal/brushed.h"

#include "oracle/cgal/plane.h"
#include "oracle/reference/words.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <tuple>

namespace lgs::oracle {
namespace {

using namespace plane;
struct Edge {
  Kernel::Segment_2 segment;
  CGAL::Bbox_2 box = segment.bbox();
};
using Edges = std::vector<Edge>;

// Borders that go straight on are one edge.
Edges joined(const std::vector<Border>& borders) {
  std::map<ExactPoint, std::vector<const Border*>> from;
  for (const Border& border : borders) from[border.from].push_back(&border);
  std::vector<const Border*> next(borders.size());
  std::vector<bool> isFirst(borders.size(), true);
  for (std::size_t k = 0; k < borders.size(); ++k) {
    for (const Border* const other : from[borders[k].to]) {
      if (!CGAL::collinear(borders[k].from, borders[k].to, other->to)) continue;
      next[k] = other;
      isFirst[static_cast<std::size_t>(other - borders.data())] = false;
    }
  }
  Edges edges;
  for (std::size_t k = 0; k < borders.size(); ++k) {
    if (!isFirst[k]) continue;
    const Border* last = &borders[k];
    while (const Border* const more = next[static_cast<std::size_t>(last - borders.data())]) last = more;
    edges.push_back({Kernel::Segment_2(borders[k].from, last->to)});
  }
  return edges;
}

bool isOnGrid(const Edge& edge) {
  const auto isLine = [](double min, double max) {
    return min == max && std::fmod(min, static_cast<double>(kUnitsPerCell)) == 0;
  };
  return isLine(edge.box.xmin(), edge.box.xmax()) || isLine(edge.box.ymin(), edge.box.ymax());
}

using Convex = std::vector<ExactPoint>;

// A quick look: what is farther than that from a box can be left out.
Edges edgesAround(const CGAL::Bbox_2& box, const Edges& edges, double units) {
  const CGAL::Bbox_2 around(box.xmin() - units, box.ymin() - units, box.xmax() + units, box.ymax() + units);
  Edges close;
  std::ranges::copy_if(edges, std::back_inserter(close),
                       [&](const Edge& edge) { return CGAL::do_overlap(edge.box, around); });
  return close;
}

// The distance from an edge is a convex function: if it is small in all corners of a convex polygon, it is in all of it.
// Otherwise another edge may be near to a part of it, so it is halved across its longest side, some times.
bool isNear(const Convex& piece, const Edges& edges, const Kernel::FT& squared, int halvings) {
  for (const Edge& edge : edges) {
    const auto isNearEdge = [&](const ExactPoint& p) { return CGAL::squared_distance(p, edge.segment) <= squared; };
    if (std::all_of(piece.begin(), piece.end(), isNearEdge)) return true;
  }
  if (halvings == 0) return false;
  if (piece.size() == 2) {
    const ExactPoint middle = CGAL::midpoint(piece[0], piece[1]);
    return isNear({piece[0], middle}, edges, squared, halvings - 1) &&
           isNear({middle, piece[1]}, edges, squared, halvings - 1);
  }
  std::size_t longest = 0;
  const auto after = [&](std::size_t k) { return (k + 1) % piece.size(); };
  const auto length = [&](std::size_t k) { return CGAL::to_double(CGAL::squared_distance(piece[k], piece[after(k)])); };
  for (std::size_t k = 1; k < piece.size(); ++k)
    if (length(k) > length(longest)) longest = k;
  // From the middle of the longest side to the corner halfway around: two convex halves.
  const ExactPoint middle = CGAL::midpoint(piece[longest], piece[after(longest)]);
  const std::size_t steps = (piece.size() + 1) / 2;
  Convex first{middle}, second{middle};
  for (std::size_t k = 0, at = after(longest); k < piece.size(); ++k, at = after(at)) {
    if (k < steps) first.push_back(piece[at]);
    if (k + 1 >= steps) second.push_back(piece[at]);
  }
  return isNear(first, edges, squared, halvings - 1) && isNear(second, edges, squared, halvings - 1);
}

bool isNear(const Convex& piece, const Edges& edges, std::int64_t units) {
  constexpr int kHalvings = 48;  // two of them halve a long, thin piece: the last ones are smaller than a unit
  const auto most = static_cast<double>(units);
  const Edges close = edgesAround(CGAL::bbox_2(piece.begin(), piece.end()), edges, most);
  return isNear(piece, close, Kernel::FT(most) * most, kHalvings);
}

Point nearest(const ExactPoint& p) {
  return {std::llround(CGAL::to_double(p.x())), std::llround(CGAL::to_double(p.y()))};
}

// Where each block is solid, by its number; and at the end, where any is.
using Solid = std::vector<bool>;

class Strokes {
 public:
  Strokes(const Outline& before, std::span<const BrushEdit> strokes, const Outline& after) : strokes_(strokes) {
    for (const Outline* const outline : {&before, &after})
      for (const OutlineSegment& s : *outline) blocks_.push_back(s.block);
    for (const BrushEdit& stroke : strokes)
      if (stroke.deed != BrushEdit::Deed::carve) blocks_.push_back(stroke.block);
    std::ranges::sort(blocks_);
    blocks_.erase(std::unique(blocks_.begin(), blocks_.end()), blocks_.end());
    Curves curves;
    for (const OutlineSegment& s : before) curves.add(numberOf(s.block), s.start, s.end);
    for (const OutlineSegment& s : after) curves.add(blocks_.size() + numberOf(s.block), s.start, s.end);
    for (std::size_t k = 0; k < strokes.size(); ++k)
      for (const auto& ring : strokes[k].rings) curves.addRing(2 * blocks_.size() + k, ring);
    faces_ = facesOf(curves, 2 * blocks_.size() + strokes.size());
    for (const std::vector<int>& windings : faces_.windings) {
      stages_.push_back(stagesIn(windings));
      exact_.push_back(stages_.back().back());
      const auto first = windings.begin() + static_cast<std::ptrdiff_t>(blocks_.size());
      real_.emplace_back(first, first + static_cast<std::ptrdiff_t>(blocks_.size()));
      real_.back().push_back(std::ranges::any_of(real_.back(), [](int n) { return n > 0; }) ? 1 : 0);
    }
  }

  // `byCells`: no edge of the solid on a line between cells is moved, as a brush of this library cuts along these.
  std::optional<FarOff> farOff(std::int64_t units, bool byCells = false) const {
    const Edges ofBlocks = edgesWhere(ofAnyBlock);
    Edges ofSolid = edgesWhere([](const Solid& left, const Solid& right) { return left.back() != right.back(); });
    if (byCells) std::erase_if(ofSolid, isOnGrid);
    const auto isWrong = [&](const Triangle& t, std::size_t k) {
      const bool isSame = real_[t.face][k] == (exact_[t.face][k] ? 1 : 0);
      return !isSame && !isNear({t.corners.begin(), t.corners.end()}, k < blocks_.size() ? ofBlocks : ofSolid, units);
    };
    for (std::size_t k = 0; k <= blocks_.size(); ++k)
      for (const Triangle& t : faces_.triangles)
        if (isWrong(t, k)) return FarOff{inWords(t, k, units), outline()};
    return std::nullopt;
  }

  // Whether the strokes change nothing.
  bool isAsBefore() const {
    for (std::size_t face = 0; face < exact_.size(); ++face)
      for (std::size_t k = 0; k < blocks_.size(); ++k)
        if (exact_[face][k] != (faces_.windings[face][k] > 0)) return false;
    return true;
  }

  // Segments that bound nothing: those that run to and fro. What bounds a region that is near is near.
  std::optional<FarOff> stray(const Outline& after, std::int64_t units) const {
    const Edges edges = edgesWhere(ofAnyBlock);
    const auto found = [&](const ExactPoint& from, const ExactPoint& to) -> std::optional<FarOff> {
      if (isNear({from, to}, edges, units)) return std::nullopt;
      const std::string segment = "segment " + oracle::inWords(nearest(from), nearest(to));
      return FarOff{"no boundary: " + segment + " has the same on both sides" + within(units), outline()};
    };
    std::map<std::tuple<Block, Point, Point>, int> runs;
    for (const OutlineSegment& s : after)
      runs[{s.block, std::min(s.start, s.end), std::max(s.start, s.end)}] += s.start < s.end ? 1 : -1;
    for (const auto& [piece, times] : runs)
      if (auto far = times == 0 ? found(exact(std::get<1>(piece)), exact(std::get<2>(piece))) : std::nullopt)
        return far;
    for (const Border& border : faces_.borders)
      for (const std::size_t curve : border.curves) {
        const std::size_t block = curve - blocks_.size();  // of an outline before it is no block
        if (block >= blocks_.size() || real_[border.left][block] != real_[border.right][block]) continue;
        if (auto far = found(border.from, border.to)) return far;
      }
    return std::nullopt;
  }

 private:
  std::size_t numberOf(Block block) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(blocks_, block) - blocks_.begin());
  }

  // Before the strokes, and after each of them.
  std::vector<Solid> stagesIn(const std::vector<int>& windings) const {
    Solid solid;
    for (std::size_t k = 0; k < blocks_.size(); ++k) solid.push_back(windings[k] > 0);
    solid.push_back(std::ranges::find(solid, true) != solid.end());
    std::vector<Solid> stages{solid};
    for (std::size_t k = 0; k < strokes_.size(); ++k) {
      const BrushEdit& stroke = strokes_[k];
      const int winding = windings[2 * blocks_.size() + k];
      const auto stays = [&](Block block) {
        const std::size_t number = numberOf(block);
        return number < blocks_.size() && blocks_[number] == block && solid[number];
      };
      const bool isInside = stroke.isEvenOdd ? winding % 2 != 0 : winding != 0;
      const bool isKept = stroke.deed == BrushEdit::Deed::fill && solid.back();
      if (isInside && !isKept && std::ranges::none_of(stroke.staying, stays)) {
        solid.assign(solid.size(), false);
        if (stroke.deed != BrushEdit::Deed::carve) solid[numberOf(stroke.block)] = solid.back() = true;
      }
      stages.push_back(solid);
    }
    return stages;
  }

  std::string inWords(const Triangle& t, std::size_t k, std::int64_t units) const {
    std::string text = real_[t.face][k] > (exact_[t.face][k] ? 1 : 0) ? "extra solid" : "missing solid";
    if (k < blocks_.size() && blocks_.size() > 1) text += fmt::format(" of block {}", blocks_[k]);
    text += " in the triangle";
    for (const ExactPoint& p : t.corners) text += " " + oracle::inWords(nearest(p));
    if (k < blocks_.size() && real_[t.face][k] < 0)
      text += ", which the outline runs around with the solid on its right";
    return text + within(units);
  }

  static std::string within(std::int64_t units) {
    if (units == 0) return "";
    return fmt::format(", not all of it within {} of the exact edges", counted(static_cast<std::uint64_t>(units), "unit"));
  }

  static bool ofAnyBlock(const Solid& left, const Solid& right) { return left != right; }

  // Of what each stroke leaves: where an edge was rounded, and the next stroke covers it, the outline may have moved far
  // along an edge that is nearly parallel.
  Edges edgesWhere(bool (*differ)(const Solid&, const Solid&)) const {
    std::vector<Border> edges = faces_.borders;
    std::erase_if(edges, [&](const Border& border) {
      for (std::size_t k = 1; k <= strokes_.size(); ++k)
        if (differ(stages_[border.left][k], stages_[border.right][k])) return false;
      return strokes_.size() != 0 || !differ(exact_[border.left], exact_[border.right]);
    });
    return joined(edges);
  }

  Outline outline() const {
    Outline all;
    for (const Border& border : faces_.borders) {
      const Point from = nearest(border.from), to = nearest(border.to);
      for (std::size_t k = 0; k < blocks_.size() && from != to; ++k) {
        if (exact_[border.left][k] == exact_[border.right][k]) continue;
        const bool isLeft = exact_[border.left][k];
        all.push_back({isLeft ? from : to, isLeft ? to : from, blocks_[k], {}, {}});
      }
    }
    std::ranges::sort(all);
    return all;
  }

  std::span<const BrushEdit> strokes_;
  std::vector<Block> blocks_;  // sorted
  Faces faces_;
  std::vector<std::vector<Solid>> stages_;  // of each face
  std::vector<Solid> exact_;                // the last ones
  std::vector<std::vector<int>>
      real_;  // how often the outline runs around it, by block; at the end, whether it is solid
};

// Of all blocks, or of one.
Outline sidesOf(const Scene& scene, std::optional<Block> only = {}) {
  Outline sides;
  for (const auto& [cell, block, vertices] : scene.polygons)
    for (std::size_t k = 0; k < vertices.size() && only.value_or(block) == block; ++k)
      sides.push_back({toWorld(cell, vertices[k]), toWorld(cell, vertices[(k + 1) % vertices.size()]), block, {}, {}});
  return sides;
}

}  // namespace

std::optional<FarOff> farFromExact(const Outline& before, std::span<const BrushEdit> strokes, const Outline& after,
                                   std::int64_t units) {
  const Strokes all(before, strokes, after);
  auto found = all.farOff(units);
  return found ? found : all.stray(after, units);
}

std::optional<std::string> farFromExact(const Scene& before, const BrushEdit& edit, const Scene& after) {
  auto far = Strokes(sidesOf(before), {&edit, 1}, sidesOf(after)).farOff(1, true);
  return far ? std::optional(std::move(far->text)) : std::nullopt;
}

std::optional<std::string> seamIn(const Scene& before, const BrushEdit& filled, const Scene& after) {
  const Strokes all(sidesOf(before, filled.block), {&filled, 1}, sidesOf(after, filled.block));
  if (!all.isAsBefore()) return std::nullopt;
  const auto far = all.farOff(2, true);
  return far ? std::optional("a carved region that is filled again: " + far->text) : std::nullopt;
}

}  // namespace lgs::oracle
