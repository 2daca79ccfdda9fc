#include <lgs/pieces.h>

#include "catalogue.h"
#include "cells.h"
#include "geometry/predicates.h"
#include "geometry/sort.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace lgs {
namespace {

using pieces::Content;
using pieces::Opening;

/// From a cell to the one across a side.
constexpr std::array<Cell, detail::kSides> kSteps{{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}};

/// Whether a convex polygon has a point, its rim included.
bool has(std::span<const LocalPoint> polygon, LocalPoint p) {
  LocalPoint a = polygon.back();
  for (const LocalPoint b : polygon) {
    if (detail::orientation(a, b, p) < 0) return false;
    a = b;
  }
  return true;
}

/// The ways of a piece across one side, to the neighbour's openings on its opposite side.
void addAcross(const Opening& here, unsigned side, Cell cell, std::span<const Opening> openings, Cell neighbour,
               std::vector<Portal>& out) {
  const bool runsUp = detail::runsForward(side);
  for (const Opening& there : openings) {
    const std::int32_t low = std::max(here.low, there.low), high = std::min(here.high, there.high);
    if (low >= high) continue;
    const Point lower = toWorld(cell, detail::pointAt(side, low)), upper = toWorld(cell, detail::pointAt(side, high));
    out.push_back({{neighbour, there.piece}, runsUp ? lower : upper, runsUp ? upper : lower});
  }
}

}  // namespace

struct Pieces::Impl {
  Impl(const World& world, std::size_t maxVertices) : version(world.version()), catalogue(maxVertices) {}

  const Content& contentOf(Cell cell) const { return *catalogue.content(cells.at(cell)); }

  /// Gives a cell other polygons. Says whether it has other pieces now.
  bool set(Cell cell, std::span<const PlacedPolygon> polygons) {
    const pieces::ContentId old = cells.at(cell), now = catalogue.use(pieces::keyOf(polygons));
    const bool isOther = old != now && !samePieces(*catalogue.content(old), *catalogue.content(now));
    cells.set(cell, now);
    catalogue.release(old);
    return isOther;
  }

  std::uint64_t version;  ///< of the world, as of the last update
  pieces::Catalogue catalogue;
  pieces::Cells cells;
  std::vector<Cell> changed;
};

Pieces::Pieces(const World& world, PiecesOptions options) noexcept
    : impl_(std::make_unique<Impl>(world, options.maxVertices)) {
  assert(options.maxVertices >= 3 && options.maxVertices <= kMaxVerticesPerCell);
  std::vector<PlacedPolygon> polygons;
  Cell last = Error::kNoCell;
  const auto flush = [&] {
    if (!polygons.empty()) impl_->set(last, polygons);
    polygons.clear();
  };
  world.forEachPolygon([&](Cell cell, const PlacedPolygon& polygon) {
    if (cell != last) flush();
    last = cell;
    polygons.push_back(polygon);
  });
  flush();
}

Pieces::~Pieces() noexcept = default;
Pieces::Pieces(const Pieces& other) noexcept : impl_(std::make_unique<Impl>(*other.impl_)) {}
Pieces& Pieces::operator=(const Pieces& other) noexcept {
  if (this != &other) impl_ = std::make_unique<Impl>(*other.impl_);
  return *this;
}
Pieces::Pieces(Pieces&&) noexcept = default;
Pieces& Pieces::operator=(Pieces&&) noexcept = default;

bool Pieces::update(const World& world, const Changes& changes) noexcept {
  if (!world.followsCells() || changes.before != world.versionBeforeCellChanges()) return false;
  if (changes.before != impl_->version || changes.after != world.version()) return false;
  impl_->version = changes.after;
  impl_->changed.clear();
  for (const CellChange& change : world.cellChanges())
    if (impl_->set(change.cell, change.now)) impl_->changed.push_back(change.cell);
  return true;
}

const std::vector<Cell>& Pieces::changed() const noexcept { return impl_->changed; }

std::span<const Piece> Pieces::solidPieces(Cell cell) const noexcept {
  return inRange(cell) ? std::span<const Piece>(impl_->contentOf(cell).solid) : std::span<const Piece>();
}

std::span<const Piece> Pieces::freePieces(Cell cell) const noexcept {
  return inRange(cell) ? std::span<const Piece>(impl_->contentOf(cell).free) : std::span<const Piece>();
}

std::vector<Portal> Pieces::portals(PieceId piece) const noexcept {
  std::vector<Portal> out;
  portals(piece, out);
  return out;
}

