#include "oracle/views/piece_check.h"

#include "oracle/cgal/partition.h"

#include <fmt/format.h>
#include <algorithm>
#include <set>
#include <span>

namespace lgs::oracle {
namespace {

const LocalPolygon kWholeCell{{0, 0}, {kUnitsPerCell, 0}, {kUnitsPerCell, kUnitsPerCell}, {0, kUnitsPerCell}};

std::int64_t turnAt(Point a, Point b, Point c) { return (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x); }
Point wide(LocalPoint p) { return {p.x, p.y}; }

LocalPolygon fromLeast(LocalPolygon polygon) {
  std::rotate(polygon.begin(), std::min_element(polygon.begin(), polygon.end()), polygon.end());
  return polygon;
}

std::optional<std::string> faultOfShape(const LocalPolygon& piece, std::size_t maxVertices,
                                        const std::set<LocalPoint>& existing) {
  const std::size_t n = piece.size();
  if (n < 3 || n > maxVertices) return fmt::format("a piece has {} vertices", n);
  if (*std::min_element(piece.begin(), piece.end()) != piece[0]) return "a piece does not begin with its least vertex";
  for (std::size_t k = 0; k < n; ++k) {
    if (!existing.contains(piece[k])) return fmt::format("a new vertex, {} {}", piece[k].x, piece[k].y);
    if (turnAt(wide(piece[k]), wide(piece[(k + 1) % n]), wide(piece[(k + 2) % n])) <= 0)
      return "a piece does not turn left at each vertex";
  }
  return std::nullopt;
}

/// Two pieces that have a whole edge in common, as one: nothing if that would not be convex.
std::optional<std::size_t> cornersTogether(const LocalPolygon& a, const LocalPolygon& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const LocalPoint p = a[i], q = a[(i + 1) % a.size()];
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (b[j] != q || b[(j + 1) % b.size()] != p) continue;
      LocalPolygon both;
      for (std::size_t k = 1; k < a.size(); ++k) both.push_back(a[(i + k) % a.size()]);  // from q round to before p
      for (std::size_t k = 1; k < b.size(); ++k) both.push_back(b[(j + k) % b.size()]);
      std::size_t corners = 0;
      for (std::size_t k = 0; k < both.size(); ++k) {
        const std::int64_t turn =
            turnAt(wide(both[k]), wide(both[(k + 1) % both.size()]), wide(both[(k + 2) % both.size()]));
        if (turn < 0) return std::nullopt;
        corners += turn > 0 ? 1 : 0;
      }
      return corners;
    }
  }
  return std::nullopt;
}

std::optional<std::string> faultOfList(const std::vector<LocalPolygon>& pieces, std::size_t maxVertices,
                                       const std::set<LocalPoint>& existing) {
  if (!std::is_sorted(pieces.begin(), pieces.end())) return "pieces are not in order";
  for (const LocalPolygon& piece : pieces)
    if (auto fault = faultOfShape(piece, maxVertices, existing)) return fault;
  for (const LocalPolygon& a : pieces)
    for (const LocalPolygon& b : pieces)
      if (const auto corners = cornersTogether(a, b); corners && *corners <= maxVertices)
        return "two pieces could be one";
  return std::nullopt;
}

/// What two convex polygons with disjoint interiors have in common, if it is more than a point: a part of an edge of
/// each. From the right to the left of who goes from a to b.
std::optional<std::pair<Point, Point>> common(const std::vector<Point>& a, const std::vector<Point>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Point p = a[i], q = a[(i + 1) % a.size()];
    for (std::size_t j = 0; j < b.size(); ++j) {
      const Point r = b[(j + 1) % b.size()], s = b[j];  // against the direction of b's edge
      if (turnAt(p, q, r) != 0 || turnAt(p, q, s) != 0) continue;
      const bool rises = p < q;
      const Point right = rises ? std::max(p, r) : std::min(p, r), left = rises ? std::min(q, s) : std::max(q, s);
      if (rises ? right < left : left < right) return std::pair(right, left);
    }
  }
  return std::nullopt;
}

std::vector<Point> inWorld(Cell cell, const LocalPolygon& polygon) {
  std::vector<Point> out;
  for (const LocalPoint p : polygon) out.push_back(toWorld(cell, p));
  return out;
}

std::set<Cell> withThoseAround(const std::vector<Cell>& cells) {
  std::set<Cell> out;
  for (const Cell cell : cells)
    for (const std::int32_t i : {-1, 0, 1})
      for (const std::int32_t j : {-1, 0, 1}) out.insert({cell.i + i, cell.j + j});
  return out;
}

CellRect leastRect(const std::set<Cell>& cells) {
  if (cells.empty()) return {{1, 1}, {0, 0}};
  CellRect r{*cells.begin(), *cells.begin()};
  for (const Cell cell : cells) {
    r.min = {std::min(r.min.i, cell.i), std::min(r.min.j, cell.j)};
    r.max = {std::max(r.max.i, cell.i), std::max(r.max.j, cell.j)};
  }
  return r;
}

struct FreePiece {
  PieceId id;
  std::vector<Point> vertices;
};

