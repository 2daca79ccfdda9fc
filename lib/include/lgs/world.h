// A world of unit cells that hold polygons, and its boundary segments with their ghost vertices.
//
//   lgs::World world;
//   auto block = world.shape(lgs::kUnitSquare);      // validate and intern once
//   auto handle = world.add({3, 4}, *block, 7);       // place it; 7 is your own block id
//   const lgs::Changes& changes = world.commit();     // exactly what changed
//   for (lgs::SegmentId id : changes.added) { lgs::Segment s = *world.segment(id); … }
//
// Edits are checked at once and refused as a whole (error.h). What they do to the segments becomes visible with
// commit(); what they do to the polygons at once. A World is one value with one owner: no call is safe beside another
// call that is not const; const calls are safe beside each other.
#pragma once

#include <lgs/error.h>
#include <lgs/ids.h>
#include <lgs/lattice.h>
#include <lgs/questions.h>
#include <lgs/snapshot.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace lgs {

/// Limits. Beyond them an edit is refused with ErrorCode::capacity; so it is beyond 2^23 - 1 distinct contents of cells
/// and 2^28 - 1 polygons ever placed in one cell. Beyond 8 GiB of records of cells that show, or 2^31 - 2 segments, a
/// commit ends the program, as running out of memory does.
inline constexpr std::size_t kMaxVerticesPerCell = 4'096;  ///< of all polygons of one cell together
inline constexpr std::size_t kMaxPolygonsPerCell = 254;
inline constexpr std::size_t kMaxChunks = (std::size_t{1} << 22) - 1;  ///< of 32×32 cells, ever touched by an edit

/// Says whether the overlap between polygons of these two blocks is kept (true) or cancelled (false). It is always
/// called with the smaller block first, so any function gives a symmetric relation. It must be pure: the same answer
/// every time, no exception, and no call back into the world. Empty: everything is cancelled.
using PreserveRelation = std::function<bool(Block, Block)>;

/// Calls job(0) … job(count − 1), each exactly once, in any order and on any threads, and returns when all of them have
/// returned. This is where an application's own threads come in; with C++20 alone:
///
///   lgs::Executor twoThreads = [](std::size_t count, const std::function<void(std::size_t)>& job) {
///     std::atomic<std::size_t> next = 0;
///     const auto work = [&] { for (std::size_t k; (k = next++) < count;) job(k); };
///     std::jthread other(work);
///     work();
///   };
using Executor = std::function<void(std::size_t count, const std::function<void(std::size_t)>& job)>;

/// A polygon as it stands in a cell. `vertices` is valid until the next edit of the world: to put a polygon back that you
/// removed, copy them first.
struct PlacedPolygon {
  PolygonHandle handle;
  Block block = 0;
  std::span<const LocalPoint> vertices;
};

/// One boundary segment: solid on the left of start→end, outward normal on the right.
struct Segment {
  SegmentId id;
  Point start;
  Point end;
  SegmentId predecessor;  ///< null if nothing arrives at `start` that could precede (only under a preserve relation)
  SegmentId successor;
  Point ghost1;  ///< the predecessor's start; meaningless where `predecessor` is null
  Point ghost2;  ///< the successor's end; meaningless where `successor` is null
  Block block = 0;
  PolygonHandle polygon;  ///< the polygon hit when this segment is hit
  Cell cell;              ///< the cell hit

  double length() const;       ///< in cells
  DoublePoint normal() const;  ///< outward, of length 1
};

/// What a commit did to the segments. No id is in two lists; a segment whose ends, owner and ghosts are as before is in
/// none. Ids in `removed` name nothing from here on. Each list is in an order that depends on the edits alone.
struct Changes {
  std::vector<SegmentId> removed;
  std::vector<SegmentId> added;
  std::vector<SegmentId> relinked;  ///< alive before and after, with another ghost1 or ghost2
};

/// One closed chain, in the direction of its segments (solid on the left).
struct Loop {
  std::vector<Point> vertices;      ///< starts at the least vertex (by x, then y); the last edge leads back to it
  std::vector<SegmentId> segments;  ///< segments[k] starts at vertices[k]; empty when collinear runs are merged
};

enum class Collinear : bool { keep, merge };

struct Stats {
  std::uint64_t polygons = 0;
  std::uint64_t cells = 0;     ///< cells that hold at least one polygon
  std::uint64_t segments = 0;  ///< live ones, as of the last commit
  std::uint64_t shapes = 0;
  std::uint64_t contents = 0;  ///< distinct interned cell contents; those without use are forgotten in time
  std::uint64_t chunks = 0;
  std::uint64_t bytes = 0;  ///< allocated, spare capacity included; the index of shapes is estimated
};

class Transaction;

class World {
 public:
  explicit World(PreserveRelation preserve = {});
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;
  World(World&&) noexcept;  ///< a world moved from can only be assigned to or destroyed
  World& operator=(World&&) noexcept;

  // --- Shapes -------------------------------------------------------------------------------------------------------

