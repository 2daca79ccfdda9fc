// The boundary of a lgs::World as terrain in a world of Box2D 3.1 or later. Each chunk of cells is a static body, and
// each segment is a chain segment with its ghost vertices. After a commit sync() changes exactly those shapes that the
// commit changed.
//
//   lgs::box2d::Terrain terrain(physics, world, {.cellSize = 0.5});
//   …
//   if (world.remove(handle)) terrain.commit(world);
//   …
//   const int count = b2Body_GetContactData(body, contacts, capacity);  // after a step
//   for (int k = 0; k < count; ++k)
//     if (auto touch = terrain.hit(contacts[k])) world.clear(touch->hit.cell);
//   terrain.commit(world);
//
// From Box2D 3.2 on the chain segments are loose (b2CreateChainSegmentShape), and a ghost that changes is written in
// place. Before 3.2 each is an open chain of four points, which is made anew when a ghost changes.
//
// Bodies that rest on changed ground wake up, and so do bodies where new ground appears. Nothing else is touched.
//
// To be called from one thread at a time, and not during b2World_Step(). Nothing fails, unless it is said.
#pragma once

#include <box2d/box2d.h>
#include <lgs/box2d/edges.h>
#include <lgs/box2d/hit.h>
#include <lgs/box2d/materials.h>

#include <concepts>
#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

namespace lgs::box2d {

class Footings;
class NewGround;
struct Box;
struct Footing;
struct Form;
enum class Whose;

/// A place in the physics world: b2Pos, which is b2Vec2 unless Box2D was built with BOX2D_DOUBLE_PRECISION. Before 3.2
/// Box2D has b2Vec2 alone.
using Position = decltype(b2BodyDef::position);

/// With which precision a file was compiled. It is a parameter of Terrain's constructor that nobody gives: where a game
/// and the terrain's library disagree about BOX2D_DOUBLE_PRECISION, they do not link.
enum class PositionsInFloat : bool {};
enum class PositionsInDouble : bool {};
using Precision = std::conditional_t<std::is_same_v<decltype(Position::x), float>, PositionsInFloat, PositionsInDouble>;

/// What a block is like. The defaults are Box2D's. The flags are those of b2ShapeDef. Sensor events need
/// theirs on both shapes, the others on one of the two. (In 2.4 listeners hear of every contact without a flag.)
struct Material {
  b2SurfaceMaterial surface = b2DefaultSurfaceMaterial();  ///< friction and the like
  b2Filter filter = b2DefaultFilter();                     ///< what it collides with
  bool enableSensorEvents = false;                         ///< sensors see the block
  bool enableContactEvents = false;                        ///< as in b2ShapeDef
  bool enableHitEvents = false;                            ///< as in b2ShapeDef
  bool enablePreSolveEvents = false;                       ///< as in b2ShapeDef
  bool enableCustomFiltering = false;                      ///< before 3.2 Box2D asks the custom filter about all shapes
  bool isPassable = false;  ///< bodies may be inside, as in a one-way platform: nobody is caught there
  friend bool operator==(const Material& a, const Material& b);
};

/// The options of a terrain, with the material of this Box2D.
using TerrainOptions = BasicTerrainOptions<Material>;

/// A contact of the terrain.
struct Touch {
  Hit hit;                           ///< what was touched
  b2Vec2 normal;                     ///< outward unit normal of the terrain's edge
  b2ShapeId other = b2_nullShapeId;  ///< what touches it
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

/// A body that new ground would hold.
struct Caught {
  b2BodyId body = b2_nullBodyId;
  float depth = 0;      ///< metres: how deep the ground reaches into it, at most to the middle
  bool isFree = false;  ///< whether there is a way out
  b2Vec2 way{0, 0};     ///< that way: a straight move without a turn
};

/// A segment in Box2D. Before 3.2 it is part of a chain.
struct SegmentShape {
  b2ShapeId shape = b2_nullShapeId;  ///< the chain segment
  b2ChainId chain = b2_nullChainId;  ///< the chain that it is part of; null from 3.2 on
};

/// The ground of one world in one physics world. The comment at the top of this file has an example.
class Terrain {
 public:
  /// Makes the terrain of what the world held at its last commit. Both worlds must outlive it, and `world` must stay
  /// where it is; resync() if it is assigned to. Cost: O(segments).
  Terrain(b2WorldId physics, const World& world, TerrainOptions options = {}, Precision = {});
  ~Terrain();  ///< destroys its bodies
  Terrain(const Terrain&) = delete;
  Terrain(Terrain&&) = delete;
  Terrain& operator=(const Terrain&) = delete;
  Terrain& operator=(Terrain&&) = delete;

