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
//
// Every function is noexcept. When memory runs out the program ends, so no world is ever left half changed; and so it
// ends if a function that the world was given (a relation, an executor, a visitor, a sink) throws.
#pragma once

#include <lgs/error.h>
#include <lgs/ids.h>
#include <lgs/lattice.h>
#include <lgs/limits.h>
#include <lgs/placed.h>
#include <lgs/questions.h>
#include <lgs/segment.h>
#include <lgs/snapshot.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace lgs {

/// Whether the overlap between polygons of these two blocks is kept (true) or cancelled (false). The smaller block
/// always comes first, so any function gives a symmetric relation. It must give the same answer every time, throw
/// nothing and not call back into the world. If it is empty, everything is cancelled.
using PreserveRelation = std::function<bool(Block, Block)>;

/// Calls job(0) … job(count − 1), each exactly once, in any order and on any threads. Returns when all of them have
/// returned. So the application lends its own threads to a commit, which may call it several times; `count` may be 0.
/// With C++20 alone:
///
///   lgs::Executor twoThreads = [](std::size_t count, const std::function<void(std::size_t)>& job) {
///     std::atomic<std::size_t> next = 0;
///     const auto work = [&] { for (std::size_t k; (k = next++) < count;) job(k); };
///     std::jthread other(work);
///     work();
///   };
using Executor = std::function<void(std::size_t count, const std::function<void(std::size_t)>& job)>;

/// Whether World::rollBack() keeps what it undoes, so that World::redo() can bring it back.
enum class Undone : std::uint8_t { drop, keep };

/// How much there is in a world: see World::stats().
struct Stats {
  std::uint64_t polygons = 0;  ///< placed ones
  std::uint64_t cells = 0;     ///< cells that hold at least one polygon
  std::uint64_t segments = 0;  ///< live ones, as of the last commit
  std::uint64_t shapes = 0;    ///< made so far
  std::uint64_t contents = 0;  ///< distinct contents of cells; those that no cell has are forgotten in time
  std::uint64_t chunks = 0;    ///< of 32×32 cells, ever touched by an edit, and not forgotten
  std::uint64_t bytes = 0;     ///< allocated, with spare capacity; an estimate for unloaded chunks
};

class Transaction;

/// Cells that hold polygons, and the segments of their outline. The comment at the top of this file has an example.
class World {
 public:
  /// An empty world. Without a relation, whatever two polygons share is cancelled.
  explicit World(PreserveRelation preserve = {}, Handles = {}) noexcept;
  ~World() noexcept;
  /// A copy has the same polygons, handles, shapes, segments, marks and edits that are not committed. From then on the
  /// same edits give the same ids and lists in both. Cost: in proportion to the world.
  World(const World&) noexcept;
  World& operator=(const World&) noexcept;
  World(World&&) noexcept;  ///< a world that was moved from can only be assigned to or destroyed
  World& operator=(World&&) noexcept;

  // --- Shapes -------------------------------------------------------------------------------------------------------

  /// Validates and stores one polygon, or a set of polygons with disjoint interiors. Returns the id. Each must be
  /// simple, run counter-clockwise, have a positive area and be inside the closed cell. The same polygons, vertex by
  /// vertex, give the same id. A shape is never forgotten. Refused: emptyShape, and what error.h lists from
  /// tooFewVertices to overlap. Cost: a hash; the first time O(n log n) for one polygon, O(n²) for several or for one
  /// that is refused.
  [[nodiscard]] Expected<ShapeId> shape(std::span<const LocalPoint> polygon) noexcept;
  [[nodiscard]] Expected<ShapeId> shape(std::initializer_list<LocalPoint> polygon) noexcept;
  [[nodiscard]] Expected<ShapeId> shape(std::span<const FloatPoint> polygon) noexcept;
  [[nodiscard]] Expected<ShapeId> shape(std::span<const DoublePoint> polygon) noexcept;
  [[nodiscard]] Expected<ShapeId> shape(std::span<const std::vector<LocalPoint>> polygons) noexcept;

  /// Returns the polygons of a shape, in its order. Valid until the next shape is made. Refused: unknownShape.
  Expected<std::vector<std::span<const LocalPoint>>> polygonsOf(ShapeId shape) const noexcept;