  /// Validates and interns one polygon, or a set of polygons with disjoint interiors: simple, counter-clockwise, inside
  /// the closed cell, positive area. The same polygons, vertex by vertex, give the same id; a shape is never forgotten.
  /// Cost: O(n²) the first time, a hash later.
  Expected<ShapeId> shape(std::span<const LocalPoint> polygon);
  Expected<ShapeId> shape(std::span<const std::vector<LocalPoint>> polygons);

  // --- Edits --------------------------------------------------------------------------------------------------------

  /// Places every polygon of a shape in a cell, all with this block. Returns the handle of the shape's first polygon.
  /// Refused: cellOutOfRange, unknownShape, overlap, capacity. Cost: O(1) in a cell that is empty.
  Expected<PolygonHandle> add(Cell cell, ShapeId shape, Block block);

  /// The same; `handles` receives the handles of all polygons, in the shape's order, or as many as it has room for.
  Expected<PolygonHandle> add(Cell cell, ShapeId shape, Block block, std::span<PolygonHandle> handles);

  /// The same for a polygon given by its vertices: one that was seen before costs a hash, a new one is validated.
  Expected<PolygonHandle> add(Cell cell, std::span<const LocalPoint> polygon, Block block);
  Expected<PolygonHandle> add(Cell cell, std::span<const FloatPoint> polygon, Block block);
  Expected<PolygonHandle> add(Cell cell, std::span<const DoublePoint> polygon, Block block);

  /// Removes one polygon. Refused: staleHandle; capacity, if what is left in the cell would be one content too many.
  Expected<void> remove(PolygonHandle polygon);

  /// Places a shape in every cell of a rectangle; returns the number of cells. All or nothing: refused as add() is, for
  /// the first cell (by rows, from min) where add() would be; cellOutOfRange names the corner that is. An empty rectangle
  /// is no error.
  Expected<std::uint64_t> fill(const CellRect& cells, ShapeId shape, Block block);

  /// Removes every polygon of every cell of a rectangle; returns the number of polygons removed.
  Expected<std::uint64_t> clear(const CellRect& cells);

  /// Puts a shape in the place of all polygons of a cell, which may be empty: all or nothing. Returns the handle of the
  /// shape's first polygon; `handles` receives all of them, as with add(). Refused: as add() is, but for overlap.
  Expected<PolygonHandle> replace(Cell cell, ShapeId shape, Block block, std::span<PolygonHandle> handles = {});

  /// Gives a polygon another block. It keeps its handle and its place. At the next commit its segments are removed and
  /// added again, as another block is another owner; all others keep their ids. Refused: staleHandle; capacity, if a
  /// preserve relation makes of the cell one content too many.
  Expected<void> setBlock(PolygonHandle polygon, Block block);

  /// Removes every polygon of a cell; returns how many. A cell out of range is refused: cellOutOfRange.
  Expected<std::uint64_t> clear(Cell cell) { return clear(CellRect{cell, cell}); }

  /// Brings the segments up to date with all edits since the last commit: the two phases, on what those edits touched.
  /// The result is valid until the next commit. Cost: in proportion to the contents of the edited cells and the eight
  /// around each. Allocates nothing once the world has reached its size.
  const Changes& commit();

  /// The same, to the last id and its place in the lists, with the work spread over the executor's threads where there is
  /// most of it: in a commit that finds no segments, as the first one of a world does. Any other commit is as above, and
  /// an empty executor too. The relation, if there is one, is then called from several threads at a time. A job is the
  /// work on a chunk of 32×32 cells; it throws nothing. Allocates working memory in proportion to the live cells.
  const Changes& commit(const Executor& executor);

  // --- Going back ----------------------------------------------------------------------------------------------------
  //
  // Law 12, restore and replay is never having left: after going back to a mark, every later output, id and list is as if
  // the edits and commits after the mark had not been made. So handles, shapes, segment ids and marks made after it name
  // nothing, until they are given out again. While there are marks, an edit costs some more, and what is needed to undo it
  // is kept, in proportion to the edits since the oldest mark.

  /// Notes the present moment. Edits that are not committed may be pending. Cost: O(1).
  [[nodiscard]] Mark checkpoint();

  /// Goes back to a mark. It stays, so that one can go back to it again; later marks are void. changesOfRollBack() then
  /// says what this did to the segments. Refused: unknownMark. Cost: in proportion to the edits since the mark.
  Expected<void> rollBack(Mark mark);

  /// What the last rollBack() did to the segments, as those know them who followed all commits: the three lists of a
  /// commit, by id. One thing is different: an id that named one segment and names another now is removed, and then added.
  const Changes& changesOfRollBack() const;

  /// Lets go of a mark; other marks stay. Refused: unknownMark.
  Expected<void> forget(Mark mark);

  // --- Saving --------------------------------------------------------------------------------------------------------

  /// Writes the world as bytes: polygons, handles, shapes, segment ids; not the marks, and not the preserve relation, which
  /// is a function. Refused: uncommitted. Cost: in proportion to the world. Full blocks take less than a byte a cell, ramps
  /// some four.
  Expected<void> save(const ByteSink& sink) const;

