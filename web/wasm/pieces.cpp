// Convex pieces of what is solid and of what is free, and the ways between the free ones.
#include "bridge.h"

#include <lgs/pieces.h>

namespace lgs::web {

/// The pieces of a world. JavaScript says which world it is, in each call: it knows whether that still lives.
struct FollowedPieces : Follower {
  Pieces pieces;
  std::vector<Cell> changed = {};  ///< by the last update
};

namespace {

void putVertices(Cell cell, const Piece& piece) {
  answer().push_back(static_cast<double>(piece.vertices.size()));
  for (const LocalPoint v : piece.vertices) {
    const Point p = toWorld(cell, v);
    answer().insert(answer().end(), {cellsOf(p.x), cellsOf(p.y)});
  }
}

void putId(const PieceId& piece) {
  answer().insert(answer().end(), {static_cast<double>(piece.cell.i), static_cast<double>(piece.cell.j),
                                   static_cast<double>(piece.index)});
}

}  // namespace

LGS_EXPORT("pieces") FollowedPieces* piecesOf(Bridge* bridge, std::size_t maxVertices) {
  if (const auto done = bridge->world.followCells(true); !done)
    return refused(done.error(), static_cast<FollowedPieces*>(nullptr));
  return new FollowedPieces{{.moment = bridge->moment}, Pieces(bridge->world, {maxVertices})};
}
LGS_EXPORT("dropPieces") void dropPieces(FollowedPieces* followed) { delete followed; }

LGS_EXPORT("updatePieces") std::int32_t updatePieces(FollowedPieces* followed, const Bridge* bridge) {
  followed->changed.clear();
  return followed->follow(*bridge, [&] {
    if (!followed->pieces.update(bridge->world, *bridge->last)) return false;
    followed->changed = followed->pieces.changed();
    return true;
  });
}
LGS_EXPORT("arePiecesOfNow") std::int32_t arePiecesOfNow(const FollowedPieces* followed, const Bridge* bridge) {
  return followed->isOfNow(*bridge);
}

/// i, j of the cells that the last update changed.
LGS_EXPORT("changedPieces") std::size_t changedPieces(const FollowedPieces* followed) {
  answer().clear();
  for (const Cell cell : followed->changed)
    answer().insert(answer().end(), {static_cast<double>(cell.i), static_cast<double>(cell.j)});
  return answer().size();
}

/// Of each its polygon and block, the number of its vertices, and these.
LGS_EXPORT("solidPieces")
std::size_t solidPieces(const FollowedPieces* followed, const Bridge* bridge, std::int32_t i, std::int32_t j) {
  const auto polygons = polygonsByPieces(bridge->world, {i, j});
  answer().clear();
  for (const Piece& piece : followed->pieces.solidPieces({i, j})) {
    const PlacedPolygon& polygon = polygons[piece.polygon];
    answer().insert(answer().end(), {toNumber(polygon.handle), static_cast<double>(polygon.block)});
    putVertices({i, j}, piece);
  }
  return answer().size();
}

/// Of each the number of its vertices, and these.
LGS_EXPORT("freePieces") std::size_t freePieces(const FollowedPieces* followed, std::int32_t i, std::int32_t j) {
  answer().clear();
  for (const Piece& piece : followed->pieces.freePieces({i, j})) putVertices({i, j}, piece);
  return answer().size();
}

/// Of each i, j and index of the other piece, and the right and the left end.
LGS_EXPORT("portals")
std::size_t portals(const FollowedPieces* followed, std::int32_t i, std::int32_t j, std::uint32_t index) {
  answer().clear();
  for (const Portal& portal : followed->pieces.portals({{i, j}, index})) {
    putId(portal.to);
    for (const Point p : {portal.right, portal.left}) answer().insert(answer().end(), {cellsOf(p.x), cellsOf(p.y)});
  }
  return answer().size();
}

/// i, j and index; returns 0 where no free piece has the point.
LGS_EXPORT("freePieceAt") std::int32_t freePieceAt(const FollowedPieces* followed, double x, double y) {
  const Point point = latticePoint({x, y});
  const auto found = inRange(point) ? followed->pieces.freePieceAt(point) : std::nullopt;
  if (!found) return 0;
  answer().clear();
  putId(*found);
  return 1;
}

/// Rectangles: i0, j0, i1, j1 of each.
LGS_EXPORT("wholeCells")
std::size_t wholeCells(const FollowedPieces* followed, std::int32_t i0, std::int32_t j0, std::int32_t i1,
                       std::int32_t j1, std::int32_t isFree) {
  answer().clear();
  for (const CellRect& r : followed->pieces.wholeCells({{i0, j0}, {i1, j1}}, isFree != 0 ? Part::free : Part::solid))
    answer().insert(answer().end(), {static_cast<double>(r.min.i), static_cast<double>(r.min.j),
                                     static_cast<double>(r.max.i), static_cast<double>(r.max.j)});
  return answer().size();
}

}  // namespace lgs::web
