// What a terrain is for every Box2D. Include <lgs/box2d/terrain.h>, which has the rest and an example. What Body, Shape
// and Position are <lgs/box2d/physics.h> says: b2Body, b2Fixture and b2Vec2 in Box2D 2.4, ids and b2Pos in 3.
#pragma once

#include <lgs/box2d/edges.h>
#include <lgs/box2d/hit.h>
#include <lgs/box2d/known_bodies.h>
#include <lgs/box2d/materials.h>
#include <lgs/box2d/physics.h>

#include <concepts>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace lgs::box2d {

class Footings;
class NewGround;
struct Box;
struct Footing;
struct Form;
struct LocalEdge;
struct Pose;
enum class Whose;

/// The options of a terrain, with the material of this Box2D.
using TerrainOptions = BasicTerrainOptions<Material>;

/// A contact of the terrain.
struct Touch {
  Hit hit;              ///< what was touched
  b2Vec2 normal;        ///< outward unit normal of the terrain's edge
  ShapeHandle other{};  ///< what touches it
};

/// The ground nearest to a point.
struct NearestHit {
  Hit hit;             ///< what is nearest
  Position point;      ///< its nearest point, in metres
  b2Vec2 normal;       ///< outward unit normal of the segment
  float distance = 0;  ///< metres
};

/// What a ray meets first.
struct GroundRayHit {
  Hit hit;             ///< what was hit
  Position point;      ///< where, in metres
  b2Vec2 normal;       ///< outward unit normal of the segment
  float fraction = 1;  ///< of the way from the start to the end of the ray
};

/// A body that new ground would overlap.
struct Overlap {
  BodyHandle body{};          ///< the body
  float depth = 0;            ///< metres: how deep the ground reaches into it, at most to the centre
  bool isFree = false;        ///< whether there is a path out
  b2Vec2 displacement{0, 0};  ///< along it: a straight move without a turn
};

/// What every terrain can do. Only a Terrain can be made. Every function is noexcept: when memory runs out, or a
/// function of the game's throws, the program ends.
class TerrainBase {
 public:
  TerrainBase(const TerrainBase&) = delete;
  TerrainBase(TerrainBase&&) = delete;
  TerrainBase& operator=(const TerrainBase&) = delete;
  TerrainBase& operator=(TerrainBase&&) = delete;

  /// Commits the edits of its world, and syncs. Refused: as by sync(). `world` must be the terrain's own; if it is
  /// another one, the error is `notTheLast`, and nothing is committed. After `leftOut` the world is committed.
  tl::expected<void, SyncError> commit(World& world) noexcept;

  /// Applies a commit, or what a roll-back reports. Call it once after each of them, before the next edit. Changes that
  /// are not the next ones are refused: the terrain stays as it was, and the error is the reason. After `leftOut` call
  /// resync(). After `shownAlready` there is nothing to do. After `notTheLast` call resync() unless isCurrent(). Hand
  /// on the lists as the world gave them: that none lacks an id is not checked. Cost:
  /// the number of changes, times the segments of an edge; for each body near a change, the changes that are connected
  /// with it; in Box2D 2.4 also, for each fixture that goes, the fixtures of its body, because Box2D looks for it
  /// there.
  tl::expected<void, SyncError> sync(const Changes& changes) noexcept;

  /// The same, with another `onOverlap`.
  tl::expected<void, SyncError> sync(const Changes& changes, OnOverlap onOverlap) noexcept;

  /// The same as sync(changes), where the game enabled the bodies `coming` since the last sync. They were free where
  /// they are when they were disabled, so they overlap the ground that is there now.
  tl::expected<void, SyncError> sync(const Changes& changes, std::span<const BodyHandle> coming) noexcept;

  /// The bodies that these changes would overlap. To be called after a commit or roll-back and before its sync(): so
  /// the game can roll back, or leave the rest to sync(). A body overlaps it if the centre of one of its shapes was
  /// free (law 13) and is in the solid, or if a new edge reaches deeper than half way to it. Sensors, bodies that are not dynamic or not enabled, and shapes whose filter lets them through the block
  /// do not count. Nothing, if sync() would refuse the changes. Cost: the number of changes, for each body near one of
  /// them; and up to some milliseconds for one that has no path out.
  std::vector<Overlap> overlapsWith(const Changes& changes) noexcept;

  /// Those that the last sync or resync pushed or disabled. A pushed body was moved by its displacement and woken, and
  /// has no velocity against it any more. None if they are left. A body that the game destroyed since stays in the list.
  const std::vector<Overlap>& overlaps() const noexcept { return overlaps_; }

  /// The bodies that are disabled where they overlapped, at rest. A later sync nearby enables them if they are free
  /// there, or pushes them out if their centres are. The game may destroy or enable one. They stay disabled when the
  /// terrain goes: enable them first, if they are to live on. Cost: in Box2D 2.4, if there are any, a look at each body.
  std::vector<BodyHandle> disabled() const noexcept { return disabled_.there(); }

