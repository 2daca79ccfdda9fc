// Ground that falls, as bodies of Box2D 2.4 or 3. Include <lgs/box2d/falling.h>, and link LocalGridSeg::falling.
//
//   lgs::box2d::FallingGround falling(physics, world, terrain, {.density = [](lgs::Block) { return 2.5F; }});
//   …
//   terrain.sync(changes);
//   if (islands.update(world, changes))                       // islands.h
//     for (const lgs::IslandId id : islands.loose()) falling.takeAsBody(islands, id);
//   const lgs::Changes& gone = world.commit();                // the islands are edits like any other
//   terrain.sync(gone), islands.update(world, gone);
//   falling.afterSync();                                      // now the bodies are there
//   …
//   if (world.rollBack(mark)) terrain.sync(world.changesOfRollBack()), falling.afterRollBack();  // islands, too
//   …
//   std::vector<b2Body*> asleep;                              // settle() changes the list of bodies()
//   for (const auto& rock : falling.bodies())
//     if (!rock.body->IsAwake()) asleep.push_back(rock.body);
//   for (b2Body* body : asleep) falling.settle(body);         // an edit again: it is ground
//
// A body is made after the sync that took its edges away. So it never touches the ground that it was part of.
#pragma once

#include <lgs/box2d/falling_parts.h>
#include <lgs/box2d/terrain.h>
#include <lgs/islands.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace lgs::box2d {

/// How bodies are made.
struct FallingOptions {
  std::function<float(Block)> density{};      ///< kg per square metre, 0 or more; empty: 1
  std::function<Material(Block)> material{};  ///< what their shapes are like; empty: Box2D's defaults
};

/// A body, and the ground that it is. The body's origin is where the ground's origin was.
struct Falling {
  BodyHandle body{};    ///< null: every part is thinner than Box2D's slop, and there is nothing to see
  Body ground;          ///< what it is made of
  PolygonHandle was{};  ///< a polygon that it was in the ground; null, if it was no island
  int pushes = 0;       ///< by rests()
  double pushedAt = 0;  ///< at which angle, the last time
};

/// What a roll-back or redo did to bodies.
struct RolledBack {
  std::vector<Falling> gone;  ///< are ground again; their bodies are destroyed
  std::vector<Falling> made;  ///< fall again
};

/// The ground of one world that falls. What it makes is the game's to move. Code that destroys a body calls forget();
/// if it does not, the next call here but bodies() finds that out, and the ground that the body was is lost with it.
class FallingGround {
 public:
  /// All of them must outlive it and stay where they are.
  FallingGround(Physics physics, World& world, Terrain& terrain, FallingOptions options = {})
      : physics_(physics), world_(world), terrain_(terrain), options_(std::move(options)), known_(physics) {}

  /// Takes an island out of the ground. Its body is made by the next afterSync(). Refused: anchored, if something holds
  /// it; and as by take(). Cost: as of take().
  Expected<void> takeAsBody(const Islands& islands, IslandId island) {
    const auto facts = islands.island(island);
    if (facts && facts->anchors > 0) return tl::unexpected(Error{.code = ErrorCode::anchored});
    const auto segment = world_.segment(facts ? facts->outer.first : SegmentId{});
    auto body = take(world_, islands, island);
    if (!body) return tl::unexpected(body.error());
    waiting_.push_back({{}, std::move(*body), segment ? segment->polygon : PolygonHandle{}});
    return {};
  }

  /// To be called after the sync of the commit that holds what was taken. Makes the bodies, each of convex parts, where
  /// its ground was and at rest; its mass is exact but for one rounding. Returns them; they are the last of bodies().
  /// One that Box2D can make no shape of has a null body, and is not among bodies(). Cost: as of convexParts().
  std::vector<Falling> afterSync() {
    if (world_.version() != wentTo_) undone_.clear();  // after an edit nothing is done again
    findGone();
    std::vector<Falling> made;
    for (Falling& falling : waiting_) made.push_back(make(std::move(falling)));
    waiting_.clear();
    return made;
  }

