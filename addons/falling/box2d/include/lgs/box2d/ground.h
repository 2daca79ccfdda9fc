// The ground of a game with Box2D 2.4 or 3: <lgs/ground.h> is the manual. Link LocalGridSeg::falling and
// LocalGridSeg::box2d.
//
//   lgs::box2d::Ground ground({.isAnchor = isBedrock}, physics, lgs::box2d::TerrainOptions{.cellSize = 0.5},
//                             lgs::box2d::FallingOptions{.density = density});
//   ground.host().terrain()   // for questions such as what was hit; it is synced already
#pragma once

#include <lgs/box2d/falling.h>
#include <lgs/ground.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace lgs::box2d {

/// What a Ground needs of Box2D: a terrain, and bodies of what falls.
class GroundHost {
 public:
  using Handle = BodyHandle;  ///< the body of a rock

  /// All of them must outlive it and stay where they are.
  GroundHost(World& world, Physics physics, TerrainOptions terrain = {}, FallingOptions falling = {})
      : physics_(physics),
        world_(world),
        terrain_(physics, world, std::move(terrain)),
        falling_(physics, world, terrain_, std::move(falling)),
        away_(physics) {}

  /// Bodies outside of the window are enabled.
  ~GroundHost() {
    if (!isThere()) return;
    away_.eraseIf([](BodyHandle body) {
      if (!isEnabled(body)) enable(body, true);
      return true;
    });
  }

  GroundHost(const GroundHost&) = delete;
  GroundHost& operator=(const GroundHost&) = delete;

  Terrain& terrain() { return terrain_; }  ///< for questions, and for moved()

  /// Bodies outside of the window: disabled until it is there again.
  const std::vector<BodyHandle>& away() const { return away_.all(); }

  // What a Ground needs: see NoPhysics.

  /// Whether there is a physics world; one of Box2D 3 may be gone before this.
  bool isThere() const { return isPhysicsThere(physics_); }
  /// Whether both are one body.
  static bool isSame(BodyHandle a, BodyHandle b) { return a == b; }
  /// Syncs the terrain. Who came back with the ground is put out of it, if it is another one than when it was disabled.
  void show(const Changes& changes) {
    const std::vector<BodyHandle> coming = std::exchange(coming_, {});
    const bool isSynced = terrain_.sync(changes, coming).has_value();
    if (!isSynced && terrain_.isCurrent() && coming.empty()) return;
    if (!isSynced) terrain_.resync();
    for (const Overlap& pushed : terrain_.overlaps())
      if (isEnabled(pushed.body) && isAway(pushed.body)) setAway(pushed.body);
  }
  /// After a load: the terrain shows what there is now.
  void showAll() {
    window(window_);
    coming_.clear();
    terrain_.resync();
  }
  /// A body where a rock is, moving as it does; null, if all of it is too thin.
  BodyHandle make(const Rock& rock) {
    const BodyHandle body = falling_.add(rock.ground).body;
    if (body == BodyHandle{}) return body;
    const double size = cellSize();
    const Point corner = terrain_.latticePoint({0, 0});
    const auto metres = [&](double cells, std::int64_t from) {
      return (cells - static_cast<double>(from) / kUnitsPerCell) * size;
    };
    setMotion(body, {metres(rock.placing.origin.x, corner.x), metres(rock.placing.origin.y, corner.y)},
              rock.placing.cosine, rock.placing.sine,
              {{static_cast<float>(rock.velocity.x * size), static_cast<float>(rock.velocity.y * size)},
               static_cast<float>(rock.spin)});
    noteWhereItIs(terrain_, body);
    if (isAway(body)) setAway(body);
    return body;
  }
  /// The rock that a body is, where it is now.
  Rock read(BodyHandle body) {
    const auto& bodies = falling_.bodies();
    const auto found = std::ranges::find_if(bodies, [&](const Falling& f) { return f.body == body; });
    const double size = cellSize();
    const auto [origin, cosine, sine] = lyingOf(body);
    const auto [velocity, spin] = movingOf(body);
    return {found->ground,
            {cellsAt(origin), cosine, sine},
            {static_cast<double>(velocity.x) / size, static_cast<double>(velocity.y) / size},
            static_cast<double>(spin)};
  }
  /// Whether it is slow enough to sleep: as much as touches it may be awake.
  bool lies(BodyHandle body) {
    if (!isEnabled(body)) return false;
    const auto [velocity, spin] = movingOf(body);
    return std::hypot(velocity.x, velocity.y) < kSlow && std::abs(spin) < kSlowSpin;
  }
  /// Whether the ground would carry it: a rock that rests on another body alone would fall again, and one on a tip falls
  /// over.
  bool isHeld(BodyHandle body) { return falling_.rests(body); }
  /// As that of FallingGround.
  Expected<Placing> placingOf(BodyHandle body) { return falling_.placingOf(body); }
  /// It stands still from now on: it is static, so no ground that is new in it pushes it out.
  void hold(BodyHandle body) { makeStatic(body); }
  /// As FallingGround::settle().
  Expected<void> settle(BodyHandle body) { return falling_.settle(body); }
  /// The body goes.
  void destroy(BodyHandle body) {
    falling_.forget(body);
    destroyBody(physics_, body);
  }
  /// Forgets rocks whose bodies the game destroyed; whether there were any.
  bool dropGone() { return falling_.dropGone(); }
  /// Whether a body is that of a rock.
  bool has(BodyHandle body) const {
    return std::ranges::any_of(falling_.bodies(), [&](const Falling& f) { return f.body == body; });
  }
  /// Bodies come back before the sync.
  void window(const CellRect& cells) {
    window_ = cells;
    away_.eraseIf([&](BodyHandle body) {
      if (isEnabled(body)) return true;  // by the game
      if (isAway(body)) return false;
      enable(body, true);
      noteWhereItIs(terrain_, body);
      coming_.push_back(body);
      return true;
    });
    disableAway(false);
  }
  /// As that of the terrain.
  void beforeStep() { terrain_.beforeStep(); }
  /// As that of the terrain; then bodies that left the window are disabled.
  void afterStep() {
    terrain_.afterStep();
    disableAway(true);
  }

