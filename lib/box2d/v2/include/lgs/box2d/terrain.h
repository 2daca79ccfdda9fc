// The boundary of a lgs::World as terrain in a Box2D 2.4 world. Each chunk of cells is a static body, and each segment
// is a one-sided edge shape with its ghost vertices. After a commit sync() changes exactly those fixtures that the
// commit changed.
//
//   lgs::box2d::Terrain terrain(physics, world, {.cellSize = 0.5F});
//   …
//   if (world.remove(handle)) terrain.commit(world);
//   …
//   void BeginContact(b2Contact* contact) override {  // of a listener
//     if (auto touch = terrain.hit(*contact)) touched.push_back(touch->hit.cell);
//   }
//   …
//   physics.Step(1.0F / 60, 8, 3);  // a listener only notes what to dig: nothing may change during the step
//   for (lgs::Cell cell : touched) world.clear(cell);
//   terrain.commit(world);
//
// Bodies that rest on changed ground wake up, and so do bodies where new ground appears. Nothing else is touched.
//
// To be called from one thread at a time, and not during b2World::Step(), but for functions that are const. Nothing
// fails, unless it is said.
#pragma once

#include <box2d/box2d.h>
#include <lgs/box2d/edges.h>
#include <lgs/box2d/hit.h>
#include <lgs/box2d/materials.h>

#include <concepts>
#include <memory>
#include <optional>
#include <vector>

namespace lgs::box2d {

class Footings;
class NewGround;
struct Box;
struct Footing;
struct Form;
enum class Whose;

/// What a block is like. The defaults are Box2D's.
struct Material {
  float friction = 0.2F;                                       ///< 0 or more
  float restitution = 0;                                       ///< 0 … 1
  float restitutionThreshold = 1.0F * b2_lengthUnitsPerMeter;  ///< metres a second; slower bodies do not bounce
  b2Filter filter = {};                                        ///< what it collides with
  bool isPassable = false;  ///< bodies may be inside, as in a one-way platform: nobody is caught there
  friend bool operator==(const Material& a, const Material& b);
};

/// The options of a terrain, with the material of this Box2D.
using TerrainOptions = BasicTerrainOptions<Material>;

/// A contact of the terrain.
struct Touch {
  Hit hit;                     ///< what was touched
  b2Vec2 normal;               ///< outward unit normal of the terrain's edge
  b2Fixture* other = nullptr;  ///< what touches it
};

/// The ground nearest to a point.
struct NearestHit {
  Hit hit;             ///< what is nearest
  b2Vec2 point;        ///< its nearest point, in metres
  b2Vec2 normal;       ///< outward unit normal of the segment
  float distance = 0;  ///< metres
};

/// What a ray meets first.
struct GroundRayHit {
  Hit hit;             ///< what was hit
  b2Vec2 point;        ///< where, in metres
  b2Vec2 normal;       ///< outward unit normal of the segment
  float fraction = 1;  ///< of the way from the start to the end of the ray
};

/// A body that new ground would hold.
struct Caught {
  b2Body* body = nullptr;
  float depth = 0;      ///< metres: how deep the ground reaches into it, at most to the middle
  bool isFree = false;  ///< whether there is a way out
  b2Vec2 way{0, 0};     ///< that way: a straight move without a turn
};

/// The ground of one world in one physics world. The comment at the top of this file has an example.
class Terrain {
 public:
  /// Makes the terrain of what the world held at its last commit. Both worlds must outlive it and stay where they are;
  /// resync() if `world` is assigned to. Cost: O(segments).
  Terrain(b2World& physics, const World& world, TerrainOptions options = {});
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
  /// the number of changes, times the segments of an edge; and for each fixture that goes the fixtures of its
  /// body, because Box2D looks for it there.
  tl::expected<void, SyncError> sync(const Changes& changes);

  /// The same, with another answer to what happens to bodies in new ground.
  tl::expected<void, SyncError> sync(const Changes& changes, OnCaught onCaught);

  /// The bodies that these changes would catch. Ask after a commit or roll-back and before its sync(): so the game can
  /// roll back, or leave the rest to sync(). A body is caught if its middle was free and is in the solid, or if a new
  /// edge reaches deeper than half way to its middle. Of a body of several fixtures each has a middle: the one by which
  /// Box2D judges on which side of an edge it is. Sensors, bodies that are not dynamic or not enabled, and fixtures
  /// whose filter lets them through the block do not count. Nothing, if sync() would refuse the changes. Cost: the
  /// number of changes, for each body in the box around them; and up to some milliseconds for one that has no way out.
  std::vector<Caught> caughtBy(const Changes& changes);

