// What <lgs/ground.h> is made of and set up by: options, rocks as values, the shelf, drawings, and what it does where
// there is no physics engine.
#pragma once

#include <lgs/brush.h>
#include <lgs/falling.h>
#include <lgs/islands.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <vector>

namespace lgs {

/// Ground that came loose, and is not ground again: as a value.
struct Rock {
  Body ground;             ///< what it is made of
  Placing placing;         ///< how it lies
  DoublePoint velocity{};  ///< of its centre of mass, in cells a second
  double spin = 0;         ///< radians a second, counter-clockwise
};

/// Where chunks are that are not in memory: a map, a file, a folder. A later put() takes the place of an earlier one.
struct Shelf {
  ChunkSink put;  ///< a chunk leaves
  /// What put() got last for the chunk with this lower-left cell; nothing, if there is none.
  std::function<std::optional<std::vector<std::byte>>(Cell corner)> get;
};

/// A shelf in memory.
[[nodiscard]] Shelf shelfInMemory();

/// How a Ground is made.
struct GroundOptions {
  IsAnchor isAnchor;              ///< what holds an island; empty: nothing ever falls
  AtEdge atEdge = AtEdge::holds;  ///< with `open`, what no anchor in memory holds falls at the edge of memory
  PreserveRelation preserve{};    ///< of its world
  StayingBlocks staying{};        ///< what dig() and paint() go around
  /// Makes the land of a chunk that was never loaded, with edits inside its cells alone, in a world of its own: the
  /// same for the same chunk, whenever it is called. What strokes have made in the chunk before stays: polygons of the
  /// land that would overlap it are left out. Empty: there is none but what the game edits.
  std::function<void(World& land, const CellRect& chunk)> land{};
  Shelf shelf = shelfInMemory();  ///< where chunks outside of the window are
  /// How many chunks window() makes, brings in and takes out in one call, at least one: so a game spreads over several
  /// frames what takes most of one. It then calls window() in each frame, and before it begins until that is true.
  std::size_t chunksAtOnce = std::numeric_limits<std::size_t>::max();
  std::size_t undoSteps = 64;  ///< how many strokes can be undone
  /// How many polygons of a rock that rests step() makes ground in one call, at least one. A larger rock takes several
  /// frames, in which its body stands still.
  std::size_t settleAtOnce = 64;
  /// Is notified of each commit, roll-back and redo: for further views, or the server of addons/sync. After a
  /// load() the game begins them again.
  std::function<void(const World& world, const Changes& changes)> follow{};
};

/// What there is to draw in a square of cells; nothing, if it became empty. Positions are in cells of the world.
struct GroundDrawing {
  /// A polygon of the ground, counter-clockwise.
  struct Fill {
    Block block = 0;                   ///< of what it is
    std::vector<DoublePoint> corners;  ///< at least 3; not always convex
  };
  /// A piece of the outline. The solid is on the left.
  struct Line {
    Block block = 0;    ///< of what it is
    DoublePoint start;  ///< from here
    DoublePoint end;    ///< to there
  };
  CellRect cells;           ///< the square, by which a game keeps what it drew
  std::vector<Fill> fills;  ///< all of them
  std::vector<Line> lines;  ///< all of them
};

/// What a square of a world looks like. Cost: in proportion to what is in it.
[[nodiscard]] GroundDrawing drawingOf(const World& world, const CellRect& cells);

/// What a rock looks like, in cells from the origin of its body: a game draws it where that is, turned as it is.
[[nodiscard]] std::vector<GroundDrawing::Fill> fillsOf(const Body& rock);

/// Squares that look different since they were drawn.
class ChangedSquares {
 public:
  void note(Cell cell);                   ///< a cell changed
  void note(const World& world);          ///< all of a world did
  void noteSides(const CellRect& chunk);  ///< what is beside them may look different
  /// What is not in memory may have changed, by an undo: then the outline beside it did, in a window, and no cell is
  /// named for it.
  void noteBesideUnloaded(const World& world, const CellRect& window);
  /// Forgets them.
  [[nodiscard]] std::vector<GroundDrawing> draw(const World& world);