 private:
  double cellSize() const {
    const Point corner = terrain_.latticePoint({0, 0});
    return static_cast<double>(terrain_.position({corner.x + kUnitsPerCell, corner.y}).x);
  }
  DoublePoint cellsAt(const Position& at) const {
    const Point corner = terrain_.latticePoint({0, 0});
    return {static_cast<double>(at.x) / cellSize() + static_cast<double>(corner.x) / kUnitsPerCell,
            static_cast<double>(at.y) / cellSize() + static_cast<double>(corner.y) / kUnitsPerCell};
  }
  bool isAway(BodyHandle body) const {
    const Cell cell = terrain_.cellAt(middleOfMass(body));
    return !contains(window_, cell) || world_.firstUnloaded({cell, cell});
  }
  void setAway(BodyHandle body) {
    // The game may have destroyed some since.
    away_.eraseIf([](BodyHandle) { return false; });
    enable(body, false);
    away_.add(body);
  }
  void disableAway(bool moved) {
    std::vector<BodyHandle> away;
    forEachBody(physics_, terrain_, moved, [&](BodyHandle body) {
      if (isAway(body)) away.push_back(body);
    });
    for (const BodyHandle body : away) setAway(body);
  }

  static constexpr float kSlow = 0.05F, kSlowSpin = 0.05F;  // metres and radians a second

  Physics physics_;
  const World& world_;
  Terrain terrain_;
  FallingGround falling_;
  CellRect window_{{-kMaxCell, -kMaxCell}, {kMaxCell, kMaxCell}};
  detail::KnownBodies away_;
  std::vector<BodyHandle> coming_;  // enabled since the last sync
};

/// The comment at the top of <lgs/ground.h> is its manual.
using Ground = lgs::Ground<GroundHost>;

}  // namespace lgs::box2d