  /// Commits the edits of its world, and syncs. Errors as of sync(). `world` must be the terrain's own; if it is
  /// another one, the error is `notTheLast`, and nothing is committed. After `leftOut` the world is committed.
  tl::expected<void, SyncError> commit(World& world);

  /// Applies a commit, or what a roll-back reports. Call it once after each of them, before the next edit. Changes that
  /// are not the next ones are refused: the terrain stays as it was, and the error says why. After `leftOut` call
  /// resync(). After `shownAlready` there is nothing to do. After `notTheLast` call resync() unless isCurrent(). Cost:
  /// the number of changes, times the segments of an edge.
  tl::expected<void, SyncError> sync(const Changes& changes);

  /// The same, with another answer to what happens to bodies in new ground.
  tl::expected<void, SyncError> sync(const Changes& changes, OnCaught onCaught);

  /// The bodies that these changes would catch. Ask after a commit or roll-back and before its sync(): so the game can
  /// roll back, or leave the rest to sync(). A body is caught if its middle was free and is in the solid, or if a new
  /// edge reaches deeper than half way to its middle. Of a body of several shapes each has a middle: the one by which
  /// Box2D judges on which side of an edge it is. Sensors, bodies that are not dynamic or not enabled, and shapes
  /// whose filter lets them through the block do not count. Nothing, if sync() would refuse the changes. Cost: the
  /// number of changes, for each body in the box around them; and up to some milliseconds for one that has no way out.
  std::vector<Caught> caughtBy(const Changes& changes);

  /// Those that the last sync or resync pushed or held. Who was pushed was moved along the way out and woken, and has
  /// no velocity against it any more. None if they are left.
  const std::vector<Caught>& caught() const { return caught_; }

  /// The bodies that are held: disabled where they were caught, at rest. A later sync nearby enables them if they are
  /// free there, or pushes them out if their middles are. A game that destroys or enables one itself may do so.
  std::vector<b2BodyId> held() const;

  /// Call it after each step. Bodies press each other, and Box2D may press a light one through an edge. Each body whose
  /// middle got into the ground in the step, or came through, is put back to where it was free before, at rest. Those
  /// are returned. Bodies that the game itself moves into the ground come back, too. Cost: World::at() for each shape
  /// of a body that is awake.
  const std::vector<b2BodyId>& afterStep();

  /// Call it when the game itself has put a body elsewhere, through a portal or to where it starts anew: else it seems
  /// to have come through the ground that is between, and afterStep() puts it back. Not needed before resync().
  void moved(b2BodyId body);

  /// Whether the ground, as of the last commit, reaches into no shape of a body by more than Box2D's slop, where it
  /// is or as if it were at another place.
  bool fits(b2BodyId body);
  bool fits(b2BodyId body, Position at, b2Rot rotation);

  /// Polygons around the shapes of a body that edges hold, in lattice units of the world: for a brush. Round ones are
  /// somewhat larger.
  std::vector<std::vector<Point>> outlinesOf(b2BodyId body);

  /// Brings the terrain up to date with what its world held at its last commit, whatever was done to the world:
  /// changes were left out, or another world was assigned to it, loaded or copied. Bodies may have been moved
  /// meanwhile: whoever is in the ground is pushed or held, however it came there; and whoever is held and free is
  /// held no more. Shapes that are right as they are stay, and bodies on them sleep on. Cost: O(segments).
  void resync();

