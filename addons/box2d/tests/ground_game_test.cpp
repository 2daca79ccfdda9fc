// Random games on the ground of a game with Box2D: it is dug, built and undone while bodies and rocks move, its window
// goes to and fro, and it is saved and loaded. Law 13, with ground that leaves memory; and matter is neither doubled
// nor lost.
#include "addons/falling/tests/area.h"
#include "crowd.h"
#include "oracle/calls/random.h"
#include "proptests/support/law.h"

#include <gtest/gtest.h>
#include <lgs/box2d/ground.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <optional>
#include <utility>

namespace lgs::box2d_test {
namespace {

constexpr Block kEarth = 1, kRock = 9;
constexpr CellRect kEverywhere{{-kMaxCell, -kMaxCell}, {kMaxCell, kMaxCell}};

/// Hills with overhangs on bedrock.
void hillsOn(World& land, const CellRect& chunk) {
  if (chunk.min.j != 0) return;
  const ShapeId square = land.shape(kUnitSquare).value();
  for (std::int32_t i = chunk.min.i; i <= chunk.max.i; ++i)
    for (std::int32_t j = 0; j <= 9; ++j)
      if (j == 0 || (i * 7 + j * 5) % 11 > 1) static_cast<void>(land.add({i, j}, square, j == 0 ? kRock : kEarth));
}

/// Without the land that was made: what strokes have done.
struct Stuff {
  std::int64_t ground = 0, rocks = 0;
  std::size_t rockCount = 0;
};

class GroundGame {
 public:
  explicit GroundGame(std::uint64_t seed) : random_(seed) {
    while (!ground_->window(around(0))) continue;
    moments_.push_back(stuff());
  }

  void turn() {
    const int what = random_.below(100);
    if (what < 30) {
      stroke([&] { return ground_->dig(circle(somewhere(), (1 + random_.below(5)) * kUnitsPerCell / 2, 12)); });
    } else if (what < 40) {
      const Point at = random_.chance(70) ? somewhere() : aRock();
      stroke([&] { return ground_->paint(circle(at, (1 + random_.below(6)) * kUnitsPerCell / 2, 12), kEarth); });
      EXPECT_TRUE(!isWhole_ || leftInParts() == 0) << "new ground may be where a rock that nothing pushes stands";
    } else if (what < 50) {
      goTo(now_ - 1, ground_->undo());
    } else if (what < 57) {
      goTo(now_ + 1, ground_->redo());
    } else if (what < 67) {
      at_ += 16 * (random_.below(5) - 2);
      window();
    } else if (what < 71) {
      load();
    } else if (what < 73) {
      destroyRock();
    } else if (what < 80) {
      body();
    } else {
      steps(1 + random_.below(90));
    }
    EXPECT_EQ(ground_->canUndo(), now_ > 0);
    EXPECT_EQ(ground_->canRedo(), now_ + 1 < moments_.size());
    look(kAfterTurn);
  }

 private:
  using Body = Crowd::Body;
  struct Watched {
    bool wasFree = false, isOff = false, isHeld = false;
    Crowd::Position at{};
  };

  GroundOptions options() {
    return {.isAnchor = [](Block block, Cell) { return block == kRock; },
            .staying = [](Block block) { return block == kRock; },
            .land = hillsOn,
            .chunksAtOnce = random_.chance(50) ? 1 + random_.below(std::size_t{4}) : 100,
            .settleAtOnce = random_.chance(50) ? 1 + random_.below(std::size_t{6}) : 64,
            .follow = [this](const World&, const Changes&) { destroyVictim(); }};
  }
  std::unique_ptr<box2d::Ground> made() {
    return std::make_unique<box2d::Ground>(options(), crowd_.physics, box2d::TerrainOptions{.merge = true});
  }
  static CellRect around(std::int32_t i) { return {{i - 24, -8}, {i + 24, 40}}; }
  Point somewhere() { return toWorld({at_ + random_.below(30) - 15, random_.below(14)}, {0, 0}); }

  /// Where one is, to wall it in.
  Point aRock() {
    Point at = somewhere();
    ground_->forEachRock([&](Body rock, const lgs::Body&) {
      if (!box2d::GroundHost::isSame(rock, {})) at = terrain().latticePoint(box2d::middleOfMass(rock));
    });
    return at;
  }