  /// Returns the least box around the polygons of a shape. Refused: unknownShape. Cost: it looks at each vertex.
  Expected<LocalBox> boundingBox(ShapeId shape) const noexcept;

  // --- Edits --------------------------------------------------------------------------------------------------------

  /// Places every polygon of a shape in a cell, all with this block. Returns the handle of the shape's first polygon.
  /// Refused: cellOutOfRange, unloaded, unknownShape, overlap, capacity. Cost: O(1) in a cell that is empty.
  [[nodiscard]] Expected<PolygonHandle> add(Cell cell, ShapeId shape, Block block) noexcept;

  /// The same. `handles` receives the handles of all polygons in the shape's order, or as many as it has room for.
  [[nodiscard]] Expected<PolygonHandle> add(Cell cell, ShapeId shape, Block block,
                                            std::span<PolygonHandle> handles) noexcept;

  /// The same for a polygon given by its vertices, which is also refused as by shape(). If it was seen before this
  /// costs a hash, otherwise it is validated.
  [[nodiscard]] Expected<PolygonHandle> add(Cell cell, std::span<const LocalPoint> polygon, Block block) noexcept;
  [[nodiscard]] Expected<PolygonHandle> add(Cell cell, std::initializer_list<LocalPoint> polygon, Block block) noexcept;
  [[nodiscard]] Expected<PolygonHandle> add(Cell cell, std::span<const FloatPoint> polygon, Block block) noexcept;
  [[nodiscard]] Expected<PolygonHandle> add(Cell cell, std::span<const DoublePoint> polygon, Block block) noexcept;

  /// Places many shapes, each as add() would, one after the other: all of them or none. `handles` receives what add()
  /// would return for each, or as many as it has room for; null handles, if an entry is refused. Refused as by add(),
  /// and Error::index names which one; if it overlaps an earlier one, index2 names which. Refused without an index:
  /// capacity, if there are more than kMaxEntries. Cost: as of single edits; or as of those while there is a mark, if a
  /// cell is not empty or a shape has several polygons.
  [[nodiscard]] Expected<void> addMany(std::span<const Placement> placements,
                                       std::span<PolygonHandle> handles = {}) noexcept;

  /// Removes one polygon. Refused: staleHandle; unloaded; capacity, if what is left in the cell would be a content too
  /// many.
  [[nodiscard]] Expected<void> remove(PolygonHandle polygon) noexcept;

  /// Removes many polygons: all of them or none. Refused as by remove(), and Error::index names which one; so for a
  /// handle that comes twice, and index2 is where it was first. Refused without an index: capacity, if there are more
  /// than kMaxEntries. Cost: as of addMany().
  [[nodiscard]] Expected<void> removeMany(std::span<const PolygonHandle> polygons) noexcept;

  /// Puts a shape in the place of all polygons of a cell, which may be empty: both happen, or neither. Returns the
  /// handle of the shape's first polygon; `handles` is as for add(). Refused: as by add(), but never for overlap.
  [[nodiscard]] Expected<PolygonHandle> replace(Cell cell, ShapeId shape, Block block,
                                                std::span<PolygonHandle> handles = {}) noexcept;

  /// Takes some polygons of a cell away and places others: all of it, or nothing. The others of the cell stay.
  /// `handles` receives the handles of `added`, or as many as it has room for. Only what stands in the cell at the end
  /// must fit: nothing is worked out for the steps on the way. Refused: cellOutOfRange; unloaded; staleHandle, for a
  /// handle that is not of this cell or comes twice, and Error::index names which; as by shape(), and by add() for what
  /// stays. Cost: as of one add().
  [[nodiscard]] Expected<void> exchange(Cell cell, std::span<const PolygonHandle> removed,
                                        std::span<const NewPolygon> added,
                                        std::span<PolygonHandle> handles = {}) noexcept;

  /// Gives a polygon another block. It keeps its handle and its place. The next commit removes its segments and adds
  /// them again, as another block is another owner; all others keep their ids. Refused: staleHandle; unloaded;
  /// capacity, if a preserve relation makes one content too many of the cell.
  [[nodiscard]] Expected<void> setBlock(PolygonHandle polygon, Block block) noexcept;