  /// Call it before each step, when bodies are made and moved. It notes where those are that are new, or that the game
  /// has put elsewhere: from there on afterStep() guards them. Without it their first step is not guarded; and in Box2D
  /// 2.4, which uses the address of a destroyed body again, a new one may be taken for that. Cost: in Box2D 2.4 a look
  /// at each body, in 3 at each that is noted, and where bodies have come, once at each shape; World::at() for each
  /// shape of a body that is new or elsewhere. No edit may be pending: it would count, and Box2D does not have it yet.
  void beforeStep() noexcept;

  /// Call it after each step. Bodies press each other, and Box2D may press a light one through an edge. Each body whose
  /// centre got into the ground in the step, or came through, is put back to where it was free before, at rest. Those
  /// are returned. Bodies that the game itself moves into the ground come back, too. No edit may be pending, as in
  /// beforeStep(). Cost: World::at() for each shape of a body that is awake.
  const std::vector<BodyHandle>& afterStep() noexcept;

  /// Notes where one body is, as beforeStep() does, for a game that does not call that: of a body that it has made, or
  /// put elsewhere, through a portal or to where it starts again. Else that seems to have come through the ground that
  /// is between, and afterStep() puts it back. Not needed before resync(). No edit may be pending, as in beforeStep().
  void moved(BodyArgument body) noexcept;

  /// Whether the ground reaches into no shape of a body by more than Box2D's slop. No edit may be pending, as in
  /// beforeStep().
  bool fits(BodyArgument body) noexcept;

  /// Polygons around the shapes of a body that collide with edges, in lattice units of the world: for a brush. Round
  /// ones are somewhat larger.
  std::vector<std::vector<Point>> outlinesOf(ConstBodyHandle body) noexcept;

  /// Brings the terrain up to date with what its world held at its last commit, whatever was done to the world: changes
  /// were left out, or another world was assigned to it, loaded or copied. Bodies may have been moved meanwhile: bodies
  /// in the ground are pushed or disabled, however they came there; and one that is disabled and free is enabled.
  /// Shapes that are right as they are stay, and bodies on them sleep on. Cost: O(segments), and for each body near a
  /// change the changes that are connected with it.
  void resync() noexcept;

  /// Calls TerrainOptions::material again for all blocks, as what blocks are like has changed; and syncs as resync()
  /// does. The shapes of blocks that are another material now are made again, so what rests there wakes up. No body is
  /// pushed out of a block that was passable and is solid now. Cost: O(segments).
  void materialsChanged() noexcept;

  /// Whether the terrain is up to date with the last commit.
  bool isCurrent() const noexcept { return edges_.version() == world_.version(); }

  /// What a shape stands for; nothing if it is none of the terrain's. If it stands for several segments, merged or
  /// welded, this is the one nearest to a point of the physics world; without a point, the first one. Between a commit
  /// and its sync(): nothing if the commit changed those segments.
  std::optional<Hit> hit(const Shape& shape) const noexcept;
  std::optional<Hit> hit(const Shape& shape, const Position& point) const noexcept;

  /// The segment of the outline nearest to a point of the physics world, as of the last commit; nothing if none is
  /// within `radius` metres, or kMaxRadius cells, or if the point is beyond the last cell. The point may be in the
  /// solid. Segments that are too short for an edge count as well. Cost: as of World::nearest().
  std::optional<NearestHit> nearest(const Position& point, float radius) const noexcept;

  /// The first piece of the outline that a ray meets from outside, as of the last commit; nothing if it meets none, is
  /// longer than kMaxRay cells on an axis, or has an end beyond the last cell. It is exact but for its ends, which are
  /// rounded to the lattice. The ends of a segment count: a ray that grazes a corner hits it, and there may be nothing
  /// behind. `hit.cell` is that of the polygon; cellAt() of the point may be the one on the other side. A ray of Box2D
  /// leaks where segments were too short for an edge; this one does not. It looks at no filter and at no body: for what
  /// stands before the ground cast a ray of Box2D as well, and take the nearer hit. Cost: as of World::rayCast().
  std::optional<GroundRayHit> rayCast(const Position& from, const Position& to) const noexcept;

  /// The bodies that reach into a rectangle of cells, but for the terrain's; each once, in no particular order. Sensors
  /// are not looked at. overlapsWith() returns which of them new ground would overlap. Bodies that just rest beside the
  /// cells are not found: in Box2D 3 the rectangle counts as smaller by the slop, half a centimetre, on each side. In
  /// 2.4 bodies that are less than 1 cm (b2_polygonRadius) away are found, because the skin of a polygon counts. Cost:
  /// the shapes near the cells.
  template <std::same_as<CellRect> Rect = CellRect>  // so that bodiesIn({3, 4}) is of a cell
  std::vector<BodyHandle> bodiesIn(const Rect& cells) const noexcept {
    return bodiesInRect(cells);
  }
  /// The same for one cell.
  std::vector<BodyHandle> bodiesIn(Cell cell) const noexcept { return bodiesInRect({cell, cell}); }