  /// What recall() needs to bring the terrain back to now, and nobody else can read. For this terrain alone.
  class Memory;
  using MemoryPtr = std::shared_ptr<const Memory>;

  /// b2World_Restore() brings back the shapes of the terrain, but not what they stand for. So remember beside a
  /// snapshot of the physics and a mark of the world, all three between two steps and with nothing left to sync; and
  /// recall when both are back:
  ///
  ///   const lgs::Mark mark = world.checkpoint();
  ///   const auto memory = terrain.remember();            // beside b2World_Snapshot()
  ///   …
  ///   b2World_Restore(physics, image, size);
  ///   world.rollBack(mark);
  ///   terrain.recall(memory);                            // and no sync
  ///
  /// From then on all goes on as it did, to the last bit. User data of the game's own bodies and shapes are not
  /// brought back: Box2D sets them to null. Cost: O(segments), 10 to 20 µs for a thousand.
  MemoryPtr remember() const;
  void recall(const MemoryPtr& memory);  ///< see remember()

  /// Asks TerrainOptions::material again for all blocks, as what blocks are like has changed; and syncs as resync()
  /// does. The shapes of blocks that are another material now are made anew, so what rests there wakes up. Nobody is
  /// pushed out of a block that was passable and is solid now. Cost: O(segments).
  void materialsChanged();

  /// Whether the terrain is up to date with the last commit.
  bool isCurrent() const { return edges_.version() == world_.version(); }

  /// What a shape stands for; nothing if it is none of the terrain's. If it stands for several segments, merged or
  /// welded, this is the one nearest to a point of the physics world; without a point, the first one. Between a commit
  /// and its sync(): nothing if the commit changed those segments.
  std::optional<Hit> hit(b2ShapeId shape) const;
  std::optional<Hit> hit(b2ShapeId shape, Position point) const;

  /// What a contact touches of the terrain; nothing if it is none of the terrain's, or has no points. If the edge
  /// stands for several segments, the hit is the one nearest to the middle of the points. Box2D gives out the data of
  /// contacts that touch, and of no others. But it looks ahead: what is less than four slops (2 cm) away touches for
  /// it, and a point's `separation` is greater than 0 then.
  std::optional<Touch> hit(const b2ContactData& contact) const;

  /// The same by the id of a contact, which Box2D's events have from 3.2 on; nothing if the contact is no more.
  template <class ContactId>
  requires requires(ContactId contact) { b2Contact_GetData(contact); }
  std::optional<Touch> hit(ContactId contact) const {
    return b2Contact_IsValid(contact) ? hit(b2Contact_GetData(contact)) : std::nullopt;
  }

  /// The segment of the outline nearest to a point of the physics world, as of the last commit; nothing if none is
  /// within `radius` metres, or kMaxRadius cells, or if the point is beyond the last cell. The point may be in the
  /// solid. Segments that are too short for an edge count as well. Cost: as of World::nearest().
  std::optional<NearestHit> nearest(Position point, float radius) const;

  /// The first piece of the outline that a ray meets from outside, as of the last commit; nothing if it meets none, is
  /// longer than kMaxRay cells on an axis, or has an end beyond the last cell. It is exact but for its ends, which are
  /// rounded to the lattice. A ray of Box2D leaks where segments were too short for an edge; this one does not. It
  /// looks at no filter and at no body: for what stands before the ground cast a ray of Box2D as well, and take the
  /// nearer hit. Cost: as of World::rayCast().
  std::optional<GroundRayHit> rayCast(Position from, Position to) const;