  /// Places a shape in every cell of a rectangle, or in none. Returns the number of cells. Refused as add() would be
  /// for the first cell, by rows from `min`, that add() would refuse; but cellOutOfRange names a corner of the
  /// rectangle that is out of range, and capacity names `min` if the rectangle reaches more chunks than the world has
  /// room for. An empty rectangle is no error. `handles` receives the handle of the shape's first
  /// polygon in each cell, by rows from `min`, or as many as it has room for.
  [[nodiscard]] Expected<std::uint64_t> fill(const CellRect& cells, ShapeId shape, Block block,
                                             std::span<PolygonHandle> handles = {}) noexcept;

  /// Removes every polygon in every cell of a rectangle. Returns the number of polygons removed. Refused:
  /// cellOutOfRange, with a corner of the rectangle that is out of range; unloaded, with the first such cell.
  /// (`clear({3, 4})` is of a cell: a template comes after what is none.)
  template <std::same_as<CellRect> Rect = CellRect>
  Expected<std::uint64_t> clear(const Rect& cells) noexcept {
    return clearRect(cells);
  }
  Expected<std::uint64_t> clear(Cell cell) noexcept { return clearRect({cell, cell}); }  ///< the same for one cell

  /// Begins a group of edits that happens as a whole or not at all. Returns the group: it is undone unless kept.
  [[nodiscard]] Transaction edit() noexcept;

  /// Brings the segments up to date with all edits since the last commit. Returns what changed, valid until the next
  /// commit or roll-back. Cost: in proportion to the contents of the edited cells and of the eight around each.
  /// Allocates nothing once the world has reached its size.
  const Changes& commit() noexcept;

  /// The same to the last id and its place in the lists, on the executor's threads if the world has no segments yet, as
  /// in its first commit. Then there is most work to spread. Any other commit is as above, and so is one with an empty
  /// executor. On threads the preserve relation is called from several of them at a time. A job is the work on a chunk
  /// of 32×32 cells, and throws nothing. Allocates working memory in proportion to the cells with segments.
  const Changes& commit(const Executor& executor) noexcept;

  // --- Marks, roll-back, redo ---------------------------------------------------------------------------------------
  //
  // Law 12, restore and replay is never having left: once the world is at a mark again, every later output, id and list
  // is as if the edits and commits after the mark had not been made. So handles, shapes and segment ids that were given
  // out after it name nothing until they are given out again. While there are marks an edit costs some more, however
  // much was edited before it, and what is needed to undo it is kept: memory in proportion to the cells and segments
  // that changed since the oldest mark, each counted once between two marks. What a shape that was made after the mark
  // holds stays in memory.

  /// Notes this moment, and returns the mark. Edits may be pending. A mark is for this world and its later copies; no
  /// other world of this process ever makes the same one. Its number means nothing else, and differs from run to run.
  /// Cost: O(1); while edits are pending, in proportion to the chunks that they are in.
  [[nodiscard]] Mark mark() noexcept;

  /// Rolls back to a mark. The mark stays, so that the world can roll back to it again; later ones are invalidated.
  /// changesOfRollBack() then returns what this did to the segments. Refused: unknownMark. Cost: in proportion to the
  /// edits since the mark.
  ///
  /// With Undone::keep the later marks are *ahead*: redo() leads there. A game that makes a mark at its begin and after
  /// each commit of a player's undoes and redoes so; docs/guide.md has the lines.
  ///
  /// What is kept takes memory as long as it can be redone: until the world rolls back further without keeping, rolls
  /// back with keeping after an edit or another mark, or has no mark left from before.
  [[nodiscard]] Expected<void> rollBack(Mark mark, Undone undone = Undone::drop) noexcept;

