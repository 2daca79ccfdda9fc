#include "pieces.h"

#include "fraction.h"
#include "geometry/predicates.h"
#include "geometry/sort.h"
#include "pairs.h"
#include "snap.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <tuple>

namespace lgs::brush {
namespace {

using detail::nextVertex;
using detail::Vector;
using detail::operator-;  // NOLINT(misc-unused-using-decls): p.b - p.a uses it

/// How far a point is beyond a line.
std::int64_t beyond(Point p, Line line) { return (line.isVertical ? p.x : p.y) - line.at; }

/// Where the edge a→b crosses the line, rounded along the line.
Point crossing(Point a, Point b, Line line) {
  const auto along = [](std::int64_t u, std::int64_t du, std::int64_t v, std::int64_t dv, std::int64_t at) {
    return v + roundedProduct(dv, at - u, du);
  };
  if (line.isVertical) return {line.at, along(a.x, b.x - a.x, a.y, b.y - a.y, line.at)};
  return {along(a.y, b.y - a.y, a.x, b.x - a.x, line.at), line.at};
}

/// Adds a piece; and one along the line before it, where the ring has left the line's side since.
inline void append(Pieces& ring, const Piece& piece) {
  if (!ring.empty() && ring.back().end != piece.start) {
    const Point from = ring.back().end;
    ring.push_back({from, piece.start, from, piece.start, false});
  }
  if (piece.start != piece.end) ring.push_back(piece);
}

/// The same with what is on one side of the line of a piece that has an end on the other side. It crosses the line `at`
/// a point; `start` and `end` say where its ends are: above 0 on that side, 0 on the line.
void appendPart(Pieces& kept, const Piece& p, std::int64_t start, std::int64_t end, Point at) {
  // An end on the line can be a rounded one: the edge itself can go on beside the line.
  const auto isAfter = [&](Point u, Point v) { return dot(u - v, p.b - p.a) > 0; };
  if (start >= 0 && isAfter(at, p.start)) append(kept, {p.a, p.b, p.start, at, p.isOfRegion});
  if (end >= 0 && isAfter(p.end, at)) append(kept, {p.a, p.b, at, p.end, p.isOfRegion});
}

void close(Pieces& ring) {
  if (ring.empty() || ring.back().end == ring.front().start) return;
  const Point from = ring.back().end, to = ring.front().start;
  ring.push_back({from, to, from, to, false});
}

/// The line that a piece lies on, the same for all edges on it, in lowest terms.
struct Carrier {
  std::int64_t dx, dy, offset;
  explicit Carrier(const Piece& p) {
    const Vector d = p.b - p.a;
    const std::int64_t divisor = std::gcd(d.x, d.y) * (d.x < 0 || (d.x == 0 && d.y < 0) ? -1 : 1);
    dx = d.x / divisor;
    dy = d.y / divisor;
    offset = p.a.x * dy - p.a.y * dx;
  }
  friend auto operator<=>(const Carrier&, const Carrier&) = default;
};

/// On which side of a piece's edge a point is, whose coordinates are doubled: +1 left, -1 right.
int turnTo(Point doubled, const Piece& p) {
  const auto twice = [](Point v) { return Point{2 * v.x, 2 * v.y}; };
  return detail::orientation(twice(p.a), twice(p.b), doubled);
}

/// Whether two pieces have more in common than a point.
bool overlap(const Piece& p, const Piece& q) {
  return detail::orientation(p.a, p.b, q.a) == 0 && detail::orientation(p.a, p.b, q.b) == 0 &&
         std::max(std::min(p.start, p.end), std::min(q.start, q.end)) <
             std::min(std::max(p.start, p.end), std::max(q.start, q.end));
}

/// Nearly always there are few, and none are parallel.
bool anyOverlap(PieceSpan pieces) {
  constexpr std::size_t kFew = 16;
  if (pieces.size() <= kFew) {
    for (std::size_t k = 1; k < pieces.size(); ++k)
      for (std::size_t l = 0; l < k; ++l)
        if (cross(pieces[k].b - pieces[k].a, pieces[l].b - pieces[l].a) == 0 && overlap(pieces[k], pieces[l]))
          return true;
    return false;
  }
  return anyPair(
      pieces,
      [](const Piece& p) {
        return std::array{p.start, p.end};
      },
      overlap);
}

/// The pieces, cut at the ends of others that lie on them: what overlaps is then equal. Such a cut is a point of the
/// edge, so that the parts are edges by themselves. Where a spike was, nothing of the edge is left.
Pieces cutAtEnds(PieceSpan pieces) {
  Pieces parts;
  Points cuts;
  for (const Piece& p : pieces) {
    const Vector d = p.end - p.start;
    const auto before = [&](Point u, Point v) { return dot(u - p.start, d) < dot(v - p.start, d); };
    cuts.assign({p.start, p.end});
    for (const Piece& q : pieces)
      if (detail::orientation(p.a, p.b, q.start) == 0 && before(p.start, q.start) && before(q.start, p.end))
        cuts.push_back(q.start);
    detail::sort(cuts, before);
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    for (std::size_t k = 1; k < cuts.size(); ++k) {
      const Point a = k == 1 ? p.a : cuts[k - 1], b = k + 1 == cuts.size() ? p.b : cuts[k];
      parts.push_back({a, b, cuts[k - 1], cuts[k], p.isOfRegion});
    }
  }
  return parts;
}

/// A piece, and how often it is there.
struct Repeated {
  Piece piece;
  std::int64_t times = 0;
};

/// Pieces of lines between cells, sorted along each line, are joined where no edge of the region ends: a spike ended
/// there, and without it the cell would have no vertex there.
void joinAlongLines(List<Repeated>& pieces) {
  Points ends;
  for (const Repeated& r : pieces)
    if (r.piece.isOfRegion) ends.insert(ends.end(), {r.piece.start, r.piece.end});
  normalize(ends);
  const auto follows = [&](const Piece& p, const Piece& q) {
    return p.end == q.start && detail::orientation(p.start, p.end, q.end) == 0 &&
           !std::binary_search(ends.begin(), ends.end(), p.end);
  };
  std::size_t count = 0;
  for (const Repeated& r : pieces) {
    Repeated* const last = count == 0 ? nullptr : &pieces[count - 1];
    const bool isAlike = last != nullptr && last->times == r.times && !last->piece.isOfRegion && !r.piece.isOfRegion;
    if (isAlike && follows(last->piece, r.piece)) {
      last->piece.b = last->piece.end = r.piece.end;
    } else if (isAlike && follows(r.piece, last->piece)) {
      last->piece.a = last->piece.start = r.piece.start;
    } else {
      pieces[count++] = r;
    }
  }
  pieces.resize(count);
}

/// Edges that are cut at the rim may cross within a unit of it, though their ends are rounded to where they do not.
bool doCross(PieceSpan pieces) {
  const auto doMeet = [](const Piece& p, const Piece& q) { return p.end == p.b && q.start == q.a && p.b == q.a; };
  const auto segment = [](const Piece& p) { return Segment{p.a, p.b, p.start, p.end, {}, true}; };
  for (std::size_t k = 1; k < pieces.size(); ++k) {
    if (!pieces[k].isOfRegion) continue;
    for (std::size_t m = 0; m < k - (doMeet(pieces[k - 1], pieces[k]) ? 1 : 0); ++m)
      if (pieces[m].isOfRegion && crossingPixel(segment(pieces[m]), segment(pieces[k]))) return true;
  }
  return false;
}

}  // namespace

Pieces piecesOf(std::span<const Point> ring) {
  Pieces pieces;
  pieces.reserve(ring.size());
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point a = ring[k], b = ring[k + 1 == ring.size() ? 0 : k + 1];
    if (a != b) pieces.push_back({a, b, a, b, true});
  }
  return pieces;
}