  /// To be called after the sync of a roll-back or redo. If that brought the ground of a body back, as it undid
  /// its taking, the body is destroyed: else there would be twice the matter. If it did the taking again, the body is
  /// made again, where its ground was. What an undone settle() has taken out of the ground is not made again. Cost: a
  /// look at each body; as of afterSync().
  RolledBack afterRollBack() {
    findGone();
    RolledBack out;
    const auto isGround = [&](const Falling& f) { return f.was && world_.polygon(f.was).has_value(); };
    std::vector<Falling> again;
    std::erase_if(undone_, [&](Falling& f) { return !isGround(f) && (again.push_back(std::move(f)), true); });
    std::erase_if(waiting_, [&](Falling& f) { return isGround(f) && (undone_.push_back(std::move(f)), true); });
    std::erase_if(bodies_, [&](Falling& f) {
      if (!isGround(f)) return false;
      destroyBody(physics_, f.body);
      out.gone.push_back(f);
      undone_.push_back(std::move(f));
      return true;
    });
    findGone();
    for (Falling& falling : again) out.made.push_back(make(std::move(falling)));
    wentTo_ = world_.version();
    return out;
  }

  /// Makes the body of ground that is not in the world: a rock that was loaded, or thrown. It lies where the origin of
  /// `ground` is; move it then. As of afterSync().
  Falling add(Body ground) { return make({{}, std::move(ground), {}}); }

  /// Takes a body of the game's that is made of ground: one that was forgotten, say. From here on it can be settled.
  void add(BodyHandle body, Body ground) { keep({body, std::move(ground), {}}); }

  /// Forgets bodies that were destroyed without forget(), and returns whether there were any since the last call. Cost:
  /// a look at each body of the physics world in Box2D 2.4, at each of bodies() in 3.
  bool dropGone() {
    findGone();
    return std::exchange(hasDropped_, false);
  }

  /// All bodies that there are.
  const std::vector<Falling>& bodies() const { return bodies_; }

  /// Puts a body back into the ground, as it lies: an edit, to be committed and synced as any other. Its vertices are
  /// rounded to the lattice. It is let down by the gap that Box2D leaves below what rests and a slop, so that it is one
  /// island with what it rests on; what is ground already stays. Then the body is destroyed. Refused, and nothing is
  /// changed: overlap, where the ground reaches into it by more than two slops; staleHandle, if there is no such body;
  /// and as by putAsItLies(). Cost: as of Terrain::fits() and putAsItLies().
  Expected<void> settle(BodyHandle body) {
    const auto placing = placingOf(body);
    if (!placing) return tl::unexpected(placing.error());
    if (const auto done = putAsItLies(world_, find(body)->ground, *placing); !done) return done;
    forget(body);
    destroyBody(physics_, body);
    return {};
  }

  /// How settle() would put a body, for a game that does so in parts. Refused: as settle(), but for putAsItLies().
  Expected<Placing> placingOf(BodyHandle body) {
    findGone();
    if (find(body) == bodies_.end()) return tl::unexpected(Error{.code = ErrorCode::staleHandle});
    const Place gravity = gravityOf(physics_);
    const double pull = std::hypot(gravity.x, gravity.y);
    const Place down = pull > 0 ? Place{gravity.x / pull, gravity.y / pull} : Place{};
    const double slop = slopOf(physics_), depth = restingGap(physics_) + slop;
    const b2Vec2 lifted{static_cast<float>(-down.x * slop), static_cast<float>(-down.y * slop)};
    if (!fitsBy(terrain_, body, lifted)) return tl::unexpected(Error{.code = ErrorCode::overlap});
    const Lying lying = lyingOf(body);
    const double scale = std::hypot(lying.cosine, lying.sine), size = cellSize();
    const Point corner = terrain_.latticePoint({0, 0});  // of the cell that is at the origin of the physics
    const auto cells = [&](double metres, double way, std::int64_t from) {
      return (metres + way * depth) / size + static_cast<double>(from) / kUnitsPerCell;
    };
    return Placing{{cells(lying.origin.x, down.x, corner.x), cells(lying.origin.y, down.y, corner.y)},
                   lying.cosine / scale,
                   lying.sine / scale};
  }