bool has(std::span<const LocalPoint> piece, Cell cell, Point p) {
  for (std::size_t k = 0; k < piece.size(); ++k)
    if (turnAt(toWorld(cell, piece[k]), toWorld(cell, piece[(k + 1) % piece.size()]), p) < 0) return false;
  return true;
}

/// freePieceAt() has the first piece of the least cell that has the point.
bool isFoundAt(const Pieces& pieces, Point p) {
  std::optional<PieceId> first;
  const Cell last = cellAt(p);
  for (std::int32_t i = last.i - 1; i <= last.i; ++i) {
    for (std::int32_t j = last.j - 1; j <= last.j; ++j) {
      const auto free = pieces.freePieces({i, j});
      for (std::uint32_t k = 0; k < free.size() && !first; ++k)
        if (has(free[k].vertices, {i, j}, p)) first = PieceId{{i, j}, k};
    }
  }
  return pieces.freePieceAt(p) == first;
}

/// At the vertices of free pieces, at the middles of their edges, and in the middle of what polygons leave none.
std::optional<std::string> faultOfPlaces(const Pieces& pieces, const std::vector<Cell>& cells) {
  for (const Cell cell : cells) {
    std::vector<LocalPoint> points{{kUnitsPerCell / 2, kUnitsPerCell / 2}};
    for (const Piece& piece : pieces.freePieces(cell)) {
      const LocalPoint a = piece.vertices[0], b = piece.vertices[1];
      points.insert(points.end(), {a, b, {(a.x + b.x) / 2, (a.y + b.y) / 2}});
    }
    for (const LocalPoint p : points)
      if (const Point at = toWorld(cell, p); inRange(at) && !isFoundAt(pieces, at))
        return "freePieceAt() finds another piece";
  }
  return std::nullopt;
}

/// Each cell without pieces of the other part is in one rectangle of wholeCells(), and no other cell is. A row of one is
/// as long as it gets, and the rows below and above it are no such rows.
std::optional<std::string> faultOfWholeCells(const Pieces& pieces, const CellRect& cells) {
  for (const Part part : {Part::solid, Part::free}) {
    std::set<Cell> whole;
    const std::vector<CellRect> rects = pieces.wholeCells(cells, part);
    for (const CellRect& r : rects)
      for (std::int32_t j = r.min.j; j <= r.max.j; ++j)
        for (std::int32_t i = r.min.i; i <= r.max.i; ++i)
          if (!whole.insert({i, j}).second) return "wholeCells() has a cell twice";
    std::size_t expected = 0;
    for (std::int32_t j = cells.min.j; j <= cells.max.j; ++j) {
      for (std::int32_t i = cells.min.i; i <= cells.max.i; ++i) {
        const Cell cell{i, j};
        const bool is =
            inRange(cell) && (part == Part::solid ? pieces.freePieces(cell) : pieces.solidPieces(cell)).empty();
        expected += is ? 1 : 0;
        if (is && !whole.contains(cell)) return "wholeCells() forgets a cell";
      }
    }
    if (whole.size() != expected) return "wholeCells() has a cell too many";
    const auto isRow = [&](const CellRect& r, std::int32_t j) {
      for (std::int32_t i = r.min.i; i <= r.max.i; ++i)
        if (!whole.contains({i, j})) return false;
      return !whole.contains({r.min.i - 1, j}) && !whole.contains({r.max.i + 1, j});
    };
    for (const CellRect& r : rects)
      if (!isRow(r, r.min.j) || !isRow(r, r.max.j) || isRow(r, r.min.j - 1) || isRow(r, r.max.j + 1))
        return "wholeCells() has other rows than it says";
  }
  return std::nullopt;
}

/// Those of a cell that nothing was ever told of. With at most three vertices that is two triangles.
CellPieces ofEmptyCell(std::size_t maxVertices) { return piecesIn(Pieces(World(), {maxVertices}), {0, 0}); }

}  // namespace

CellPieces piecesIn(const Pieces& pieces, Cell cell) {
  CellPieces out;
  for (const Piece& p : pieces.solidPieces(cell))
    out.solid.emplace_back(p.polygon, LocalPolygon(p.vertices.begin(), p.vertices.end()));
  for (const Piece& p : pieces.freePieces(cell)) out.free.emplace_back(p.vertices.begin(), p.vertices.end());
  return out;
}

PiecesByCell piecesIn(const Pieces& pieces, const std::vector<Cell>& cells) {
  PiecesByCell out;
  for (const Cell cell : cells) out[cell] = piecesIn(pieces, cell);
  return out;
}