bool isConvexRing(PieceSpan pieces) {
  if (pieces.size() < 3 || pieces.size() > kMostConvexPieces) return false;
  const auto isUp = [](Vector v) { return v.y > 0 || (v.y == 0 && v.x > 0); };
  int upwards = 0;  // how often it begins to: once if it runs around once
  Vector in = pieces.back().end - pieces.back().start;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    if (pieces[k].end != nextVertex(pieces, k).start) return false;
    const Vector out = pieces[k].end - pieces[k].start;
    const std::int64_t turn = cross(in, out);
    if (turn < 0 || (turn == 0 && dot(in, out) < 0)) return false;
    upwards += !isUp(in) && isUp(out) ? 1 : 0;
    in = out;
  }
  return upwards == 1 && !doCross(pieces);
}

Halves halves(PieceSpan ring, Line line) {
  Halves kept;
  kept.less.reserve(ring.size() + 2);
  kept.greater.reserve(ring.size() + 2);
  for (const Piece& p : ring) {
    const std::int64_t start = beyond(p.start, line), end = beyond(p.end, line);
    if (start <= 0 && end <= 0) append(kept.less, p);
    if (start >= 0 && end >= 0) append(kept.greater, p);
    const bool cutsLess = (start > 0) != (end > 0), cutsGreater = (start < 0) != (end < 0);
    if (!cutsLess && !cutsGreater) continue;
    const Point at = crossing(p.a, p.b, line);
    if (cutsLess) appendPart(kept.less, p, -start, -end, at);
    if (cutsGreater) appendPart(kept.greater, p, start, end, at);
  }
  close(kept.less);
  close(kept.greater);
  return kept;
}