 private:
  static constexpr std::int32_t kSide = 8;
  std::set<Cell> corners_;
};

/// Whether a rock lies and moves as Box2D can take it: its origin is in the range of cells, velocity and spin are
/// less than 10^9; cosine and sine are a rotation.
[[nodiscard]] bool isSound(const Rock& rock);

/// The bytes of a rock, behind what is in `out`.
void putRock(std::vector<std::byte>& out, const Rock& rock);

/// A rock from the beginning of bytes, which are left out then. Nothing, if these are not the bytes of one: it is
/// sound, and a world can hold its polygons.
[[nodiscard]] std::optional<Rock> takeRock(std::span<const std::byte>& bytes);

/// What a save of a Ground holds.
struct LoadedGround {
  World world;              ///< only the chunks of the window are in memory, the others on the shelf
  std::vector<Rock> rocks;  ///< those in the air
  std::vector<Cell> land;   ///< chunks whose land was made, by their lower-left cells
};
/// Writes all chunks of a world, those in memory and those on the shelf. See Ground::save().
Expected<void> saveGround(World world, const Shelf& shelf, const std::vector<Rock>& rocks,
                          const std::vector<Cell>& land, const ByteSink& sink);
/// Reads that; nothing, if these are not the bytes of a save. See Ground::load().
[[nodiscard]] std::optional<LoadedGround> loadGround(std::span<const std::byte> bytes, const PreserveRelation& preserve,
                                                     const CellRect& window, const Shelf& shelf);

/// A rock that becomes ground in several frames.
class RockInParts {
 public:
  /// Of `rock` so many polygons are put at once, as `placing` says; refused: as by partsAsTheyLie().
  static Expected<RockInParts> of(Rock rock, const Placing& placing, std::size_t polygonsAtOnce);

  std::size_t count() const { return parts_.size(); }  ///< of its parts
  const Rock& whole() const { return rock_; }          ///< as it lay
  Rock rest(std::size_t from) const;                   ///< what the parts from this one on are, as they will lie
  Point min() const { return min_; }                   ///< of its box, as it will lie
  Point max() const { return max_; }                   ///< the same
  bool isNear(Point min, Point max) const;             ///< whether that box meets this one
  CellRect chunks() const;                             ///< the chunks in which it becomes ground
  /// Puts parts, as one edit. Refused: as by putPart().
  Expected<void> put(World& world, std::size_t from, std::size_t to) const noexcept;

 private:
  Rock rock_;
  Placing placing_;
  std::size_t atOnce_ = 1;
  std::vector<std::vector<LyingBlock>> parts_;
  Point min_, max_;
};

/// What a Ground does where there is no physics engine: rocks are values, and the game moves them.
class NoPhysics {
 public:
  using Handle = std::uint32_t;  ///< names a rock, from 1 on; what is value-initialised names none

  /// The world must outlive it and stay where it is.
  explicit NoPhysics(World& world) noexcept : world_(world) {}

  /// How a rock lies, to be moved; it must be there.
  Rock& rock(Handle handle) { return rocks_.at(handle); }

  // What a Ground needs of a physics engine; every host has these.

  static bool isThere() { return true; }                     ///< whether there is still a physics engine
  static bool isSame(Handle a, Handle b) { return a == b; }  ///< whether both name the same body
  void show(const Changes& /*changes*/) {}                   ///< after each commit and roll-back
  void showAll() {}                                          ///< after a load
  Handle make(const Rock& rock);                             ///< a body for a rock; null, if there can be none
  Rock read(Handle handle) { return rocks_.at(handle); }     ///< where it is now
  /// How it would become ground. Refused, where it does not fit.
  Expected<Placing> placingOf(Handle handle) { return rocks_.at(handle).placing; }
  void hold(Handle /*handle*/) {}                  ///< it stands still from now on, and is in no one's way
  bool lies(Handle /*handle*/) { return false; }   ///< whether it is at rest
  bool isHeld(Handle /*handle*/) { return true; }  ///< whether it would not fall again, as far as that is known
  /// Puts it into the ground, as an edit; its body goes. Refused: overlap, where ground is in its way, by more than a
  /// hundredth of a cell along its sides; as by put() and putAsItLies().
  Expected<void> settle(Handle handle);
  void destroy(Handle handle) { rocks_.erase(handle); }  ///< its body goes
  bool dropGone() { return false; }  ///< forgets rocks whose bodies the game destroyed; whether there were any
  bool has(Handle handle) const { return rocks_.contains(handle); }  ///< whether it is that of a rock
  void window(const CellRect& /*cells*/) {}  ///< before the sync: of these chunks those are in memory that are loaded
  void beforeStep() {}                       ///< see Ground::step()
  void afterStep() {}                        ///< see Ground::step()

 private:
  World& world_;
  std::map<Handle, Rock> rocks_;
  Handle last_ = 0;
};

}  // namespace lgs
