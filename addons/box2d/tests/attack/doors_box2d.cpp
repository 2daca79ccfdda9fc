// Doors of the terrain for Box2D 2.4: of its frame, its edges and its bodies. The physics of a scene is made when a
// door first asks for it. From then on the other doors edit the world behind its back.
#include "door.h"

#include <lgs/box2d/bodies_in.h>
#include <lgs/box2d/cut_out.h>
#include <lgs/box2d/terrain.h>

#include <fmt/ranges.h>

#include <limits>

namespace lgs::test {

/// A terrain of the scene's world with a ball on it, a body of two shapes in the air, and a platform that hangs there.
struct Ground {
  explicit Ground(const World& world)
      : terrain(physics, world, {.chunkCells = 2, .merge = true}), edges({.shortest = 9}) {
    edges.load(world);
    round.m_radius = 0.4F;
    box.SetAsBox(0.5F, 0.2F);
    ball = bodyAt({0.5F, 2.2F}, b2_dynamicBody);
    ball->CreateFixture(&round, 1);
    two = bodyAt({-0.5F, 3.5F}, b2_dynamicBody);
    two->CreateFixture(&round, 1);
    two->CreateFixture(&box, 1);
    platform = bodyAt({5, 5}, b2_staticBody);
    platform->CreateFixture(&box, 0);
    physics.Step(1.0F / 60, 8, 3);
  }

  b2Body* bodyAt(b2Vec2 place, b2BodyType type) {
    b2BodyDef def;
    def.type = type;
    def.position = place;
    return physics.CreateBody(&def);
  }