  /// The bodies that reach into a rectangle of cells, but for the terrain's; each once, in no particular order. Sensors
  /// are not looked at. caughtBy() says which of them new ground would hold. Bodies that just rest beside the cells are
  /// not found: the rectangle counts as smaller by Box2D's slop, half a centimetre, on each side. Cost: the shapes near
  /// the cells.
  template <std::same_as<CellRect> Rect = CellRect>  // so that bodiesIn({3, 4}) is of a cell
  std::vector<b2BodyId> bodiesIn(const Rect& cells) const {
    return bodiesInRect(cells);
  }
  std::vector<b2BodyId> bodiesIn(Cell cell) const { return bodiesInRect({cell, cell}); }

  /// Makes the corner of another cell (0, 0) of the physics world, for a world that keeps its origin near the player.
  /// Moves the terrain's bodies. The game moves its own, by the place that the corner had before. Cost: in proportion
  /// to the shapes.
  void moveOrigin(Cell origin);

  /// The shape that stands for a segment; null if the segment is left out, because it is too short, or is not alive.
  b2ShapeId shape(SegmentId segment) const;

  /// The edges behind the shapes: counts, ends, ghosts. A shape's user data is its EdgeId. The terrain needs it; do not
  /// write there.
  const EdgeSet& edges() const { return edges_; }
  /// The shape of a live edge; null for the null id and for one that never was.
  b2ShapeId shape(EdgeId edge) const {
    return edge.value < shapes_.size() ? shapes_[edge.value].shape : b2_nullShapeId;
  }
  std::size_t bodyCount() const { return bodyCount_; }  ///< chunks with at least one shape

  Position position(Point p) const;  ///< where a lattice point is in the physics world, in range or not
  /// The lattice point nearest to a place in the physics world; not inRange() if that is beyond the last cell. It leads
  /// from a click to a polygon: world.at(terrain.latticePoint(mouse)).
  Point latticePoint(Position p) const;
  /// The cell at a place in the physics world; not inRange() if that is beyond the last cell, or no number.
  Cell cellAt(Position p) const;

 private:
  struct Body {
    b2BodyId body = b2_nullBodyId;
    std::size_t shapes = 0;
  };
  EdgeId edgeOf(b2ShapeId shape) const;  // null if it is none of the terrain's
  std::vector<b2BodyId> bodiesInRect(const CellRect& cells) const;
  bool isAlone() const;
  std::vector<Form> formsOf(b2BodyId body, Position at, b2Rot rotation);
  b2Vec2 metres(DoublePoint units) const;
  std::vector<b2BodyId> catchableIn(const Box& box) const;
  std::vector<Caught> find(const NewGround& ground);
  std::vector<Caught> findAll(const NewGround& ground);
  void addIfCaught(b2BodyId body, const NewGround& ground, Whose whose, std::vector<Caught>& caught);
  void settle(const std::optional<Box>& changed, OnCaught onCaught);
  bool release(b2BodyId body, const Box& changed);
  void push(b2BodyId body, b2Vec2 way);
  bool isFree(b2BodyId body, Position at, b2Rot rotation);
  bool hasCrossed(b2BodyId body, const Footing& last);
  void noteAll();
  void note(b2BodyId body);
  void apply(const EdgeChanges& changes);
  void create(EdgeId id);
  void destroy(EdgeId id);
  void relink(EdgeId id);
  Position positionOf(std::uint32_t chunk) const;
  b2ShapeDef definitionOf(EdgeId id);
  b2ChainSegment segmentOf(EdgeId id) const;
  void remake(EdgeId id);
  void wakeAround(EdgeId id);

  b2WorldId physics_;
  const World& world_;
  Frame frame_;
  OnCaught onCaught_;
  Materials<Material> materials_;
  EdgeSet edges_;
  std::vector<SegmentShape> shapes_ = std::vector<SegmentShape>(1);  // by EdgeId
  std::vector<Body> bodies_;                                         // by number of the chunk
  std::size_t bodyCount_ = 0;
  std::vector<Caught> caught_;
  std::vector<b2BodyId> held_;
  std::unique_ptr<Footings> footings_;
  std::vector<b2BodyId> putBack_;
};

}  // namespace lgs::box2d