  Stuff stuff() {
    std::vector<std::byte> bytes;
    EXPECT_TRUE(ground_->save([&](auto more) { bytes.insert(bytes.end(), more.begin(), more.end()); }));
    const auto all = loadGround(bytes, {}, kEverywhere, shelfInMemory());
    EXPECT_TRUE(all);
    Stuff stuff{test::areaOf(all->world), 0, all->rocks.size()};
    for (const Rock& rock : all->rocks)
      for (const BodyPolygon& p : rock.ground.polygons) stuff.rocks += test::areaOf(p.vertices);
    for (const Cell corner : all->land) {
      World land;
      hillsOn(land, chunkAround(corner));
      stuff.ground -= test::areaOf(land);
    }
    return stuff;
  }

  template <class Stroke>
  void stroke(const Stroke& stroke) {
    if (!isWhole_ || !stroke()) return;  // else land would be made around it, and how much is not known here
    moments_.resize(++now_);
    moments_.push_back(stuff());
  }
  void goTo(std::size_t moment, bool went) {
    if (!went) return;
    now_ = moment;
    const Stuff is = stuff(), was = moments_[moment];
    EXPECT_EQ(is.ground + is.rocks, was.ground + was.rocks) << "matter was doubled or lost";
    // Else what came in since may fall at once.
    EXPECT_TRUE(is.ground == was.ground || !ground_->canRedo()) << "another ground than right after that stroke";
    if (!ground_->canRedo()) moments_.resize(now_ + 1);  // land was made again
  }
  void load() {
    std::vector<std::byte> bytes;
    EXPECT_TRUE(ground_->save([&](auto more) { bytes.insert(bytes.end(), more.begin(), more.end()); }));
    const Stuff before = stuff();
    if (random_.chance(50)) another();
    EXPECT_TRUE(ground_->load(bytes));
    rocks_.clear();
    ground_->forEachRock([&](Body rock, const lgs::Body&) { rocks_.emplace_back(rock, true); });
    look("after a load");
    const Stuff after = stuff();
    EXPECT_EQ(after.ground + after.rocks, before.ground + before.rocks);
    moments_ = {after};
    now_ = 0;
  }
  /// In the same physics world, in which nothing is left of the one before.
  void another() {
    std::vector<Body> away = ground_->host().away();  // some may be gone, and others have their addresses
    std::erase_if(away, [&](Body body) {
      const auto found = std::ranges::find_if(crowd_.bodies, [&](Body one) { return Crowd::areSame(one, body); });
      return found == crowd_.bodies.end() || watched_[static_cast<std::size_t>(found - crowd_.bodies.begin())].isOff ||
             ground_->world().at(terrain().latticePoint(Crowd::positionOf(body))).where != Spot::Where::unloaded;
    });
    ground_.reset();
    EXPECT_EQ(crowd_.bodyCount(), crowd_.bodies.size()) << "bodies are left of a Ground that is gone";
    for (std::size_t k = 0; k < crowd_.bodies.size(); ++k) {
      const Body body = crowd_.bodies[k];
      const bool wasAway = std::ranges::any_of(away, [&](Body one) { return Crowd::areSame(one, body); });
      EXPECT_FALSE(wasAway && !Crowd::isEnabled(body)) << "nobody enables body " << k << " any more";
      watched_[k].isHeld = false;
    }
    ground_ = made();
    isWhole_ = false;
    for (bool isLater = random_.chance(50); !isLater && !isWhole_;) isWhole_ = ground_->window(around(at_));
  }
  void steps(int count) {
    const Stuff before = stuff();
    int stuck = 0;
    met_ = 0;
    for (int k = 0; k < count; ++k) {
      window();
      const std::size_t toGo = leftInParts();
      ground_->step([&] { crowd_.step(); });
      look("after a step");
      stuck = toGo > 0 && leftInParts() == toGo && isWhole_ && !ground_->canRedo() ? stuck + 1 : 0;
      EXPECT_LT(stuck, 3) << "a rock of which a part is ground waits, and nothing is in its way";
    }
    const Stuff after = stuff();
    // What settles is let down by some centimetres, and rounded.
    constexpr std::int64_t kCell = 2 * std::int64_t{kUnitsPerCell} * kUnitsPerCell;
    const std::int64_t change = after.ground + after.rocks - before.ground - before.rocks;
    EXPECT_LT(change, kCell / 100) << "matter was doubled";
    EXPECT_GT(change, -kCell * static_cast<std::int64_t>(1 + before.rockCount + met_)) << "matter was lost";
    if (after.rockCount != before.rockCount || after.ground != before.ground) moments_.resize(now_ + 1);
  }