  /// Redoes up to a mark that is ahead, as if the world had not rolled back beyond it: the edits and commits up to it
  /// come back with their handles, shapes and segment ids. Marks made since the roll-back are invalidated; those
  /// further ahead stay ahead. changesOfRollBack() then returns what this did to the segments. Refused: unknownMark, if
  /// the mark is not ahead, or if something was edited, or a shape made, since the roll-back or redo (and that was not
  /// undone), or made a chunk, and was undone while this chunk was unloaded, and the edits that come back make chunks,
  /// too. Commits, other chunks that leave memory and come back, and groups that were not kept do no harm. Cost: as of
  /// rollBack().
  [[nodiscard]] Expected<void> redo(Mark mark) noexcept;

  /// What the last rollBack() or redo() did to the segments, after all commits before it: the three lists
  /// of a commit, by id. One thing is different: an id that named one segment and names another one now is removed, and
  /// then added.
  const Changes& changesOfRollBack() const noexcept;

  /// Releases a mark. Other marks stay. Refused: unknownMark, also for a mark ahead, and for one that was ahead when
  /// something was edited. Cost: in all, O(log n) for each cell and segment that is kept for a roll-back.
  Expected<void> forget(Mark mark) noexcept;

  // --- Leaving places -----------------------------------------------------------------------------------------------

  /// Releases a place that the game has left. Each chunk of 32×32 cells that lies in the rectangle as a whole and
  /// holds no polygon gives its memory back; and so does each unloaded one that had no loaded chunk around it at the
  /// last commit, unless a roll-back or redo changed it since it was unloaded, for then its bytes are not what it
  /// holds. Other chunks, and those that lie in the rectangle in part, stay as they are. Returns how many chunks were
  /// forgotten. An empty rectangle is no error.
  ///
  /// All handles that were ever given out for cells of these chunks are *invalidated*: drop them. They name nothing,
  /// until they are given out again, maybe for another place: what comes next is as if no edit had ever been there.
  /// Segments and their ids, shapes, all other handles, and later outlines are not touched, so nothing has to follow.
  /// In a world that is saved, loaded or copied the same chunks are forgotten (law 12).
  ///
  /// Refused: cellOutOfRange, with a corner of the rectangle that is out of range; uncommitted, while edits are not
  /// committed or there are marks, since those may need the chunks. A game that always has marks forgets the chunks at
  /// a moment to which it does not roll back: it lets go of its marks, forgets, and makes a new one. Cost: in
  /// proportion to the cells of the chunks in the rectangle, and to the chunks in the rectangle or in the world,
  /// whichever are fewer.
  [[nodiscard]] Expected<std::uint64_t> forgetChunks(const CellRect& cells) noexcept;

  // Chunks leave memory with unload(), and come back with reload() or reloadEmpty(). The next commit reports which
  // segments were removed, added and relinked.
  //
  // Being in memory is no edit. Roll-back and redo change what the ground is, loaded or not, and load or unload
  // nothing: so a game streams as it likes while the player can undo and redo. The bytes that unload() gave last stay
  // good. What a roll-back changes in an unloaded chunk is kept here, and is there when it is loaded: 12 bytes for each
  // of its cells that was edited since the oldest mark. Where no edits are pending at the mark, changesOfRollBack() has
  // what was loaded and unloaded since the mark, too; otherwise the next commit has it, with these edits. An edit that
  // is not kept, as a group, is undone in the same way. Two things are edits, are undone and end the redo like all
  // others: ground that a game makes, and bytes for a place where no chunk is.
  //
  // Law 14, unloaded is not gone: what is loaded shows the segments and ghosts that it has in the whole world. So no
  // wall appears where the loaded world ends. For that the outermost cells of an unloaded chunk stay known. They take
  // 12 bytes for each row of equal ones among these 124, and some 150 more.
  //
  // In an unloaded chunk every edit is refused (ErrorCode::unloaded); so are handles of its polygons, and they are
  // valid again when it is back from its bytes. Questions that would have to look there return that. Whatever lists or
  // counts polygons or segments leaves it out. A segment may have a predecessor or a successor in it: the ghost is as
  // ever, and reading that segment is refused as unloaded. A place where no chunk ever was is empty. To have it be
  // unknown, put something there, remove it and unload the chunk: then questions and edits there return unloaded, and
  // the ground beside it ends as at empty space; without removing it, as at what was put there.