  /// Makes the corner of another cell (0, 0) of the physics world, for a world that keeps its origin near the player.
  /// Moves the terrain's bodies. In Box2D 2.4 the game moves its own before it:
  ///
  ///   physics.ShiftOrigin(terrain.position(lgs::toWorld(cell, {})));
  ///
  /// In Box2D 3 it moves each of them, by the place that the corner had before. Where that rounded a centre into the
  /// ground, the body is moved on by some units. Cost: in proportion to the shapes and to the bodies.
  void moveOrigin(Cell origin) noexcept;

  /// The edges behind the shapes: counts, ends, ghosts. The user data of a shape are its EdgeId. The terrain needs
  /// them; do not write there.
  const EdgeSet& edges() const noexcept { return edges_; }
  std::size_t bodyCount() const noexcept { return bodyCount_; }  ///< chunks with at least one shape

  Position position(Point p) const noexcept;  ///< where a lattice point is in the physics world, in range or not
  /// The lattice point nearest to a place in the physics world; not inRange() if that is beyond the last cell. It leads
  /// from a click to a polygon: world.at(terrain.latticePoint(mouse)).
  Point latticePoint(const Position& p) const noexcept;
  /// The cell at a place in the physics world; not inRange() if that is beyond the last cell, or no number.
  Cell cellAt(const Position& p) const noexcept;

 protected:
  /// The static body that has the shapes of a chunk.
  struct ChunkBody {
    BodyHandle body{};       ///< null, while there is no shape
    std::size_t shapes = 0;  ///< how many it has
  };
  TerrainBase(Physics physics, const World& world, TerrainOptions options) noexcept;  ///< makes all shapes
  ~TerrainBase() noexcept;                                                            ///< destroys its bodies

  bool fitsAt(ConstBodyHandle body, const Pose& at);                 ///< fits(), as if the body were there
  EdgeId edgeOf(const Shape& shape) const;                           ///< null if it is none of the terrain's
  void lookAt(BodyHandle body, const std::optional<Footing>& last);  ///< afterStep() for one body that was moved

 private:
  tl::expected<void, SyncError> sync(const Changes& changes, OnOverlap onOverlap, std::span<const BodyHandle> coming);
  std::vector<BodyHandle> bodiesInRect(const CellRect& cells) const noexcept;
  bool isAlone() const;
  std::vector<Form> formsOf(ConstBodyHandle body, const Pose& at);
  b2Vec2 metres(DoublePoint units) const;
  std::vector<BodyHandle> catchableIn(const Box& box) const;
  /// The bodies at boxes that can overlap it, each once. Wakes those that reach one from the index `firstToWake` on.
  std::vector<BodyHandle> bodiesAt(std::span<const Box> boxes, std::size_t firstToWake);
  bool reachesOne(ConstBodyHandle body, std::span<const Box> boxes, std::span<const std::uint32_t> which);
  std::vector<Overlap> find(const std::vector<BodyHandle>& bodies, const NewGround& ground, Whose whose);
  void addIfOverlapping(BodyHandle body, const NewGround& ground, Whose whose, std::vector<Overlap>& overlaps);
  void settle(const std::optional<Box>& changed, OnOverlap onOverlap);
  bool release(BodyHandle body, const Box& changed);
  void push(BodyHandle body, b2Vec2 way);
  bool isFree(ConstBodyHandle body, const Pose& at);
  std::optional<Pose> freeNear(ConstBodyHandle body, const Pose& at);
  bool returnTo(BodyHandle body, const Footing& last);
  void afterRounding();
  bool hasCrossed(ConstBodyHandle body, const Footing& last);
  void noteAll();
  void note(ConstBodyHandle body);
  void noteIfElsewhere(ConstBodyHandle body);
  Footing footingOf(ConstBodyHandle body) const;
  Pose poseOf(const Footing& footing) const;
  void apply(const EdgeChanges& changes);
  void create(EdgeId id);
  void destroy(EdgeId id);
  void remake(EdgeId id);
  void loadEdges();
  /// Wakes bodies near edges that change. Returns bodies that can overlap: those, and those at other boxes.
  std::vector<BodyHandle> wakeAround(const EdgeChanges& changes, std::vector<Box> boxes);
  LocalEdge localEdge(EdgeId id) const;
  Position positionOf(std::uint32_t chunk) const;

 protected:
  Physics physics_;                ///< the physics world
  const World& world_;             ///< the world whose outline this is
  Frame frame_;                    ///< where cells are in metres
  OnOverlap onOverlap_;            ///< what sync() does with bodies that new ground overlaps
  Materials<Material> materials_;  ///< by block
  EdgeSet edges_;                  ///< the edges behind the shapes
  std::vector<SegmentShape> shapes_ = std::vector<SegmentShape>(1);  ///< by EdgeId
  std::vector<ChunkBody> bodies_;                                    ///< by number of the chunk
  std::size_t bodyCount_ = 0;                                        ///< chunks with at least one shape
  std::vector<Overlap> overlaps_;                                    ///< of the last sync()
  detail::KnownBodies disabled_;                                     ///< bodies that wait until their place is free
  std::unique_ptr<Footings> footings_;                               ///< where each body was free last
  std::size_t others_ = 0;                                           ///< bodies that were not in footings_ (Box2D 3)
  std::vector<BodyHandle> putBack_;                                  ///< by the last afterStep()
};

}  // namespace lgs::box2d