  /// Those that the last sync or resync pushed or held. Who was pushed was moved along the way out and woken, and has
  /// no velocity against it any more. None if they are left.
  const std::vector<Caught>& caught() const { return caught_; }

  /// The bodies that are held: disabled where they were caught, at rest. A later sync nearby enables them if they are
  /// free there, or pushes them out if their middles are. A game that destroys or enables one itself may do so.
  std::vector<b2Body*> held() const;

  /// Call it after each step. Bodies press each other, and Box2D may press a light one through an edge. Each body whose
  /// middle got into the ground in the step, or came through, is put back to where it was free before, at rest. Those
  /// are returned. Bodies that the game itself moves into the ground come back, too. Cost: World::at() for each fixture
  /// of a body that is awake.
  const std::vector<b2Body*>& afterStep();

  /// Call it when the game itself has put a body elsewhere, through a portal or to where it starts anew: else it seems
  /// to have come through the ground that is between, and afterStep() puts it back. Not needed before resync().
  void moved(const b2Body& body);

  /// Whether the ground, as of the last commit, reaches into no fixture of a body by more than Box2D's slop, where it
  /// is or as if it were at another place.
  bool fits(const b2Body& body);
  bool fits(const b2Body& body, const b2Transform& at);

  /// Polygons around the shapes of a body that edges hold, in lattice units of the world: for a brush. Round ones are
  /// somewhat larger.
  std::vector<std::vector<Point>> outlinesOf(const b2Body* body);

  /// Brings the terrain up to date with what its world held at its last commit, whatever was done to the world:
  /// changes were left out, or another world was assigned to it, loaded or copied. Bodies may have been moved
  /// meanwhile: whoever is in the ground is pushed or held, however it came there; and whoever is held and free is
  /// held no more. Fixtures that are right as they are stay, and bodies on them sleep on. Cost: O(segments).
  void resync();

  /// Asks TerrainOptions::material again for all blocks, as what blocks are like has changed; and syncs as resync()
  /// does. The fixtures of blocks that are another material now are made anew, so what rests there wakes up. Nobody is
  /// pushed out of a block that was passable and is solid now. Cost: O(segments).
  void materialsChanged();

  /// Whether the terrain is up to date with the last commit.
  bool isCurrent() const { return edges_.version() == world_.version(); }

  /// What a fixture stands for; nothing if it is none of the terrain's. If it stands for several segments, merged or
  /// welded, this is the one nearest to a point of the physics world; without a point, the first one. Between a commit
  /// and its sync(): nothing if the commit changed those segments.
  std::optional<Hit> hit(const b2Fixture& fixture) const;
  std::optional<Hit> hit(const b2Fixture& fixture, const b2Vec2& point) const;

  /// What a contact touches of the terrain; nothing if neither fixture is the terrain's, or if the contact does not
  /// touch: Box2D has contacts also of fixtures that are only near. If the edge stands for several segments, the hit is
  /// the one nearest to the middle of the contact's points; without points, as with a sensor, to the middle of the
  /// other fixture. Can be called in a b2ContactListener: in BeginContact, PreSolve and PostSolve every contact
  /// touches. In EndContact use hit(fixture), because a contact that ends does not touch any more.
  std::optional<Touch> hit(b2Contact& contact) const;

  /// The segment of the outline nearest to a point of the physics world, as of the last commit; nothing if none is
  /// within `radius` metres, or kMaxRadius cells, or if the point is beyond the last cell. The point may be in the
  /// solid. Segments that are too short for an edge count as well. Cost: as of World::nearest().
  std::optional<NearestHit> nearest(const b2Vec2& point, float radius) const;

  /// The first piece of the outline that a ray meets from outside, as of the last commit; nothing if it meets none, is
  /// longer than kMaxRay cells on an axis, or has an end beyond the last cell. It is exact but for its ends, which are
  /// rounded to the lattice. A ray of Box2D leaks where segments were too short for an edge; this one does not. It
  /// looks at no filter and at no body: for what stands before the ground cast a ray of Box2D as well, and take the
  /// nearer hit. Cost: as of World::rayCast().
  std::optional<GroundRayHit> rayCast(const b2Vec2& from, const b2Vec2& to) const;