  /// Chunks of 32×32 cells leave memory: those that are loaded and lie in the rectangle as a whole, by rows. `sink`
  /// gets the bytes of each: its polygons, blocks and handles, as they are after all edits, committed or not. Returns
  /// how many chunks these are. Refused:
  /// cellOutOfRange, with a corner of the rectangle that is out of range. Cost: in proportion to the cells of these
  /// chunks.
  [[nodiscard]] Expected<std::uint64_t> unload(const CellRect& cells, const ChunkSink& sink) noexcept;

  /// A chunk comes back as it was, to the last handle; but for what a roll-back or redo changed since. Returns its
  /// lower-left cell. `chunk` is what unload() gave last for this chunk; where there is no chunk, as after
  /// forgetChunks(), it may be what any world gave that has the same preserve relation, and the handles are new. Bytes
  /// that are cut, damaged or made up are refused, as by load(). Cost: in proportion to the cells of the chunk, and
  /// quadratic in the vertices of each content of a cell that is new.
  [[nodiscard]] tl::expected<Cell, SnapshotError> reload(std::span<const std::byte> chunk) noexcept;

  /// The unloaded chunks that lie in a rectangle as a whole come back, and are empty: for a game that makes their
  /// ground again, with edits, before the next commit. What they held is given up at all marks, too: a roll-back finds
  /// them empty. Handles from before name nothing, and are never given out again. Returns how many chunks these are.
  /// Refused: cellOutOfRange, with a corner of the rectangle that is out of range. Cost: in proportion to the cells of
  /// these chunks, and of each to what is kept for a roll-back.
  [[nodiscard]] Expected<std::uint64_t> reloadEmpty(const CellRect& cells) noexcept;

  /// The first cell of a rectangle that is unloaded, by rows from `min`; nothing if none is. Cost: O(log n), and for
  /// each row of chunks of the rectangle up to there, of those that have unloaded ones.
  std::optional<Cell> firstUnloaded(const CellRect& cells) const noexcept;

  // --- Following the ground -----------------------------------------------------------------------------------------
  //
  // A *view*, which keeps something up to date that follows from the polygons, reads all of them once
  // by forEachPolygon(), and from then on what each commit and roll-back changed. For views of the outline there are
  // commit() and changesOfRollBack().

  /// Whether cellChanges() is kept from now on; a new world does not keep it. A copy follows as its original does. A
  /// loaded world follows nothing yet. Refused: uncommitted, while edits are not committed or there are marks. Cost of
  /// the call: O(1). While a world follows, edits cost what they cost while there is a mark; and a commit reads the
  /// edited cells, which takes time and memory in proportion to their polygons and vertices, before and now.
  [[nodiscard]] Expected<void> followCells(bool follow) noexcept;
  /// Whether it is kept.
  bool followsCells() const noexcept;
  /// Whether something was edited, unloaded or reloaded since the last commit, or a roll-back came to a moment when
  /// edits were pending: what follows from the outline is not what follows from the polygons then.
  bool hasUncommitted() const noexcept;

  /// The cells that the last commit, rollBack() or redo() changed, each once, in the order of their first
  /// change; one edit of several cells changes them in any order. After a commit these are the cells edited since the
  /// commit or roll-back before, and those of chunks that left memory or came back: empty after, or before. A chunk of
  /// which no other cell is named is named by one that is empty both times. After a roll-back these are the cells that
  /// were edited, and committed, since the last commit before the mark; `now` is as of that commit, and edits that were
  /// pending at the mark are reported by the next commit. So it is after redo(), with what comes back. A cell is
  /// named even if it holds again what it held, but not in a chunk out of memory, where a roll-back changes the ground,
  /// too. Empty if nothing is followed, or nothing changed. Valid until the next edit, commit or roll-back. Cost: O(1).
  std::span<const CellChange> cellChanges() const noexcept;
  /// The version of the ground before these changes. A view that knows another one has missed some.
  std::uint64_t versionBeforeCellChanges() const noexcept;

  // --- Saving -------------------------------------------------------------------------------------------------------

