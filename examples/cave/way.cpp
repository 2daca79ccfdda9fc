#include "way.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>
#include <tuple>
#include <utility>

namespace examples {
namespace {

using lgs::PieceId;
using lgs::Point;
using lgs::Portal;

double distance(Point a, Point b) {
  const auto x = static_cast<double>(b.x - a.x), y = static_cast<double>(b.y - a.y);
  return std::sqrt(x * x + y * y) / lgs::kUnitsPerCell;
}

Point middleOf(const Portal& p) { return {(p.left.x + p.right.x) / 2, (p.left.y + p.right.y) / 2}; }

bool isWide(const Portal& p, std::int64_t narrowest) {
  const std::int64_t x = p.left.x - p.right.x, y = p.left.y - p.right.y;
  return x * x + y * y >= narrowest * narrowest;
}

/// Which side of a→b a point is on: positive on the left.
std::int64_t turn(Point a, Point b, Point p) { return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x); }

/// How A* came to a piece.
struct Reached {
  double cost = 0;
  Point at;
  PieceId before;
  Portal through;  ///< the portal that leads here
  bool isDone = false;
};

using Pieces = std::map<PieceId, Reached>;

/// A*, from the start to the piece of the goal: Hart, Nilsson, Raphael: A formal basis for the heuristic determination
/// of minimum cost paths, 1968.
bool search(const lgs::Pieces& pieces, const Journey& journey, PieceId first, PieceId last, Pieces& reached) {
  using Open = std::tuple<double, double, PieceId>;  // estimate, cost so far; then by name, so that ties are no chance
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  reached[first] = {0, journey.from, first, {}, false};
  open.emplace(distance(journey.from, journey.to), 0, first);
  std::vector<Portal> portals;
  while (!open.empty()) {
    const PieceId id = std::get<PieceId>(open.top());
    open.pop();
    Reached& here = reached[id];
    if (std::exchange(here.isDone, true)) continue;
    if (id == last) return true;
    pieces.portals(id, portals);
    for (const Portal& portal : portals) {
      if (!contains(journey.cells, portal.to.cell) || !isWide(portal, journey.narrowest)) continue;
      const Point at = middleOf(portal);
      const double cost = here.cost + distance(here.at, at);
      const auto [there, isNew] = reached.try_emplace(portal.to);
      if (!isNew && (there->second.isDone || there->second.cost <= cost)) continue;
      there->second = {cost, at, id, portal, false};
      open.emplace(cost + distance(at, journey.to), cost, portal.to);
    }
  }
  return false;
}

/// Pulls a way straight: the funnel of all that the portals so far let see narrows until it closes on a corner. Lee and
/// Preparata: Euclidean shortest paths in the presence of rectilinear barriers, 1984; in this short form by Mononen.
std::vector<Point> pulledStraight(Point from, Point to, std::vector<Portal> portals) {
  portals.push_back({{}, to, to});
  std::vector<Point> corners{from};
  Point left = from, right = from;
  std::size_t leftAt = 0, rightAt = 0;
  for (std::size_t k = 0; k < portals.size(); ++k) {
    const Point apex = corners.back(), newLeft = portals[k].left, newRight = portals[k].right;
    std::optional<std::pair<Point, std::size_t>> corner;
    if (turn(apex, right, newRight) >= 0) {
      if (right == apex || left == apex || turn(apex, left, newRight) <= 0) {
        right = newRight;
        rightAt = k;
      } else {
        corner = {left, leftAt};
      }
    }
    if (!corner && turn(apex, left, newLeft) <= 0) {
      if (left == apex || right == apex || turn(apex, right, newLeft) >= 0) {
        left = newLeft;
        leftAt = k;
      } else {
        corner = {right, rightAt};
      }
    }
    if (!corner) continue;
    corners.push_back(corner->first);
    left = right = corner->first;
    leftAt = rightAt = k = corner->second;  // go on behind the portal with the corner
  }
  if (corners.back() != to) corners.push_back(to);
  return corners;
}

}  // namespace

std::optional<Way> findWay(const lgs::Pieces& pieces, const Journey& journey) {
  const auto first = pieces.freePieceAt(journey.from), last = pieces.freePieceAt(journey.to);
  Pieces reached;
  if (!first || !last || !contains(journey.cells, first->cell)) return std::nullopt;
  if (!search(pieces, journey, *first, *last, reached)) return std::nullopt;
  Way way;
  std::vector<Portal> portals;
  for (PieceId at = *last; at != *first; at = reached[at].before) {
    way.pieces.push_back(at);
    portals.push_back(reached[at].through);
  }
  way.pieces.push_back(*first);
  std::reverse(way.pieces.begin(), way.pieces.end());
  std::reverse(portals.begin(), portals.end());
  way.corners = pulledStraight(journey.from, journey.to, std::move(portals));
  for (std::size_t k = 1; k < way.corners.size(); ++k) way.length += distance(way.corners[k - 1], way.corners[k]);
  return way;
}

}  // namespace examples