  /// Whether a body that lies still is carried by ground, and may be settled. Box2D lets bodies sleep that stand on a
  /// tip. Where the weight is near the rim of what carries it, or beyond, a small push wakes the body, to that side: it
  /// rests once it has stood that. Cost: its contacts.
  bool rests(BodyHandle body) {
    const auto found = find(body);
    const Support support = supportOf(terrain_, body);
    const Place gravity = gravityOf(physics_);
    const double pull = std::hypot(gravity.x, gravity.y), radius = gyrationOf(body);
    if (!support.isGround || found == bodies_.end() || support.at.empty() || !(pull > 0 && radius > 0))
      return support.isGround;
    double left = HUGE_VAL, right = -HUGE_VAL;
    Place foot{};
    for (const auto& [x, y] : support.at) {
      const double aside = (y * gravity.x - x * gravity.y) / pull;
      left = std::min(left, aside);
      right = std::max(right, aside);
      foot.x += x / static_cast<double>(support.at.size());
      foot.y += y / static_cast<double>(support.at.size());
    }
    if (left < -kNarrow * radius && right > kNarrow * radius) return true;
    const Lying lying = lyingOf(body);
    const double angle = std::atan2(lying.sine, lying.cosine);
    const bool hasStoodIt = found->pushes > 0 && std::abs(angle - found->pushedAt) < kSameAngle;
    if (hasStoodIt || found->pushes == kMostPushes) return true;
    ++found->pushes;
    found->pushedAt = angle;
    const double spin = kPush * std::sqrt(pull / radius) * (left + right > 0 ? 1 : -1);  // about its foot
    setMoving(body,
              {{static_cast<float>(spin * foot.y), static_cast<float>(-spin * foot.x)}, static_cast<float>(spin)});
    return false;
  }

  /// For a body that the game destroys itself, or keeps for itself: add() takes it back.
  void forget(BodyHandle body) {
    if (const auto found = find(body); found != bodies_.end()) bodies_.erase(found);
    known_.eraseIf([&](BodyHandle one) { return one == body; });
  }

 private:
  static constexpr double kNarrow = 0.1;      // of the radius of gyration: so far from the rim the weight is safe
  static constexpr double kPush = 0.1;        // of what a pendulum of that radius has
  static constexpr int kMostPushes = 3;       // of one body
  static constexpr double kSameAngle = 0.02;  // radians

  /// The next dropGone() says so, too.
  void findGone() {
    known_.eraseIf([](BodyHandle) { return false; });
    const auto isGone = [&](const Falling& f) {
      return std::ranges::none_of(known_.all(), [&](BodyHandle one) { return one == f.body; });
    };
    if (known_.all().size() != bodies_.size() && std::erase_if(bodies_, isGone) > 0) hasDropped_ = true;
  }
  static bool isNull(BodyHandle body) { return body == BodyHandle{}; }
  Falling make(Falling falling) {
    const Body& ground = falling.ground;
    const Position at = terrain_.position(toWorld(ground.origin, {}));
    const auto parts = convexParts(ground, 8);
    if (!parts) return falling;  // it was in no world, and fits into none
    const double size = cellSize();
    falling.body = makeBody(physics_, at, fallingParts(*parts, size, slopOf(physics_)),
                            fallingMass(ground, options_.density, size),
                            [&](Block block) { return options_.material ? options_.material(block) : Material{}; });
    if (isNull(falling.body)) return falling;
    noteWhereItIs(terrain_, falling.body);
    keep(falling);
    return falling;
  }
  void keep(Falling falling) {
    findGone();
    known_.add(falling.body);
    bodies_.push_back(std::move(falling));
  }
  typename std::vector<Falling>::iterator find(BodyHandle body) {
    return std::find_if(bodies_.begin(), bodies_.end(), [&](const Falling& f) { return f.body == body; });
  }
  /// The corner of a cell is at the origin of the physics, so nothing is rounded here but the size itself.
  double cellSize() const {
    const Point corner = terrain_.latticePoint({0, 0});
    return static_cast<double>(terrain_.position({corner.x + kUnitsPerCell, corner.y}).x);
  }

  Physics physics_;
  World& world_;
  Terrain& terrain_;
  FallingOptions options_;
  std::vector<Falling> waiting_;  // for afterSync()
  std::vector<Falling> bodies_;
  detail::KnownBodies known_;    // those of bodies_
  std::vector<Falling> undone_;  // are ground again, and fall if that is done again
  bool hasDropped_ = false;      // since the last dropGone()
  std::uint64_t wentTo_ = 0;     // the version of the world at the last afterRollBack()
};

}  // namespace lgs::box2d