  /// How many polygons of rocks that become ground, far from the edge of memory, are not ground yet.
  std::size_t leftInParts() {
    std::size_t count = 0;
    ground_->forEachRock([&](Body rock, const lgs::Body& ground) {
      if (box2d::GroundHost::isSame(rock, {}) || !Crowd::isStatic(rock)) return;
      if (std::abs(terrain().cellAt(box2d::middleOfMass(rock)).i - at_) < 8) count += ground.polygons.size();
    });
    return count;
  }

  void window() {
    isWhole_ = ground_->window(around(at_));
    if (!ground_->canRedo()) moments_.resize(now_ + 1);  // new land
  }
  /// The game destroys a rock and does not say so; the next body may have its address.
  void destroyRock() {
    std::vector<Body> rocks;
    ground_->forEachRock([&](Body rock, const lgs::Body&) {
      if (!box2d::GroundHost::isSame(rock, {})) rocks.push_back(rock);
    });
    if (rocks.empty()) return;
    victim_ = rocks[random_.below(rocks.size())];
    if (random_.chance(50)) {
      destroyVictim();
      body();
    }
    // So that nothing before is taken back; and there is a new rock, which may have the address.
    EXPECT_TRUE(ground_->edit([&](World& world) -> Expected<void> {
      const Cell cell{at_ + random_.below(30) - 15, 20};
      static_cast<void>(world.fill({cell, {cell.i + 1, cell.j}}, world.shape(kUnitSquare).value(), kEarth));
      return {};
    }));
    ground_->forgetUndo();
    moments_ = {stuff()};
    now_ = 0;
  }
  void destroyVictim() {
    if (const auto victim = std::exchange(victim_, std::nullopt)) box2d::destroyBody(crowd_.physics, *victim);
  }
  /// One goes, and another one comes, which may have its address; the game keeps some switched off.
  void body() {
    if (!crowd_.bodies.empty() && random_.chance(50)) {
      std::size_t which = random_.below(crowd_.bodies.size());
      const auto isWaiting = [&](Body body) {
        return std::ranges::any_of(ground_->host().away(), [&](Body one) { return Crowd::areSame(one, body); });
      };
      if (const auto found = std::ranges::find_if(crowd_.bodies, isWaiting); found != crowd_.bodies.end())
        which = static_cast<std::size_t>(found - crowd_.bodies.begin());
      crowd_.destroy(which);
      watched_.erase(watched_.begin() + static_cast<std::ptrdiff_t>(which));
    }
    const Point at =
        toWorld({at_ + random_.below(40) - 20, 2 + random_.below(16)}, {kUnitsPerCell / 2, kUnitsPerCell / 2});
    if (!isWhole_ || crowd_.bodies.size() > 6 || ground_->world().at(at).where != Spot::Where::outside) return;
    const Body body = crowd_.add(random_.chance(50) ? Figure::circle : Figure::box, 0.6F, terrain().position(at));
    Watched& watched = watched_.emplace_back();
    watched.wasFree = true;
    watched.isOff = random_.chance(30);
    if (watched.isOff) return Crowd::setEnabled(body, false);
    Crowd::kick(body, {static_cast<float>(random_.below(40) - 20), static_cast<float>(random_.below(40) - 20)});
  }

  /// What one rested on is gone, or it never rested: then it falls.
  static bool sleepsInTheAir(Body body) {
    return Crowd::isEnabled(body) && !Crowd::isStatic(body) && !Crowd::isAwake(body) && !Crowd::touchesAnything(body);
  }