  /// The bodies that reach into a rectangle of cells, but for the terrain's; each once, in no particular order. Sensors
  /// are not looked at. caughtBy() says which of them new ground would hold. Box2D's skin of a polygon counts: bodies
  /// that are less than 1 cm (b2_polygonRadius) away are found, but not those that just rest beside the cells. Cost:
  /// the fixtures near the cells.
  template <std::same_as<CellRect> Rect = CellRect>  // so that bodiesIn({3, 4}) is of a cell
  std::vector<b2Body*> bodiesIn(const Rect& cells) const {
    return bodiesInRect(cells);
  }
  std::vector<b2Body*> bodiesIn(Cell cell) const { return bodiesInRect({cell, cell}); }

  /// Makes the corner of another cell (0, 0) of the physics world, for a world that keeps its origin near the player.
  /// Moves the terrain's bodies, and no others:
  ///
  ///   physics.ShiftOrigin(terrain.position(lgs::toWorld(cell, {})));
  ///   terrain.moveOrigin(cell);
  ///
  /// Cost: in proportion to the fixtures.
  void moveOrigin(Cell origin);

  /// The fixture that stands for a segment; null if the segment is left out, because it is too short, or is not alive.
  b2Fixture* fixture(SegmentId segment) const;

  /// The edges behind the fixtures: counts, ends, ghosts. A fixture's userData.pointer is its EdgeId. The terrain needs
  /// it; do not write there.
  const EdgeSet& edges() const { return edges_; }
  /// The fixture of a live edge; null for the null id and for one that never was.
  b2Fixture* fixture(EdgeId edge) const { return edge.value < fixtures_.size() ? fixtures_[edge.value] : nullptr; }
  std::size_t bodyCount() const { return bodyCount_; }  ///< chunks with at least one fixture

  b2Vec2 position(Point p) const;  ///< where a lattice point is in the physics world, in range or not
  /// The lattice point nearest to a place in the physics world; not inRange() if that is beyond the last cell. It leads
  /// from a click to a polygon: world.at(terrain.latticePoint(mouse)).
  Point latticePoint(const b2Vec2& p) const;
  /// The cell at a place in the physics world; not inRange() if that is beyond the last cell, or no number.
  Cell cellAt(const b2Vec2& p) const;

 private:
  struct Body {
    b2Body* body = nullptr;
    std::size_t fixtures = 0;
  };
  EdgeId edgeOf(const b2Fixture& fixture) const;  // null if it is none of the terrain's
  std::vector<b2Body*> bodiesInRect(const CellRect& cells) const;
  bool isAlone() const { return static_cast<std::size_t>(physics_.GetBodyCount()) <= bodyCount_; }
  std::vector<Form> formsOf(const b2Body& body, const b2Transform& at);
  b2Vec2 metres(DoublePoint units) const;
  std::vector<b2Body*> catchableIn(const Box& box) const;
  std::vector<Caught> find(const NewGround& ground);
  std::vector<Caught> findAll(const NewGround& ground);
  void addIfCaught(b2Body* body, const NewGround& ground, Whose whose, std::vector<Caught>& caught);
  void settle(const std::optional<Box>& changed, OnCaught onCaught);
  bool release(b2Body& body, const Box& changed);
  void push(b2Body& body, const b2Vec2& way);
  bool isFree(const b2Body& body, const b2Transform& at);
  bool hasCrossed(const b2Body& body, const Footing& last);
  void noteAll();
  void note(const b2Body& body);
  b2Transform transformOf(const Footing& footing) const;
  void putBack(b2Body& body, const Footing& footing);
  void apply(const EdgeChanges& changes);
  void create(EdgeId id);
  void destroy(EdgeId id);
  b2EdgeShape shapeOf(const Edge& edge) const;
  b2Vec2 positionOf(std::uint32_t chunk) const;
  void remake(EdgeId id);
  void wakeAround(b2Fixture& fixture);

  b2World& physics_;
  const World& world_;
  Frame frame_;
  OnCaught onCaught_;
  Materials<Material> materials_;
  EdgeSet edges_;
  std::vector<b2Fixture*> fixtures_ = {nullptr};  // by EdgeId
  std::vector<Body> bodies_;                      // by number of the chunk
  std::size_t bodyCount_ = 0;
  std::vector<Caught> caught_;
  std::vector<b2Body*> held_;
  std::unique_ptr<Footings> footings_;
  std::vector<b2Body*> putBack_;
};

}  // namespace lgs::box2d