void Pieces::portals(PieceId piece, std::vector<Portal>& out) const noexcept {
  out.clear();
  if (!inRange(piece.cell)) return;
  const Content& content = impl_->contentOf(piece.cell);
  const auto [begin, end] =
      std::equal_range(content.contacts.begin(), content.contacts.end(), pieces::Contact{piece.index, 0, {}, {}},
                       [](const auto& a, const auto& b) { return a.piece < b.piece; });
  for (auto c = begin; c != end; ++c)
    out.push_back({{piece.cell, c->other}, toWorld(piece.cell, c->from), toWorld(piece.cell, c->to)});
  for (unsigned side = 0; side < detail::kSides; ++side) {
    const Cell neighbour{piece.cell.i + kSteps[side].i, piece.cell.j + kSteps[side].j};
    if (!inRange(neighbour)) continue;
    const auto& openings = impl_->contentOf(neighbour).openings[detail::opposite(side)];
    for (const Opening& here : content.openings[side])
      if (here.piece == piece.index) addAcross(here, side, piece.cell, openings, neighbour, out);
  }
}

std::optional<PieceId> Pieces::freePieceAt(Point point) const noexcept {
  if (!inRange(point)) return std::nullopt;
  const Cell cell = cellAt(point);
  const LocalPoint p{static_cast<std::int32_t>(point.x & (kUnitsPerCell - 1)),
                     static_cast<std::int32_t>(point.y & (kUnitsPerCell - 1))};
  for (std::int32_t left = p.x == 0 ? 1 : 0; left >= 0; --left) {
    for (std::int32_t below = p.y == 0 ? 1 : 0; below >= 0; --below) {
      const Cell at{cell.i - left, cell.j - below};
      const std::span<const Piece> all = freePieces(at);
      for (std::uint32_t k = 0; k < all.size(); ++k)
        if (has(all[k].vertices, {p.x + left * kUnitsPerCell, p.y + below * kUnitsPerCell})) return PieceId{at, k};
    }
  }
  return std::nullopt;
}

std::vector<CellRect> Pieces::wholeCells(const CellRect& cells, Part part) const noexcept {
  std::vector<CellRect> done, open, row;
  if (isEmpty(cells)) return done;
  const auto isWhole = [&](Cell cell) {
    return part == Part::solid ? inRange(cell) && freePieces(cell).empty() : inRange(cell) && solidPieces(cell).empty();
  };
  for (std::int64_t j = cells.min.j; j <= cells.max.j; ++j) {
    row.clear();
    bool goesOn = false;
    for (std::int64_t i = cells.min.i; i <= cells.max.i; ++i) {
      const Cell cell{static_cast<std::int32_t>(i), static_cast<std::int32_t>(j)};
      const bool whole = isWhole(cell);
      if (whole && goesOn) row.back().max = cell;
      if (whole && !goesOn) row.push_back({cell, cell});
      goesOn = whole;
    }
    // Both lists are from the left. A rectangle of the row before goes on if this row has the same columns.
    auto before = open.begin();
    for (CellRect& now : row) {
      while (before != open.end() && before->min.i < now.min.i) done.push_back(*before++);
      if (before == open.end() || before->min.i != now.min.i) continue;
      if (before->max.i == now.max.i) {
        now.min.j = before->min.j;
      } else {
        done.push_back(*before);
      }
      ++before;
    }
    done.insert(done.end(), before, open.end());
    open.swap(row);
  }
  done.insert(done.end(), open.begin(), open.end());
  return done;
}

std::size_t Pieces::maxVertices() const noexcept { return impl_->catalogue.maxVertices(); }

PiecesStats Pieces::stats() const noexcept {
  return {impl_->cells.held(), impl_->catalogue.size(), impl_->catalogue.workedOut()};
}

std::vector<PlacedPolygon> polygonsByPieces(const World& world, Cell cell) noexcept {
  struct Keyed {
    pieces::Ring ring;
    PlacedPolygon polygon;
  };
  std::vector<Keyed> keyed;
  for (const PlacedPolygon& polygon : world.polygons(cell))
    keyed.push_back({pieces::canonicalRing(polygon.vertices), polygon});
  detail::sort(keyed, [](const Keyed& a, const Keyed& b) { return a.ring < b.ring; });
  std::vector<PlacedPolygon> out;
  for (const Keyed& k : keyed) out.push_back(k.polygon);
  return out;
}

}  // namespace lgs
