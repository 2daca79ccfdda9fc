// A world of unit cells that hold polygons, and its boundary segments with their ghost vertices.
//
//   lgs::World world;
//   auto block = world.shape(lgs::kUnitSquare);      // validate and intern once
//   auto handle = world.add({3, 4}, *block, 7);       // place it; 7 is your own block id
//   const lgs::Changes& changes = world.commit();     // exactly what changed
//   for (lgs::SegmentId id : changes.added) { lgs::Segment s = *world.segment(id); … }
//
// Edits are checked at once, and refused as a whole (error.h). They change the polygons at once, and the segments with
// the next commit(). A World is one value with one owner. Calls that are const are safe beside each other; beside a
// call that is not const no other call is safe.
#pragma once

#include <lgs/error.h>
#include <lgs/ids.h>
#include <lgs/lattice.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace lgs {

/// Limits. Beyond them an edit is refused with ErrorCode::capacity. Two more refuse in this way: 2^23 - 1 distinct
/// contents of cells, and 2^28 - 1 polygons ever placed in one cell. A commit that needs more than 8 GiB for the
/// records of cells with segments, or more than 2^31 - 2 segments, ends the program, as it does when memory runs out.
inline constexpr std::size_t kMaxVerticesPerCell = 4'096;  ///< of all polygons of one cell together
inline constexpr std::size_t kMaxPolygonsPerCell = 254;
inline constexpr std::size_t kMaxChunks = (std::size_t{1} << 22) - 1;  ///< of 32×32 cells, ever touched by an edit

/// Says whether the overlap between polygons of these two blocks is kept (true) or cancelled (false). The smaller block
/// always comes first, so any function gives a symmetric relation. It must give the same answer every time, throw
/// nothing and not call back into the world. If it is empty, everything is cancelled.
using PreserveRelation = std::function<bool(Block, Block)>;

/// Calls job(0) … job(count − 1), each exactly once, in any order and on any threads. Returns when all of them have
/// returned. So the application lends its own threads to a commit. With C++20 alone:
///
///   lgs::Executor twoThreads = [](std::size_t count, const std::function<void(std::size_t)>& job) {
///     std::atomic<std::size_t> next = 0;
///     const auto work = [&] { for (std::size_t k; (k = next++) < count;) job(k); };
///     std::jthread other(work);
///     work();
///   };
using Executor = std::function<void(std::size_t count, const std::function<void(std::size_t)>& job)>;

/// A polygon as it stands in a cell. `vertices` is valid until the next edit of the world: copy them first if you
/// remove a polygon to put it back later.
struct PlacedPolygon {
  PolygonHandle handle;
  Block block = 0;
  std::span<const LocalPoint> vertices;
};

/// One boundary segment. The solid is on the left of start→end, the outward normal on the right.
struct Segment {
  SegmentId id;
  Point start;
  Point end;
  SegmentId predecessor;  ///< null if nothing that could precede arrives at `start`: only under a preserve relation
  SegmentId successor;
  Point ghost1;  ///< the predecessor's start; means nothing if `predecessor` is null
  Point ghost2;  ///< the successor's end; means nothing if `successor` is null
  Block block = 0;
  PolygonHandle polygon;  ///< the polygon hit when this segment is hit
  Cell cell;              ///< the cell hit
};

/// What a commit did to the segments. No id is in two lists. A segment whose ends, owner and ghosts are as before is in
/// none. Ids in `removed` name nothing from now on. The order of each list depends on the edits alone.
struct Changes {
  std::vector<SegmentId> removed;
  std::vector<SegmentId> added;
  std::vector<SegmentId> relinked;  ///< alive before and after, with another ghost1 or ghost2
};

/// One closed chain, in the direction of its segments (solid on the left).
struct Loop {
  std::vector<Point> vertices;      ///< from the least one on, by x, then y; the last edge leads back to it
  std::vector<SegmentId> segments;  ///< segments[k] starts at vertices[k]; empty if collinear ones were merged
};

enum class Collinear : bool { keep, merge };

struct Stats {
  std::uint64_t polygons = 0;
  std::uint64_t cells = 0;     ///< cells that hold at least one polygon
  std::uint64_t segments = 0;  ///< live ones, as of the last commit
  std::uint64_t shapes = 0;
  std::uint64_t contents = 0;  ///< distinct contents of cells; those that no cell has are forgotten in time
  std::uint64_t chunks = 0;
  std::uint64_t bytes = 0;  ///< allocated, with spare capacity; an estimate for the index of shapes
};

class World {
 public:
  explicit World(PreserveRelation preserve = {});
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;
  World(World&&) noexcept;  ///< a world that was moved from can only be assigned to or destroyed
  World& operator=(World&&) noexcept;