std::optional<std::string> faultOfPieces(std::vector<LocalPolygon> polygons, const CellPieces& pieces,
                                         std::size_t maxVertices) {
  for (LocalPolygon& polygon : polygons) polygon = fromLeast(std::move(polygon));
  std::sort(polygons.begin(), polygons.end());
  std::set<LocalPoint> existing(kWholeCell.begin(), kWholeCell.end());
  for (const LocalPolygon& polygon : polygons) existing.insert(polygon.begin(), polygon.end());

  std::vector<PieceList> solid(polygons.size());
  std::uint32_t last = 0;
  for (const auto& [polygon, piece] : pieces.solid) {
    if (polygon >= polygons.size() || polygon < last) return "solid pieces are not by polygon";
    last = polygon;
    solid[polygon].push_back(piece);
  }
  for (const PieceList& list : solid)
    if (auto fault = faultOfList(list, maxVertices, existing)) return fault;
  if (auto fault = faultOfList(pieces.free, maxVertices, existing)) return fault;

  // CGAL takes a millisecond, and cells repeat.
  static std::set<std::pair<std::vector<LocalPolygon>, std::pair<std::vector<PieceList>, PieceList>>> good;
  constexpr std::size_t kMostKept = 50'000;
  if (good.size() > kMostKept) good.clear();
  const auto [seen, isNew] = good.insert({polygons, {solid, pieces.free}});
  if (!isNew) return std::nullopt;
  auto fault = notAPartition(polygons, solid, pieces.free);
  if (fault) good.erase(seen);
  return fault;
}

std::optional<std::string> faultOfPortals(const Pieces& pieces, const std::vector<Cell>& cells) {
  std::map<Cell, std::vector<FreePiece>> all;
  const std::set<Cell> near = withThoseAround(cells);
  for (const Cell cell : near) {
    std::uint32_t k = 0;
    for (const LocalPolygon& piece : piecesIn(pieces, cell).free)
      all[cell].push_back({{cell, k++}, inWorld(cell, piece)});
  }
  for (const Cell cell : cells) {
    for (const FreePiece& from : all[cell]) {
      std::map<PieceId, std::pair<Point, Point>> expected, found;
      for (const Cell other : withThoseAround({cell}))
        for (const FreePiece& to : all[other])
          if (to.id != from.id)
            if (const auto portal = common(from.vertices, to.vertices)) expected[to.id] = *portal;
      for (const Portal& portal : pieces.portals(from.id))
        if (!found.emplace(portal.to, std::pair(portal.right, portal.left)).second) return "a portal comes twice";
      if (found != expected)
        return fmt::format("piece {} of cell ({}, {}) has {} portals, and should have {}, or others", from.id.index,
                           cell.i, cell.j, found.size(), expected.size());
    }
  }
  return std::nullopt;
}

std::optional<std::string> faultOfPieces(const World& world, const Pieces& pieces, const std::vector<Cell>& cells) {
  for (const Cell cell : cells) {
    if (!inRange(cell)) {
      if (piecesIn(pieces, cell) != CellPieces()) return "there are pieces beyond the last cell";
      continue;
    }
    for (const Piece& p : pieces.freePieces(cell))
      if (p.polygon != Piece::kFree) return "a free piece is of a polygon";
    std::vector<LocalPolygon> polygons;
    for (const PlacedPolygon& p : world.polygons(cell)) polygons.emplace_back(p.vertices.begin(), p.vertices.end());
    if (const auto fault = faultOfPieces(polygons, piecesIn(pieces, cell), pieces.maxVertices()))
      return fmt::format("the pieces of cell ({}, {}): {}", cell.i, cell.j, *fault);
  }
  return faultOfPortals(pieces, cells);
}

/// The cells whose pieces are others than they were known to be, which are known from now on.
std::vector<Cell> PieceCheck::look(const World& world, const Pieces& pieces) {
  const CellPieces empty = ofEmptyCell(pieces.maxVertices());
  world.forEachPolygon([&](Cell cell, const PlacedPolygon&) { known_.try_emplace(cell, empty); });
  std::vector<Cell> differ;
  for (auto& [cell, before] : known_) {
    CellPieces now = piecesIn(pieces, cell);
    if (now != before) differ.push_back(cell);
    before = std::move(now);
  }
  return differ;
}

std::optional<std::string> PieceCheck::begin(const World& world, const Pieces& pieces) {
  known_.clear();
  look(world, pieces);
  return faultOf(world, pieces);
}

std::optional<std::string> PieceCheck::update(const World& world, const Pieces& pieces, std::vector<Cell> told) {
  if (auto wrong = updateOfPending(world, pieces, std::move(told))) return wrong;
  return faultOf(world, pieces);
}

std::optional<std::string> PieceCheck::updateOfPending(const World& world, const Pieces& pieces,
                                                       std::vector<Cell> told) {
  std::ranges::sort(told);
  if (told != look(world, pieces)) return "another list of cells that have other pieces";
  return std::nullopt;
}

std::optional<std::string> PieceCheck::faultOf(const World& world, const Pieces& pieces) const {
  std::vector<Cell> cells;
  for (const auto& [cell, known] : known_) cells.push_back(cell);
  const std::set<Cell> near = withThoseAround(cells);
  if (auto fault = faultOfPlaces(pieces, cells)) return fault;
  constexpr std::int64_t kMostWide = 64;
  if (const CellRect around = leastRect(near);
      around.max.i - std::int64_t{around.min.i} < kMostWide && around.max.j - std::int64_t{around.min.j} < kMostWide)
    if (auto fault = faultOfWholeCells(pieces, around)) return fault;
  return faultOfPieces(world, pieces, {near.begin(), near.end()});
}

}  // namespace lgs::oracle
