// Ways through free pieces (examples/cave): there is one where portals lead from piece to piece, and it stays in what
// is free.
#include "examples/cave/way.h"
#include "proptests/support/law.h"
#include "proptests/support/played.h"
#include "proptests/support/traces.h"
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace lgs::test {
namespace {

int sideOf(Point a, Point b, Point p) {
  const std::int64_t turn = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
  return (turn > 0) - (turn < 0);
}

/// Whether a segment meets the interior of a convex polygon. If not, an edge or the segment's own line parts them.
bool meets(Point a, Point b, const std::vector<Point>& polygon) {
  int least = 1, most = -1;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point p = polygon[k], q = polygon[(k + 1) % polygon.size()];
    if (sideOf(p, q, a) <= 0 && sideOf(p, q, b) <= 0) return false;
    least = std::min(least, sideOf(a, b, p));
    most = std::max(most, sideOf(a, b, p));
  }
  return least < 0 && most > 0;
}

/// All pieces to which portals lead.
std::set<PieceId> reachedFrom(const lgs::Pieces& pieces, PieceId start, const CellRect& cells) {
  std::set<PieceId> reached{start};
  std::vector<PieceId> todo{start};
  while (!todo.empty()) {
    const PieceId at = todo.back();
    todo.pop_back();
    for (const Portal& portal : pieces.portals(at))
      if (contains(cells, portal.to.cell) && reached.insert(portal.to).second) todo.push_back(portal.to);
  }
  return reached;
}

void expectInFree(const examples::Way& way, const lgs::Pieces& pieces, const CellRect& cells) {
  for (const Cell cell : cellsOf(cells)) {
    for (const Piece& piece : pieces.solidPieces(cell)) {
      std::vector<Point> polygon;
      for (const LocalPoint p : piece.vertices) polygon.push_back(toWorld(cell, p));
      for (std::size_t k = 1; k < way.corners.size(); ++k)
        failIf(meets(way.corners[k - 1], way.corners[k], polygon)
                   ? std::optional<std::string>("a way leads through what is solid")
                   : std::nullopt);
    }
  }
}

double distance(Point a, Point b) {
  return std::hypot(static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y)) / U;
}

/// The length of a way before it is pulled straight: through the middles of its portals.
double lengthByMiddles(const examples::Way& way, const lgs::Pieces& pieces) {
  double length = 0;
  Point at = way.corners.front();
  for (std::size_t k = 1; k < way.pieces.size(); ++k) {
    const auto portals = pieces.portals(way.pieces[k - 1]);
    const auto portal = std::ranges::find(portals, way.pieces[k], &Portal::to);
    failUnless(portal != portals.end(), "a way goes where no portal leads");
    const Point middle{(portal->left.x + portal->right.x) / 2, (portal->left.y + portal->right.y) / 2};
    length += distance(at, middle);
    at = middle;
  }
  return length + distance(at, way.corners.back());
}

LGS_LAW(Ways, LeadWherePortalsDoThroughWhatIsFree, 300, (const PlainTrace& trace, Chance chance)) {
  oracle::Player player(trace.preserve);
  playAll(trace, player);
  const lgs::Pieces pieces(player.world());
  const CellRect inner = player.world().bounds().value_or(CellRect{});
  const CellRect cells{{inner.min.i - 1, inner.min.j - 1}, {inner.max.i + 1, inner.max.j + 1}};
  std::vector<PieceId> all;
  for (const Cell cell : cellsOf(cells))
    for (std::uint32_t k = 0; k < pieces.freePieces(cell).size(); ++k) all.push_back({cell, k});
  if (all.empty()) return;
  const auto someVertex = [&] {
    const PieceId id = chance.pick(all);
    const auto vertices = pieces.freePieces(id.cell)[id.index].vertices;
    return toWorld(id.cell, vertices[chance.below(vertices.size())]);
  };
  for (int k = 0; k < 4; ++k) {
    const Point from = someVertex(), to = someVertex();
    const auto first = pieces.freePieceAt(from), last = pieces.freePieceAt(to);
    failUnless(first && last, "a vertex of a free piece is in none");
    const auto way = examples::findWay(pieces, {from, to, cells});
    const bool isThere = contains(cells, first->cell) && reachedFrom(pieces, *first, cells).contains(*last);
    failUnless(way.has_value() == isThere, "a way is missed, or made up");
    if (!way) continue;
    failUnless(way->corners.front() == from && way->corners.back() == to, "a way does not end where it should");
    failUnless(way->length <= lengthByMiddles(*way, pieces) + 1e-9, "a way is longer than it was before it was pulled");
    expectInFree(*way, pieces, cells);
  }
}

}  // namespace
}  // namespace lgs::test