  /// The world that was saved. It continues exactly: the same edits give the same ids and lists as if it had never been
  /// saved (law 12). `preserve` must be the relation that it was saved with, or none if it had none. Bytes that are cut,
  /// damaged or made up are refused, and take no more memory than a constant for each of them. Cost: in proportion to the
  /// world, and quadratic in the vertices of a cell content, as shape() is.
  static tl::expected<World, SnapshotError> load(std::span<const std::byte> snapshot, PreserveRelation preserve = {});

  // --- Reading ------------------------------------------------------------------------------------------------------

  /// The polygons of a cell, edits not yet committed included. A cell out of range holds none.
  std::vector<PlacedPolygon> polygons(Cell cell) const;
  void polygons(Cell cell, std::vector<PlacedPolygon>& out) const;  ///< the same, replacing the content of `out`

  /// Whether a cell holds no polygon. A cell out of range holds none.
  bool isEmpty(Cell cell) const;

  /// Calls visit(cell, polygon) for every placed polygon, buried ones too: chunk by chunk in the order in which edits first
  /// reached them, each by rows, each cell by handle. The second form visits the cells of a rectangle only. `visit` must
  /// not change the world. Cost: in proportion to the cells of existing chunks there.
  using PolygonVisitor = std::function<void(Cell, const PlacedPolygon&)>;
  void forEachPolygon(const PolygonVisitor& visit) const;
  void forEachPolygon(const CellRect& cells, const PolygonVisitor& visit) const;

  /// The least rectangle of cells with all placed polygons; nothing in an empty world. Cost: as forEachPolygon().
  std::optional<CellRect> bounds() const;

  /// The polygons of a shape, in its order. Valid until the next shape is made. Refused: unknownShape.
  Expected<std::vector<std::span<const LocalPoint>>> polygons(ShapeId shape) const;

  /// Refused: staleHandle.
  Expected<PlacedPolygon> polygon(PolygonHandle handle) const;
  Expected<Cell> cellOf(PolygonHandle handle) const;

  /// A segment as of the last commit. Refused: unknownSegment. Its `polygon` is stale if that polygon was removed since.
  Expected<Segment> segment(SegmentId id) const;

  /// Ids of all live segments, in increasing order.
  std::vector<SegmentId> segments() const;

  /// Ids of the segments that belong to polygons of these cells, in no particular order. Cost: in proportion to
  /// the cells of existing chunks there.
  std::vector<SegmentId> segments(const CellRect& cells) const;

  /// The closed chains, sorted by their vertices. Under a preserve relation, only chains whose links are all mutual.
  std::vector<Loop> loops(Collinear collinear = Collinear::keep) const;

  // --- Questions about places; the answers are in questions.h ---------------------------------------------------------

  /// Which polygon is at a point, edits not yet committed included. A point out of range is outside. Cost: in proportion to
  /// the vertices in the cell (on a common side: in both cells, in a corner: in four).
  Spot at(Point point) const;

  /// The segment nearest to a point, as of the last commit, at most `radius` cells away. Of several at the same distance
  /// the least by start, end, block. Refused: outOfReach, if the point is out of range, or the radius is not from 0 to
  /// kMaxRadius. Cost: in proportion to the cells of existing chunks within twice the distance found, or within the radius.
  Expected<Nearest> nearest(Point point, double radius) const;

  /// The first segment that a ray meets on its outward side, as of the last commit. A ray that starts in a solid leaves it
  /// without a hit, and one that runs along a segment does not hit it; the ends of a segment count. Of several at the same
  /// place the least by start, end, block. Refused: outOfReach, if an end is out of range, or the ray is longer than
  /// kMaxRay cells on an axis. Cost: in proportion to the cells that the ray touches, up to the hit.
  Expected<RayHit> rayCast(Point from, Point to) const;

  /// The highest SegmentId::value in use so far, for sizing side tables.
  std::uint32_t maxSegmentId() const;

  /// Counts by looking at every cell of every chunk.
  Stats stats() const;

  /// Begins a group of edits that happens as a whole or not at all.
  [[nodiscard]] Transaction edit();

  struct Impl;  ///< of the implementation

 private:
  friend class Transaction;
  std::unique_ptr<Impl> impl_;
};

/// A group of edits. Unless keep() is called they are undone when it ends, as if they had not been made:
///
///   auto group = world.edit();
///   if (!world.remove(door) || !world.add(cell, wall, kStone)) return;  // all is as it was
///   group.keep();
///
/// A commit within the group keeps what was edited before it, and ends the group: what follows is not undone.
class Transaction {
 public:
  explicit Transaction(World& world) : world_(&world), mark_(world.checkpoint()) {}
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;

  void keep();

 private:
  World* world_;
  Mark mark_;
};

inline Transaction World::edit() { return Transaction(*this); }

/// The whole cell as a polygon, for shape().
inline constexpr std::array<LocalPoint, 4> kUnitSquare{
    {{0, 0}, {kUnitsPerCell, 0}, {kUnitsPerCell, kUnitsPerCell}, {0, kUnitsPerCell}}};

}  // namespace lgs