  b2World physics{{0, -10}};
  box2d::Terrain terrain;
  box2d::EdgeSet edges;
  b2CircleShape round;
  b2PolygonShape box;
  b2Body *ball = nullptr, *two = nullptr, *platform = nullptr;
};

namespace {

using box2d::Chunk;
using box2d::EdgeId;
using box2d::Frame;
using box2d::OnOverlap;
using box2d::Place;
using box2d::SyncError;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinite = std::numeric_limits<float>::infinity();
constexpr float kHuge = std::numeric_limits<float>::max();
constexpr double kTiny = 2e-6;

Ground& groundOf(Scene& scene) {
  if (!scene.ground) scene.ground = std::make_shared<Ground>(scene.world);
  return *scene.ground;
}

/// One of the bodies: a stranger can hand in no others that are alive.
struct Who {
  std::size_t number = 0;
  b2Body& in(Ground& ground) const {
    const std::array all{ground.ball, ground.two, ground.platform, ground.physics.GetBodyList()};
    return *all[number];
  }
};

struct Angle {
  float value = 0;
};

bool isFinite(Place place) { return std::isfinite(place.x) && std::isfinite(place.y); }

}  // namespace

LGS_VALUES(b2Vec2, fmt::format("({}, {})", v.x, v.y), {0.5F, 1.9F}, {0, -0.0F}, {kNan, 0}, {0, kInfinite},
           {-kInfinite, 1}, {kHuge, -kHuge}, {1e-45F, -1e-45F}, {1.0737418e9F, 0}, {-1.0737418e9F, 1e10F},
           {3e9F, -3e9F})
LGS_VALUES(Angle, fmt::format("angle {}", v.value), {0}, {kNan}, {kInfinite}, {kHuge}, {-3.2F})
LGS_VALUES(float, fmt::format("{}", v), 1, 0, -1, kNan, kInfinite, -kInfinite, kHuge, 1e-45F, 1'025)
LGS_VALUES(Place, fmt::format("place ({}, {})", v.x, v.y), {0.5, 1.9}, {0, -0.0}, {kNan, 0}, {0, kInfinite},
           {-kInfinite, 1}, {1e308, -1e308}, {5e-324, 0}, {1e10, 1e10}, {kMaxCell, -kMaxCell}, {kMaxCell + 1.0, 0})
LGS_VALUES(Chunk, fmt::format("chunk ({}, {})", v.x, v.y), {0, 0}, {-1, 1}, {kLeast, kLeast}, {kMost, kMost},
           {1 << 26, 0})
LGS_VALUES(EdgeId, fmt::format("edge {}", v.value), {1}, {0}, {2}, {999}, {0x8000'0000}, {0xffff'ffff})
LGS_VALUES(OnOverlap, fmt::format("answer {}", static_cast<unsigned>(v)), OnOverlap::push, OnOverlap::disable,
           OnOverlap::leave, OnOverlap{3}, OnOverlap{255})
LGS_VALUES(SyncError, fmt::format("error {}", static_cast<unsigned>(v)), SyncError::leftOut, SyncError::notTheLast,
           SyncError::shownAlready, SyncError{3}, SyncError{255})
LGS_VALUES(Who, fmt::format("body {}", v.number), {0}, {1}, {2}, {3})
LGS_VALUES(Frame, fmt::format("a frame of {} m from {} by {}", v.cellSize, Hostile<Cell>::told(v.origin), v.chunkCells),
           {}, {0.5, {-7, 9}, 1}, {kTiny, {kMaxCell, -kMaxCell}, 4'096}, {1e308, {kLeast, kMost}, 16},
           {64, {kMost, kMost}, 4'096})

/// What a commit may have reported, or a stranger made up: old, of another world, with names of nothing.
template <>
struct Hostile<Changes> {
  static const std::vector<Changes>& values(Scene& scene) {
    static std::vector<Changes> all;
    const Ground& ground = groundOf(scene);
    const std::uint64_t now = scene.world.version(), shown = ground.terrain.edges().version();
    all = {scene.world.changesOfRollBack(), scene.other.changesOfRollBack(), scene.reported, {}};
    for (const auto& [before, after] : {std::pair{shown, now}, std::pair{now, now}, std::pair{now, now + 1}}) {
      all.push_back({scene.segments, {}, {}, before, after});
      all.push_back({{}, scene.segments, {}, before, after});
      all.push_back({{}, {}, scene.segments, before, after});
      all.push_back({scene.segments, scene.segments, scene.segments, before, after});
    }
    return all;
  }
  static std::string told(const Changes& v) {
    return fmt::format("changes from {} to {}: {} removed, {} added, {} relinked", v.before, v.after, v.removed.size(),
                       v.added.size(), v.relinked.size());
  }
};

void addDoorsOfFrames(Doors& door);
void addDoorsOfEdges(Doors& door);

void addDoorsOfBox2d(Doors& door) {
  addDoorsOfFrames(door);
  addDoorsOfEdges(door);
  door("box2d::Terrain::Terrain(b2World&, const World&, TerrainOptions)",
       [](Scene& s, Cell origin, bool merge, OnOverlap onOverlap) {
         b2World physics({0, 0});
         const box2d::Terrain terrain(physics, s.world, {.origin = origin, .merge = merge, .onOverlap = onOverlap});
         return terrain.bodyCount();
       });
  door("box2d::TerrainBase::commit(World&)", [](Scene& s, bool isOther) {
    Ground& ground = groundOf(s);
    const std::uint64_t before = s.other.version();
    const auto done = ground.terrain.commit(isOther ? s.other : s.world);
    EXPECT_FALSE(isOther && done);
    EXPECT_EQ(s.other.version(), before);
  });
  door("box2d::TerrainBase::sync(const Changes&)",
       [](Scene& s, const Changes& changes) { return groundOf(s).terrain.sync(changes); });
  door("box2d::TerrainBase::sync(const Changes&, OnOverlap)",
       [](Scene& s, const Changes& changes, OnOverlap onOverlap) {
         return groundOf(s).terrain.sync(changes, onOverlap);
       });
  door("box2d::TerrainBase::overlapsWith(const Changes&)",
       [](Scene& s, const Changes& changes) { return groundOf(s).terrain.overlapsWith(changes).size(); });
  door("box2d::TerrainBase::overlaps() const", [](Scene& s) { return groundOf(s).terrain.overlaps().size(); });
  door("box2d::TerrainBase::disabled() const", [](Scene& s) { return groundOf(s).terrain.disabled().size(); });
  door("box2d::TerrainBase::beforeStep()", [](Scene& s) { groundOf(s).terrain.beforeStep(); });
  door("box2d::TerrainBase::afterStep()", [](Scene& s) {
    groundOf(s).physics.Step(1.0F / 60, 8, 3);
    return groundOf(s).terrain.afterStep().size();
  });
  door("box2d::TerrainBase::moved(BodyArgument)", [](Scene& s, Who who, const b2Vec2& place, Angle angle) {
    b2Body& body = who.in(groundOf(s));
    if (place.IsValid() && b2IsValid(angle.value) && place.Length() < 1e10F) body.SetTransform(place, angle.value);
    groundOf(s).terrain.moved(body);
  });
  door("box2d::TerrainBase::fits(BodyArgument)",
       [](Scene& s, Who who) { return groundOf(s).terrain.fits(who.in(groundOf(s))); });
  door("box2d::Terrain::fits(const b2Body&, const b2Transform&)",
       [](Scene& s, Who who, const b2Vec2& place, Angle angle) {
         return groundOf(s).terrain.fits(who.in(groundOf(s)), b2Transform(place, b2Rot(angle.value)));
       });
  door("box2d::TerrainBase::outlinesOf(ConstBodyHandle)",
       [](Scene& s, Who who) { return groundOf(s).terrain.outlinesOf(&who.in(groundOf(s))).size(); });
  door("box2d::TerrainBase::resync()", [](Scene& s) {
    Ground& ground = groundOf(s);
    ground.terrain.resync();
    EXPECT_TRUE(ground.terrain.isCurrent());
    b2World physics({0, 0});
    const box2d::Terrain fresh(physics, s.world, {.chunkCells = 2, .merge = true});
    EXPECT_EQ(ground.terrain.edges().counts(), fresh.edges().counts());
    EXPECT_EQ(ground.terrain.bodyCount(), fresh.bodyCount());
  });
  door("box2d::TerrainBase::materialsChanged()", [](Scene& s) { groundOf(s).terrain.materialsChanged(); });
  door("box2d::TerrainBase::isCurrent() const", [](Scene& s) { return groundOf(s).terrain.isCurrent(); });
  door("box2d::TerrainBase::hit(const Shape&) const", [](Scene& s, Who who) {
    for (const b2Fixture* f = who.in(groundOf(s)).GetFixtureList(); f; f = f->GetNext())
      static_cast<void>(groundOf(s).terrain.hit(*f));
  });
  door("box2d::TerrainBase::hit(const Shape&, const Position&) const", [](Scene& s, Who who, const b2Vec2& place) {
    for (const b2Fixture* f = who.in(groundOf(s)).GetFixtureList(); f; f = f->GetNext())
      static_cast<void>(groundOf(s).terrain.hit(*f, place));
  });
  door("box2d::Terrain::hit(b2Contact&) const", [](Scene& s) {
    for (b2Contact* c = groundOf(s).physics.GetContactList(); c; c = c->GetNext())
      static_cast<void>(groundOf(s).terrain.hit(*c));
  });
  door("box2d::TerrainBase::nearest(const Position&, float) const", [](Scene& s, const b2Vec2& place, float radius) {
    const auto hit = groundOf(s).terrain.nearest(place, radius);
    EXPECT_TRUE((place.IsValid() && radius >= 0) || !hit);
  });
  door("box2d::TerrainBase::rayCast(const Position&, const Position&) const",
       [](Scene& s, const b2Vec2& from, const b2Vec2& to) {
         const auto hit = groundOf(s).terrain.rayCast(from, to);
         EXPECT_TRUE((from.IsValid() && to.IsValid()) || !hit);
       });
  door("box2d::TerrainBase::bodiesIn(const Rect&) const",
       [](Scene& s, const CellRect& cells) { return groundOf(s).terrain.bodiesIn(cells).size(); });
  door("box2d::TerrainBase::bodiesIn(Cell) const",
       [](Scene& s, Cell cell) { return groundOf(s).terrain.bodiesIn(cell).size(); });
  door("box2d::TerrainBase::moveOrigin(Cell)", [](Scene& s, Cell cell) { groundOf(s).terrain.moveOrigin(cell); });
  door("box2d::Terrain::fixture(SegmentId) const",
       [](Scene& s, SegmentId id) { return groundOf(s).terrain.fixture(id) != nullptr; });
  door("box2d::Terrain::fixture(EdgeId) const",
       [](Scene& s, EdgeId id) { return groundOf(s).terrain.fixture(id) != nullptr; });
  door("box2d::TerrainBase::edges() const", [](Scene& s) { return groundOf(s).terrain.edges().edges().size(); });
  door("box2d::TerrainBase::bodyCount() const", [](Scene& s) { return groundOf(s).terrain.bodyCount(); });
  door("box2d::TerrainBase::position(Point) const",
       [](Scene& s, Point p) { return groundOf(s).terrain.position(p).x; });
  door("box2d::TerrainBase::latticePoint(const Position&) const", [](Scene& s, const b2Vec2& place) {
    const Point p = groundOf(s).terrain.latticePoint(place);
    EXPECT_TRUE(place.IsValid() || !inRange(p));
  });
  door("box2d::TerrainBase::cellAt(const Position&) const", [](Scene& s, const b2Vec2& place) {
    const Cell cell = groundOf(s).terrain.cellAt(place);
    EXPECT_TRUE(place.IsValid() || !inRange(cell));
  });
  door("box2d::cutOut(Terrain&, World&, const Changes&)", [](Scene& s, const Changes& changes) {
    static_cast<void>(box2d::cutOut(groundOf(s).terrain, s.world, changes));
  });
  door("box2d::bodiesIn(Terrain&, const Region&)",
       [](Scene& s, const Region& region) { return box2d::bodiesIn(groundOf(s).terrain, region).size(); });
  door("box2d::withoutBodies(Terrain&, const Region&)",
       [](Scene& s, const Region& region) { return box2d::withoutBodies(groundOf(s).terrain, region); });
}

void addDoorsOfFrames(Doors& door) {
  door("box2d::Frame::floorDiv(int32_t, int32_t)",
       [](Scene&, int a, int b) { return b > 0 ? Frame::floorDiv(a, b) : 0; });
  door("box2d::Frame::chunkOf(Cell) const",
       [](Scene&, const Frame& frame, Cell cell) { return frame.chunkOf(cell).x; });
  door("box2d::Frame::cornerOf(Chunk) const",
       [](Scene&, const Frame& frame, Chunk chunk) { return frame.cornerOf(chunk).x; });
  door("box2d::Frame::position(Point) const", [](Scene&, const Frame& frame, Point p) { return frame.position(p).x; });
  door("box2d::Frame::position(DoublePoint) const",
       [](Scene&, const Frame& frame, DoublePoint p) { return frame.position(p).x; });
  door("box2d::Frame::local(Point, Chunk) const",
       [](Scene&, const Frame& frame, Point p, Chunk chunk) { return frame.local(p, chunk).x; });
  door("box2d::Frame::cellAt(Place) const", [](Scene&, const Frame& frame, Place place) {
    const Cell cell = frame.cellAt(place);
    EXPECT_TRUE(isFinite(place) || !inRange(cell));
  });
  door("box2d::Frame::latticePoint(Place) const", [](Scene&, const Frame& frame, Place place) {
    const Point p = frame.latticePoint(place);
    EXPECT_TRUE(isFinite(place) || !inRange(p));
  });
  door("box2d::Frame::units(Place) const", [](Scene&, const Frame& frame, Place p) { return frame.units(p).x; });
  door("box2d::Frame::placeOf(DoublePoint) const",
       [](Scene&, const Frame& frame, DoublePoint p) { return frame.placeOf(p).x; });
  door("box2d::Frame::units(double) const", [](Scene&, const Frame& frame, double v) { return frame.units(v); });
  door("box2d::Frame::metres(double) const", [](Scene&, const Frame& frame, double v) { return frame.metres(v); });
  door("box2d::Frame::unitsOf(double) const", [](Scene&, const Frame& frame, double v) {
    const std::int64_t units = frame.unitsOf(v);
    EXPECT_TRUE(units >= 0 && units <= std::int64_t{1} << 62);
  });
  door("box2d::message(SyncError)", [](Scene&, SyncError error) { return *box2d::message(error); });
}

void addDoorsOfEdges(Doors& door) {
  door("box2d::EdgeId::operator bool() const", [](Scene&, EdgeId id) { return bool{id}; });
  door("box2d::EdgeSet::EdgeSet(EdgeOptions)", [](Scene& s, bool merge) {
    box2d::EdgeSet edges({.chunkCells = 4'096, .shortest = std::int64_t{1} << 28, .merge = merge});
    return edges.load(s.world).added.size();
  });
  door("box2d::EdgeSet::load(const World&)",
       [](Scene& s, bool isOther) { return groundOf(s).edges.load(isOther ? s.other : s.world).added.size(); });
  door("box2d::EdgeSet::update(const World&, const Changes&)", [](Scene& s, const Changes& changes) {
    box2d::EdgeSet& edges = groundOf(s).edges;
    return edges.misfit(s.world, changes) ? 0 : edges.update(s.world, changes).added.size();
  });
  door("box2d::EdgeSet::misfit(const World&, const Changes&) const",
       [](Scene& s, const Changes& changes) { return groundOf(s).edges.misfit(s.other, changes).has_value(); });
  door("box2d::EdgeSet::version() const", [](Scene& s) { return groundOf(s).edges.version(); });
  door("box2d::EdgeSet::edge(EdgeId) const", [](Scene& s, EdgeId id) { return groundOf(s).edges.edge(id).start.x; });
  door("box2d::EdgeSet::edgeOf(SegmentId) const",
       [](Scene& s, SegmentId id) { return groundOf(s).edges.edgeOf(id).value; });
  door("box2d::EdgeSet::lineOf(SegmentId) const",
       [](Scene& s, SegmentId id) { return groundOf(s).edges.lineOf(id).has_value(); });
  door("box2d::EdgeSet::maxSegmentId() const", [](Scene& s) { return groundOf(s).edges.maxSegmentId(); });
  door("box2d::EdgeSet::edges() const", [](Scene& s) { return groundOf(s).edges.edges().size(); });
  door("box2d::EdgeSet::chunk(uint32_t) const",
       [](Scene& s, std::uint32_t number) { return groundOf(s).edges.chunk(number).x; });
  door("box2d::EdgeSet::chunkCount() const", [](Scene& s) { return groundOf(s).edges.chunkCount(); });
  door("box2d::EdgeSet::counts() const", [](Scene& s) { return groundOf(s).edges.counts().edges; });
  door("box2d::EdgeSet::options() const", [](Scene& s) { return groundOf(s).edges.options().shortest; });
  door("box2d::Materials::Materials<Material>(function<Material (Block)>)",
       [](Scene&) { return box2d::Materials<box2d::Material>({}).number(1); });
  door("box2d::Materials::number(Block)",
       [](Scene&, std::uint32_t block) { return box2d::Materials<box2d::Material>({}).number(block); });
  door("box2d::Materials::of(Block)",
       [](Scene&, std::uint32_t block) { return box2d::Materials<box2d::Material>({}).of(block).friction; });
  door("box2d::Materials::askAgain()", [](Scene&) { box2d::Materials<box2d::Material>({}).askAgain(); });
}

}  // namespace lgs::test