  /// Writes the world as bytes: polygons, handles, shapes and segment ids. Marks are not written, nor is the preserve
  /// relation, which is a function. Refused: uncommitted; unloaded, with the first such cell. Cost: in proportion to
  /// the world. Full blocks take less than a byte for each cell, ramps some four.
  [[nodiscard]] Expected<void> save(const ByteSink& sink) const noexcept;

  /// The world that was saved. It goes on exactly: the same edits give the same ids and lists as if it had never been
  /// saved (law 12). It has no marks. `snapshot` is what save() wrote and nothing more: a file with more in it stores
  /// how long this part is. `preserve` must be the relation that it was saved with, or empty if it had none. Bytes that
  /// are cut, damaged or made up are refused; they take no more memory than a constant for each byte. Cost: in
  /// proportion to the world, and quadratic in the vertices of each content of a cell that has several polygons, as
  /// shape() is.
  [[nodiscard]] static tl::expected<World, SnapshotError> load(std::span<const std::byte> snapshot,
                                                               PreserveRelation preserve = {}) noexcept;

  // --- Reading ------------------------------------------------------------------------------------------------------

  /// The polygons of a cell, after all edits, committed or not. A cell out of range, or of an unloaded chunk, holds
  /// none: firstUnloaded() distinguishes these.
  std::vector<PlacedPolygon> polygons(Cell cell) const noexcept;
  void polygons(Cell cell,
                std::vector<PlacedPolygon>& out) const noexcept;  ///< the same, replacing the content of `out`

  /// Whether a cell holds no polygon that is in memory. A cell out of range, or of an unloaded chunk, holds none.
  bool isEmpty(Cell cell) const noexcept;

  /// Calls visit(cell, polygon) for every placed polygon, those inside the ground too: chunk by chunk, in the order in
  /// which edits first reached the chunks (a new one takes the place of a forgotten one); each by rows, each cell by
  /// handle. The second form visits the cells of a rectangle, and chunks in any order. `visit` must not change the
  /// world; if it is empty, nothing is called. Cost: in proportion to the cells that have a chunk.
  using PolygonVisitor = std::function<void(Cell, const PlacedPolygon&)>;
  /// See PolygonVisitor.
  void forEachPolygon(const PolygonVisitor& visit) const noexcept;
  void forEachPolygon(const CellRect& cells, const PolygonVisitor& visit) const noexcept;

  /// The least rectangle of cells with all placed polygons; nothing in an empty world. Cost: as of forEachPolygon().
  std::optional<CellRect> bounds() const noexcept;

  /// Returns the polygon of a handle, after all edits, committed or not. Refused: staleHandle; unloaded.
  Expected<PlacedPolygon> polygon(PolygonHandle handle) const noexcept;
  /// Returns the cell of a polygon. Refused: staleHandle; unloaded.
  Expected<Cell> cellOf(PolygonHandle handle) const noexcept;

  /// Returns a segment as of the last commit. Its `polygon` is stale if that was removed since. Refused: unknownSegment;
  /// unloaded.
  Expected<Segment> segment(SegmentId id) const noexcept;

  /// Many segments: out[k] is that of ids[k], for as many as `out` has room for. The others give them in cells from an
  /// origin: differences are exact before they are rounded, and `double` is exact. Refused: unknownSegment or unloaded,
  /// where Error::index names which one, and what comes before it is in `out`; outOfReach, if the origin is out of
  /// range; capacity, if these are more than kMaxEntries.
  Expected<void> segments(std::span<const SegmentId> ids, std::span<Segment> out) const noexcept;
  Expected<void> segments(std::span<const SegmentId> ids, Point origin, std::span<FloatSegment> out) const noexcept;
  Expected<void> segments(std::span<const SegmentId> ids, Point origin, std::span<DoubleSegment> out) const noexcept;

  /// The ids of all segments, in increasing order.
  std::vector<SegmentId> segments() const noexcept;

  /// The ids of the segments of polygons in these cells, in no particular order. Cost: in proportion to the cells there
  /// that have a chunk.
  std::vector<SegmentId> segments(const CellRect& cells) const noexcept;

  /// The closed chains, sorted by their vertices. Under a preserve relation only those whose links are all mutual.
  std::vector<Loop> loops(Collinear collinear = Collinear::keep) const noexcept;