  // --- Shapes -------------------------------------------------------------------------------------------------------

  /// Validates and stores one polygon, or a set of polygons with disjoint interiors. Each must be simple, run
  /// counter-clockwise, have a positive area and be inside the closed cell. The same polygons, vertex by vertex, give
  /// the same id. A shape is never forgotten. Cost: O(n²) the first time, a hash later.
  Expected<ShapeId> shape(std::span<const LocalPoint> polygon);
  Expected<ShapeId> shape(std::span<const std::vector<LocalPoint>> polygons);

  // --- Edits --------------------------------------------------------------------------------------------------------

  /// Places every polygon of a shape in a cell, all with this block. Returns the handle of the shape's first polygon.
  /// Refused: cellOutOfRange, unknownShape, overlap, capacity. Cost: O(1) in a cell that is empty.
  Expected<PolygonHandle> add(Cell cell, ShapeId shape, Block block);

  /// The same. `handles` receives the handles of all polygons in the shape's order, or as many as it has room for.
  Expected<PolygonHandle> add(Cell cell, ShapeId shape, Block block, std::span<PolygonHandle> handles);

  /// The same for a polygon given by its vertices. If it was seen before this costs a hash, otherwise it is validated.
  Expected<PolygonHandle> add(Cell cell, std::span<const LocalPoint> polygon, Block block);
  Expected<PolygonHandle> add(Cell cell, std::span<const FloatPoint> polygon, Block block);
  Expected<PolygonHandle> add(Cell cell, std::span<const DoublePoint> polygon, Block block);

  /// Removes one polygon. Refused: staleHandle; capacity, if what is left in the cell would be a content too many.
  Expected<void> remove(PolygonHandle polygon);

  /// Places a shape in every cell of a rectangle, or in none. Returns the number of cells. Refused as add() would be
  /// for the first cell, by rows from `min`, that add() would refuse; but cellOutOfRange names a corner of the
  /// rectangle that is out of range. An empty rectangle is no error.
  Expected<std::uint64_t> fill(const CellRect& cells, ShapeId shape, Block block);

  /// Removes every polygon in every cell of a rectangle. Returns the number of polygons removed. Refused:
  /// cellOutOfRange, with a corner of the rectangle that is out of range.
  Expected<std::uint64_t> clear(const CellRect& cells);

  /// Brings the segments up to date with all edits since the last commit. The result is valid until the next commit.
  /// Cost: in proportion to the contents of the edited cells and of the eight around each. Allocates nothing once the
  /// world has reached its size.
  const Changes& commit();

  /// The same to the last id and its place in the lists, on the executor's threads if the world has no segments yet, as
  /// in its first commit. Then there is most work to spread. Any other commit is as above, and so is one with an empty
  /// executor. On threads the preserve relation is called from several of them at a time. A job is the work on a chunk
  /// of 32×32 cells, and throws nothing. Allocates working memory in proportion to the cells with segments.
  const Changes& commit(const Executor& executor);

  // --- Reading ------------------------------------------------------------------------------------------------------

  /// The polygons of a cell, after all edits, committed or not. A cell out of range holds none.
  std::vector<PlacedPolygon> polygons(Cell cell) const;
  void polygons(Cell cell, std::vector<PlacedPolygon>& out) const;  ///< the same, replacing the content of `out`

  /// Refused: staleHandle.
  Expected<PlacedPolygon> polygon(PolygonHandle handle) const;
  Expected<Cell> cellOf(PolygonHandle handle) const;

  /// A segment as of the last commit. Its `polygon` is stale if that was removed since. Refused: unknownSegment.
  Expected<Segment> segment(SegmentId id) const;

  /// The ids of all segments, in increasing order.
  std::vector<SegmentId> segments() const;

  /// The ids of the segments of polygons in these cells, in no particular order. Cost: in proportion to the cells there
  /// that have a chunk.
  std::vector<SegmentId> segments(const CellRect& cells) const;

  /// The closed chains, sorted by their vertices. Under a preserve relation only those whose links are all mutual.
  std::vector<Loop> loops(Collinear collinear = Collinear::keep) const;

  /// The highest SegmentId::value in use so far: an array for what you know of segments needs one place more.
  std::uint32_t maxSegmentId() const;

  /// Counts what there is. Cost: it looks at every cell of every chunk.
  Stats stats() const;

  struct Impl;  ///< of the implementation

 private:
  std::unique_ptr<Impl> impl_;
};

/// The whole cell as a polygon, for shape().
inline constexpr std::array<LocalPoint, 4> kUnitSquare{
    {{0, 0}, {kUnitsPerCell, 0}, {kUnitsPerCell, kUnitsPerCell}, {0, kUnitsPerCell}}};

}  // namespace lgs
