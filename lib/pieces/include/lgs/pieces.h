// Convex pieces of what is solid and of what is free, cell by cell, kept up to date at the cost of the edit: for
// bodies, for navigation, for whatever needs convex polygons.
//
//   if (const auto done = world.followCells(true); !done) return refused(done.error());
//   lgs::Pieces pieces(world);                                 // reads all polygons once
//   if (!pieces.update(world, world.commit()))                 // after each commit(), rollBack() and redo()
//     pieces = lgs::Pieces(world);                             // one was missed
//   for (lgs::Cell cell : pieces.changed())                    // these cells have other pieces now
//     for (const lgs::Piece& piece : pieces.solidPieces(cell)) …
//
// What a piece is:
//
//  1. A piece is a convex polygon in its closed cell: counter-clockwise from its least vertex (by x, then by y), of
//     positive area, no three vertices on a line, at most PiecesOptions::maxVertices of them.
//  2. The solid pieces of a cell have disjoint interiors, and so have its free pieces. The solid pieces that name a
//     polygon make up this polygon. The free pieces make up the cell without its polygons.
//  3. Nothing is rounded: each vertex of a piece is a vertex of some polygon of the cell, or a corner of the cell.
//  4. Two pieces of one polygon that share an edge can not be merged: that would not be convex, or have too many
//     vertices. So can not two free pieces of a cell. Without a limit of vertices these are at most four times as many
//     as needed.
//  5. The pieces follow from the polygons of the cell alone, with which vertex they begin left aside, whatever was
//     edited before; and they are the same on every machine.
//
// The pieces are worked out once for all cells with the same polygons, by a triangulation and by leaving out diagonals
// (Hertel and Mehlhorn: Fast triangulation of the plane with respect to simple polygons, Information and Control 64,
// 1985; docs/pieces.md). Blocks and preserve relations play no part: where there is a polygon, there is no way.
//
// Cells of unloaded chunks count as empty.
//
// A Pieces is one value with one owner. A copy of a world goes on with a copy of its pieces. Calls that are const are
// safe beside each other. All functions are noexcept: when memory runs out the program ends. Lists and spans are valid
// until the next update().
#pragma once

#include <lgs/lattice.h>
#include <lgs/world.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace lgs {

/// How pieces are made.
struct PiecesOptions {
  /// Of one piece. Box2D takes 8. At least 3, at most kMaxVerticesPerCell: this is asserted.
  std::size_t maxVertices = 8;
};

/// A convex piece of one cell. The comment at the top of this file says what it is.
struct Piece {
  static constexpr std::uint32_t kFree = UINT32_MAX;  ///< what `polygon` is for a free piece
  std::uint32_t polygon = kFree;                      ///< a solid piece: index of its polygon in polygonsByPieces()
  std::span<const LocalPoint> vertices;               ///< counter-clockwise, from the least one
};

/// Names a free piece: the index in Pieces::freePieces() of its cell. It is good until its cell has other pieces.
struct PieceId {
  Cell cell;                ///< where
  std::uint32_t index = 0;  ///< in Pieces::freePieces()
  friend constexpr auto operator<=>(const PieceId&, const PieceId&) = default;
};

/// From one free piece to another, in the same cell or across a side: what the two have in common, a segment whose ends
/// are vertices of either. Pieces that have only a point in common have no portal.
struct Portal {
  PieceId to;   ///< the other piece
  Point right;  ///< the end on the right when passing, in lattice units of the world
  Point left;   ///< the end on the left
  friend constexpr bool operator==(const Portal&, const Portal&) = default;
};

/// What pieces are of.
enum class Part : std::uint8_t {
  solid,  ///< what polygons cover
  free,   ///< what they leave
};

/// How much there is, and was done.
struct PiecesStats {
  std::size_t cells = 0;        ///< that hold polygons
  std::size_t contents = 0;     ///< distinct ones of these cells, and the empty one
  std::uint64_t workedOut = 0;  ///< contents since the pieces were made, forgotten ones too
  friend constexpr bool operator==(const PiecesStats&, const PiecesStats&) = default;
};

/// The polygons of a cell in the order that Piece::polygon counts in: each read from its least vertex on, by their
/// vertices. It does not depend on handles. Cost: O(n log n) for the n vertices of the cell.
std::vector<PlacedPolygon> polygonsByPieces(const World& world, Cell cell) noexcept;

/// The pieces of a world. The comment at the top of this file says how they are kept up to date.
class Pieces {
 public:
  /// Reads all polygons of a world, which has no edits that are not committed. Cost: in proportion to its polygons and
  /// vertices, and as of update() for each distinct content.
  explicit Pieces(const World& world, PiecesOptions options = {}) noexcept;
  ~Pieces() noexcept;
  Pieces(const Pieces&) noexcept;  ///< contents are shared; the cells are copied, four bytes each
  Pieces& operator=(const Pieces&) noexcept;
  Pieces(Pieces&&) noexcept;  ///< what was moved from can only be assigned to or destroyed
  Pieces& operator=(Pieces&&) noexcept;

  /// Takes over what the world's last commit, roll-back or redo changed. False, and nothing changes, if
  /// `changes` are not those of it, or do not lead from the version that was seen last, as one was missed, or if the world
  /// does not follow its cells: then begin again. Cost: in proportion to the vertices of the changed cells; and for each content that no cell had before,
  /// O(n log n) for its n vertices, and moves of at most n² words. It looks at no other cell.
  [[nodiscard]] bool update(const World& world, const Changes& changes) noexcept;

  /// The cells that have other pieces by the last update, free ones or solid ones, each once and in the order of the
  /// changes. By another block, or by an edit that came to nothing, a cell has none. Empty after construction.
  const std::vector<Cell>& changed() const noexcept;

  /// The pieces of the polygons of a cell, by Piece::polygon, then by their vertices. A cell out of range has none.
  /// Cost: O(1).
  std::span<const Piece> solidPieces(Cell cell) const noexcept;

  /// The free pieces of a cell, by their vertices. A cell without polygons has one, a cell out of range none. Cost:
  /// O(1).
  std::span<const Piece> freePieces(Cell cell) const noexcept;

  /// The portals of a free piece: inside the cell, in the order of their right ends, then across the south, east, north
  /// and west side, each from its lower coordinates on. A piece that is not there has none. Portals are symmetric: the
  /// other piece has the same one, with left and right exchanged. Cost: in proportion to the portals of the piece, and
  /// to the free pieces on the sides that it touches, here and in the neighbour.
  std::vector<Portal> portals(PieceId piece) const noexcept;
  void portals(PieceId piece, std::vector<Portal>& out) const noexcept;  ///< the same, replacing the content of `out`

  /// A free piece that has a point, its outline included; of several the first of the least cell (by column, then by
  /// row). Cost: in proportion to the vertices of free pieces in the cell; on a common side in both, in a corner in all
  /// four.
  std::optional<PieceId> freePieceAt(Point point) const noexcept;

  /// The cells of a rectangle that are solid, or free, as a whole, merged to disjoint rectangles: by rows from below,
  /// each as long as it gets, and then upwards while the next row has the same one. Blocks play no part. Cost: in
  /// proportion to the cells of the rectangle.
  std::vector<CellRect> wholeCells(const CellRect& cells, Part part) const noexcept;

  std::size_t maxVertices() const noexcept;  ///< the option
  PiecesStats stats() const noexcept;        ///< cost: O(1)

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lgs