  void look(const char* when) {
    for (std::size_t k = 0; k < crowd_.bodies.size(); ++k) {
      const Body body = crowd_.bodies[k];
      Watched& watched = watched_[k];
      const bool isEnabled = Crowd::isEnabled(body);
      EXPECT_FALSE(sleepsInTheAir(body)) << when << ": body " << k << " sleeps in the air";
      EXPECT_FALSE(watched.isOff && isEnabled) << when << ": a body that the game keeps switched off is on";
      const Crowd::Position at = Crowd::positionOf(body);
      const Spot::Where where = ground_->world().at(terrain().latticePoint(at)).where;
      EXPECT_FALSE(isEnabled && watched.wasFree && where != Spot::Where::outside)
          << when << ": body " << k << " is in the ground, or where none is in memory";
      EXPECT_FALSE(!isEnabled && watched.isHeld && (at.x != watched.at.x || at.y != watched.at.y))
          << when << ": body " << k << " moved while it was disabled";
      watched.wasFree = where == Spot::Where::outside || (watched.wasFree && !isEnabled);
      watched.isHeld = !isEnabled;
      watched.at = at;
    }
    lookAtRocks(when);
  }
  static constexpr const char* kAfterTurn = "after a turn";
  /// By the middles of their shapes: what is around may have more in it.
  void lookAtRocks(const char* when) {
    std::vector<std::pair<Body, bool>> now;
    ground_->forEachRock([&](Body rock, const lgs::Body&) {
      if (box2d::GroundHost::isSame(rock, {}) || Crowd::isStatic(rock)) return;  // one that becomes ground stands still
      const auto whereIs = [&](Crowd::Position at) { return ground_->world().at(terrain().latticePoint(at)).where; };
      const auto isIn = [&](Crowd::Position at) { return whereIs(at) == Spot::Where::inside; };
      const bool isInside = std::ranges::any_of(Crowd::middlesOf(rock), isIn), isEnabled = Crowd::isEnabled(rock);
      const auto found = std::ranges::find_if(rocks_, [&](const auto& one) { return Crowd::areSame(one.first, rock); });
      const bool wasFree = found != rocks_.end() && found->second;
      if (found == rocks_.end()) ++met_;
      EXPECT_FALSE(sleepsInTheAir(rock)) << when << ": a rock sleeps in the air";
      EXPECT_FALSE(isEnabled && isInside && wasFree) << when << ": a rock is in the ground";
      // New ground may have pushed it there; the next step finds that. Who is on the very edge of memory is in the cell to
      // the right of it, or above.
      const Cell cell = terrain().cellAt(box2d::middleOfMass(rock));
      EXPECT_FALSE(isEnabled && when != kAfterTurn && ground_->world().firstUnloaded({cell, cell}))
          << when << ": a rock goes on where no ground is in memory";
      EXPECT_TRUE(std::ranges::none_of(now, [&](const auto& one) { return Crowd::areSame(one.first, rock); }))
          << when << ": two rocks are one body";
      now.emplace_back(rock, !isInside || (wasFree && !isEnabled));
    });
    rocks_ = std::move(now);
  }
  box2d::Terrain& terrain() { return ground_->host().terrain(); }

  oracle::Random random_;
  Crowd crowd_;
  std::unique_ptr<box2d::Ground> ground_ = made();
  std::int32_t at_ = 0;
  std::vector<Watched> watched_;
  std::vector<std::pair<Body, bool>> rocks_;  ///< and whether each was out of the ground
  std::size_t met_ = 0;                       ///< rocks that came since the steps began
  std::optional<Body> victim_;                ///< a rock that the game destroys in the next commit
  std::vector<Stuff> moments_;  ///< right after each stroke; the first one is that of the begin, or of the last load
  std::size_t now_ = 0;
  bool isWhole_ = true;  ///< whether the window was, the last time
};

LGS_LAW(GroundOfBox2dGame, HoldsLaw13AndKeepsMatter, 40, (std::uint64_t seed)) {
  GroundGame game(seed);
  for (int k = 0; k < 40 && !::testing::Test::HasFailure(); ++k) game.turn();
}

}  // namespace
}  // namespace lgs::box2d_test
