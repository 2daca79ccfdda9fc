// Brushes: paint or carve any region, across any cells.
//
//   const auto hole = lgs::circle(lgs::latticePoint({12.5, 7.0}), 3 * lgs::kUnitsPerCell, 32);
//   const auto done = lgs::carve(world, hole);
//   if (!done) return refused(done.error());          // nothing has changed
//   for (const auto& [old, now] : done->changed) …    // what your game keeps by handle
//   world.commit();                                   // as after any edit
//
// Laws 8 to 11 of docs/contract.md bound how much the result may differ from the exact one; what rounding moves
// BrushResult::rounded names. docs/internals/brushes.md has how they are kept.
//
// Units: a Point is in lattice units of the world, 65,536 to a cell. Lengths are in lattice units too.
#pragma once

#include <lgs/error.h>
#include <lgs/ids.h>
#include <lgs/lattice.h>
#include <lgs/world.h>

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace lgs {

/// A region is at most this many cells wide and high.
inline constexpr std::int64_t kMaxRegionCells = 4'096;

/// At most so many edges of a region run through one cell, and at most so often these and the edges of polygons cross
/// there. The worst cell that was tried, full and crossed by as many, takes 0.3 s.
inline constexpr std::size_t kMaxRegionEdgesPerCell = 4'096;
inline constexpr std::size_t kMaxCrossingsPerCell = 32'768;  ///< see kMaxRegionEdgesPerCell

/// Which points are inside. Count how often the rings run around a point: a counter-clockwise turn is +1, a clockwise
/// one is -1.
enum class FillRule : std::uint8_t {
  nonZero,  ///< inside where the count is not 0: rings that overlap are united
  evenOdd,  ///< inside where the count is odd: a ring within a ring is a hole
};

/// A closed ring: the last vertex is followed by the first. It may cross and touch itself.
using Ring = std::vector<Point>;

/// A set of points, given by closed rings. They may cross and overlap, and run either way around.
struct Region {
  std::vector<Ring> rings;            ///< each is closed
  FillRule rule = FillRule::nonZero;  ///< which points are inside them
};

/// A region from vertices in cells, each rounded by latticePoint(). What is beyond the last cell, or no number, is
/// refused when the region is used.
[[nodiscard]] Region region(std::span<const std::vector<DoublePoint>> rings, FillRule rule = FillRule::nonZero);

/// Returns the least rectangle of cells with all of a region; an empty one, if the region has no vertices or no width
/// or no height. Refused: outOfReach, as by paint(). Cost: it looks at each vertex.
[[nodiscard]] Expected<CellRect> boundsOf(const Region& region) noexcept;

/// Returns the cells that have a part of a region, each once: those in which paint() and carve() may change something.
/// Refused: as by paint(). Cost: as of paint() without the work in the cells.
[[nodiscard]] Expected<std::vector<Cell>> cellsOf(const Region& region) noexcept;

/// Returns a region but for another one: paint(world, *without(region, except), …) leaves `except` as it is. The
/// vertices are those of both and where their edges cross, rounded to the lattice; so are the edges where they run from
/// cell to cell. Every point in which it differs from the exact difference lies within two lattice units of an edge of
/// either. Refused: as by painting the one and then carving the other in an empty world; Error::polygon counts the
/// rings of `region`, and then those of `except`. Cost: as of these, and memory for the cells that are inside the
/// region.
[[nodiscard]] Expected<Region> without(const Region& region, const Region& except) noexcept;

/// Whether a region, its outline included, has a point in common with a simple counter-clockwise polygon. Nothing that
/// is beyond the last cell has, or more than kMaxRegionCells wide or high. Cost: in proportion to the vertices of the
/// one times those of the other.
[[nodiscard]] bool meets(const Region& region, const Ring& polygon) noexcept;

/// A circle as a polygon. Its corners lie on the circle, rounded to the lattice. `corners` is rounded up to a multiple
/// of 8, at most 4,096. It uses integers only, so every machine makes the same one. The radius is at least 1 and at
/// most kMaxRegionCells / 2 cells: a region with another one is refused (outOfReach) when it is used.
[[nodiscard]] Region circle(Point center, std::int64_t radius, int corners = 32);

/// A rectangle that is turned: `along` is the direction of its length. Half of the length and half of the width are at
/// least 1 and at most kMaxRegionCells / 2 cells, as the radius of a circle. A direction (0, 0) counts as (1, 0).
[[nodiscard]] Region rectangle(Point center, Point along, std::int64_t halfLength, std::int64_t halfWidth);

/// A thick line through points, with round joints and ends: everything within `radius` of it, where a circle has so
/// many corners. One point gives a circle, none an empty region. The radius is as for a circle.
[[nodiscard]] Region thickLine(std::span<const Point> points, std::int64_t radius, int corners = 16);

/// What painting does where there is ground already.
enum class PaintMode : std::uint8_t {
  fill,     ///< paints what is free; polygons stay as they are
  replace,  ///< takes over what is there
};

/// Returns whether polygons of a block stay, whatever a brush does around them: bedrock that is never dug away, ore
/// that is mined in another way. It must give the same answer every time, throw nothing and not call back into the
/// world. Empty: none stay.
using StayingBlocks = std::function<bool(Block)>;

/// An old polygon, and what it became: one polygon or more. A polygon of a whole cell that got another block is still
/// itself.
struct BrushChange {
  PolygonHandle old;               ///< a stale handle now, unless `now` has it too
  std::vector<PolygonHandle> now;  ///< what stands in its place
};

/// What a brush did to polygons. A polygon that is not named has kept its handle, vertices and block.
struct BrushResult {
  std::vector<PolygonHandle> removed;  ///< nothing is left of them, or less than half a square unit
  std::vector<PolygonHandle> added;    ///< there is nothing of an old polygon in them
  std::vector<BrushChange> changed;    ///< old polygons that are cut, moved by rounding, united, or recoloured
  std::vector<PolygonHandle>
      rounded;  ///< of the old ones above, that law 9 should have kept: docs/internals/brushes.md
};

/// Paints a region with a block. What is painted and the polygons that the region meets are united, in each cell, where
/// they share edges and have the same block. If that leaves such an area as it was, its polygons keep their handles; of
/// several polygons rounding may make some anew, which `changed` names. Returns what became of polygons. Cells that are
/// inside the region as a whole cost what add() and setBlock() cost. Refused, and nothing is changed: outOfReach, if a
/// vertex lies in no cell or was no number (Error::polygon is the ring, Error::vertex the vertex), or if the region is
/// more than kMaxRegionCells wide or high, or was made with a length out of range; capacity, if a cell would hold too
/// much (see limits.h), or the region is too much for it (see kMaxRegionEdgesPerCell); unloaded, if it has a part of an
/// unloaded cell. A region without area changes nothing.
///
/// `staying` is called once for each block. What it names is painted around, as by PaintMode::fill: its edges are cut
/// where the region's edge meets them, and the corner there is rounded (law 8), so now and then such a polygon gets
/// another handle.
[[nodiscard]] Expected<BrushResult> paint(World& world, const Region& region, Block block, PaintMode mode,
                                          const StayingBlocks& staying = {}) noexcept;

/// Frees a region, but for what `staying` names. Returned and refused: as by paint(), and so is the rest. Cells that
/// are inside the region as a whole cost what clear() costs; those in which something stays, what remove() costs.
[[nodiscard]] Expected<BrushResult> carve(World& world, const Region& region,
                                          const StayingBlocks& staying = {}) noexcept;

}  // namespace lgs