  // --- Questions about places: questions.h has the answers --------------------------------------------------------

  /// Which polygon is at a point, after all edits, committed or not. A point out of range is outside. Cost: in
  /// proportion to the vertices in the cell; on a common side in both cells, in a corner in all four.
  Spot at(Point point) const noexcept;

  /// The segment nearest to a point, as of the last commit, at most `radius` cells away, rounded to the lattice. Of
  /// several at the same distance the least by start, end and block. Refused: outOfReach, if the point is out of range
  /// or the radius is not from 0 to kMaxRadius; unloaded, if it would have to look into an unloaded cell. Cost: in
  /// proportion to the cells with a chunk within twice the distance found, or within the radius.
  Expected<Nearest> nearest(Point point, double radius) const noexcept;

  /// Returns the first segment that a ray meets on its outward side, as of the last commit. A ray that starts in a solid leaves
  /// it without a hit. One that runs along a segment does not hit it. The ends of a segment count. Of several at the
  /// same place the least by start, end and block. Refused: outOfReach, if an end is out of range or the ray is longer
  /// than kMaxRay cells on an axis; unloaded, with the first unloaded cell that it meets before a hit. Cost: in
  /// proportion to the cells that the ray touches, up to the hit.
  Expected<RayHit> rayCast(Point from, Point to) const noexcept;

  /// The relation that the world was made with; empty if it preserves nothing.
  const PreserveRelation& preserveRelation() const noexcept;

  /// The version of the ground and its segments, as of the last commit. Each commit that finds an edit, or a chunk that
  /// left memory or came back, makes a new one, and no world of this process ever makes the same one. A copy has the
  /// version of its original, until one of them changes. rollBack() brings back that of the mark, unless chunks left or
  /// came back since. A loaded world has a new one. Versions mean nothing else: the same edits make other ones in another
  /// run, and law 12 does not hold for them.
  std::uint64_t version() const noexcept;

  /// The highest SegmentId::value in use so far: an array for what you know of segments needs one place more. Only
  /// rollBack() lowers it, and changesOfRollBack().removed then names higher ones.
  std::uint32_t maxSegmentId() const noexcept;

  /// Counts what there is. Cost: it looks at every cell of every chunk.
  Stats stats() const noexcept;

  struct Impl;  ///< of the implementation

 private:
  friend class Transaction;
  friend bool samePolygons(const World& a, const World& b) noexcept;
  Expected<std::uint64_t> clearRect(const CellRect& cells) noexcept;
  std::unique_ptr<Impl> impl_;
};

/// Whether two worlds hold the same polygons with the same blocks in the same cells, after all edits, committed or not.
/// It does not matter with which vertex a polygon begins, nor which handles, shapes, ids, marks and relations the
/// worlds have. Cost: in proportion to the cells that have a chunk.
bool samePolygons(const World& a, const World& b) noexcept;

/// A group of edits. They are undone when it ends, as if they had not been made, unless keep() is called:
///
///   auto group = world.edit();
///   if (!world.remove(door) || !world.add(cell, wall, kStone)) return;  // all is as it was
///   group.keep();
///
/// A commit keeps what was edited before it, and ends the group: what follows is not undone. A commit that finds
/// nothing to do, since after the commit before it no cell was edited and no chunk left memory or came back, ends no
/// group. Roll-back or redo, to a mark made within the group, shows such chunks at once: then it ends the group, as
/// that commit would. The world must not be moved, assigned to or destroyed before the group ends. A copy of it has the
/// edits made so far, and no group.
class Transaction {
 public:
  /// Begins the group: World::edit() does it. The world must outlive it.
  explicit Transaction(World& world) noexcept;
  ~Transaction() noexcept;
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;

  void keep() noexcept;  ///< ends the group: its edits stay

 private:
  World* world_;
  Mark mark_;
};

inline Transaction World::edit() noexcept { return Transaction(*this); }

/// The whole cell as a polygon, for shape().
inline constexpr std::array<LocalPoint, 4> kUnitSquare{
    {{0, 0}, {kUnitsPerCell, 0}, {kUnitsPerCell, kUnitsPerCell}, {0, kUnitsPerCell}}};

}  // namespace lgs