std::optional<Pieces> withoutSpikes(PieceSpan pieces, FillRule rule) {
  if (!anyOverlap(pieces)) return std::nullopt;
  struct Keyed {
    Carrier carrier;
    Point low, high;
    std::int64_t turns;  // +1 from low to high
    Piece piece;
    std::size_t place;  // of equal ones the first comes first
    auto key() const { return std::tie(carrier, low, high); }
  };
  List<Keyed> all;
  for (const Piece& p : cutAtEnds(pieces))
    all.push_back(
        {Carrier(p), std::min(p.start, p.end), std::max(p.start, p.end), p.start < p.end ? 1 : -1, p, all.size()});
  detail::sort(
      all, [](const Keyed& a, const Keyed& b) { return a.key() != b.key() ? a.key() < b.key() : a.place < b.place; });
  List<Repeated> left;
  for (std::size_t k = 0; k < all.size();) {
    const std::size_t first = k;
    std::int64_t turns = 0;
    std::size_t shown = first;  // one of the region, if there is any
    for (; k < all.size() && all[k].key() == all[first].key(); ++k) {
      turns += all[k].turns;
      if (all[k].piece.isOfRegion) shown = k;
    }
    if (rule == FillRule::evenOdd) turns %= 2;
    Piece piece = all[shown].piece;
    if (turns * all[shown].turns < 0) {
      std::swap(piece.a, piece.b);
      std::swap(piece.start, piece.end);
    }
    if (turns != 0) left.push_back({piece, std::abs(turns)});
  }
  joinAlongLines(left);
  Pieces kept;
  for (const Repeated& r : left) kept.insert(kept.end(), static_cast<std::size_t>(r.times), r.piece);
  return kept;
}

std::int64_t windingLeftOf(Point doubled, PieceSpan pieces) {
  std::int64_t winding = 0;
  for (const Piece& p : pieces) {
    const bool startsBelow = 2 * p.start.y <= doubled.y, endsBelow = 2 * p.end.y <= doubled.y;
    if (startsBelow == endsBelow) continue;
    const int turn = turnTo(doubled, p);
    if (startsBelow ? turn < 0 : turn > 0) winding += startsBelow ? -1 : 1;  // the piece is left of the point
  }
  return winding;
}

std::int64_t windingRightOf(Point doubled, PieceSpan pieces) {
  std::int64_t winding = 0;
  for (const Piece& p : pieces) {
    const bool startsBelow = 2 * p.start.y < doubled.y, endsBelow = 2 * p.end.y < doubled.y;
    if (startsBelow == endsBelow) continue;
    const int turn = turnTo(doubled, p);
    if (startsBelow ? turn <= 0 : turn >= 0) winding += startsBelow ? -1 : 1;  // left of the point, or through it
  }
  return winding;
}

}  // namespace lgs::brush
