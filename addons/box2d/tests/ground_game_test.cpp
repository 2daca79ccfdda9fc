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
#include <memory>

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
      stroke(
          [&] { return ground_->paint(circle(somewhere(), (1 + random_.below(3)) * kUnitsPerCell / 2, 12), kEarth); });
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
    look("after a turn");
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
            .settleAtOnce = random_.chance(50) ? 1 + random_.below(std::size_t{6}) : 64};
  }
  std::unique_ptr<box2d::Ground> made() {
    return std::make_unique<box2d::Ground>(options(), crowd_.physics, box2d::TerrainOptions{.merge = true});
  }
  static CellRect around(std::int32_t i) { return {{i - 24, -8}, {i + 24, 40}}; }
  Point somewhere() { return toWorld({at_ + random_.below(30) - 15, random_.below(14)}, {0, 0}); }

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
    if (!stroke()) return;
    moments_.resize(++now_);
    moments_.push_back(stuff());
  }
  void goTo(std::size_t moment, bool went) {
    if (!went) return;
    now_ = moment;
    const Stuff is = stuff(), was = moments_[moment];
    EXPECT_EQ(is.ground, was.ground) << "another ground than right after that stroke";
    EXPECT_EQ(is.rocks, was.rocks) << "matter was doubled or lost";
    if (!ground_->canRedo()) moments_.resize(now_ + 1);  // land was made again
  }
  void load() {
    std::vector<std::byte> bytes;
    EXPECT_TRUE(ground_->save([&](auto more) { bytes.insert(bytes.end(), more.begin(), more.end()); }));
    const Stuff before = stuff();
    EXPECT_TRUE(ground_->load(bytes));
    const Stuff after = stuff();
    EXPECT_EQ(after.ground + after.rocks, before.ground + before.rocks);
    moments_ = {after};
    now_ = 0;
  }
  void steps(int count) {
    const Stuff before = stuff();
    for (int k = 0; k < count; ++k) {
      window();
      ground_->step([&] { crowd_.step(); });
      look("after a step");
    }
    const Stuff after = stuff();
    // What settles is let down by some centimetres, and rounded.
    constexpr std::int64_t kCell = 2 * std::int64_t{kUnitsPerCell} * kUnitsPerCell;
    const std::int64_t change = after.ground + after.rocks - before.ground - before.rocks;
    EXPECT_LT(change, kCell / 100) << "matter was doubled";
    EXPECT_GT(change, -kCell * static_cast<std::int64_t>(1 + before.rockCount)) << "matter was lost";
    if (after.rockCount != before.rockCount || after.ground != before.ground) moments_.resize(now_ + 1);
  }

  void window() {
    ground_->window(around(at_));
    if (!ground_->canRedo()) moments_.resize(now_ + 1);  // new land
  }
  /// The game destroys a rock and does not say so; the next body may have its address.
  void destroyRock() {
    std::vector<Body> rocks;
    ground_->forEachRock([&](Body rock, const lgs::Body&) {
      if (!box2d::GroundHost::isSame(rock, {})) rocks.push_back(rock);
    });
    if (rocks.empty()) return;
    box2d::destroyBody(crowd_.physics, rocks[random_.below(rocks.size())]);
    body();
    EXPECT_TRUE(ground_->edit([](World&) { return Expected<void>(); }));  // so that nothing before is taken back
    ground_->forgetUndo();
    moments_ = {stuff()};
    now_ = 0;
  }
  /// One goes, and another one comes, which may have its address; the game keeps some switched off.
  void body() {
    if (!crowd_.bodies.empty() && random_.chance(50)) {
      const std::size_t which = random_.below(crowd_.bodies.size());
      crowd_.destroy(which);
      watched_.erase(watched_.begin() + static_cast<std::ptrdiff_t>(which));
    }
    const Point at =
        toWorld({at_ + random_.below(40) - 20, 2 + random_.below(16)}, {kUnitsPerCell / 2, kUnitsPerCell / 2});
    if (crowd_.bodies.size() > 6 || ground_->world().at(at).where != Spot::Where::outside) return;
    const Body body = crowd_.add(random_.chance(50) ? Figure::circle : Figure::box, 0.6F, terrain().position(at));
    Watched& watched = watched_.emplace_back();
    watched.wasFree = true;
    watched.isOff = random_.chance(30);
    if (watched.isOff) return Crowd::setEnabled(body, false);
    Crowd::kick(body, {static_cast<float>(random_.below(40) - 20), static_cast<float>(random_.below(40) - 20)});
  }

  void look(const char* when) {
    for (std::size_t k = 0; k < crowd_.bodies.size(); ++k) {
      const Body body = crowd_.bodies[k];
      Watched& watched = watched_[k];
      const bool isEnabled = Crowd::isEnabled(body);
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
  }
  box2d::Terrain& terrain() { return ground_->host().terrain(); }

  oracle::Random random_;
  Crowd crowd_;
  std::unique_ptr<box2d::Ground> ground_ = made();
  std::int32_t at_ = 0;
  std::vector<Watched> watched_;
  std::vector<Stuff> moments_;  ///< right after each stroke; the first one is that of the begin, or of the last load
  std::size_t now_ = 0;
};

LGS_LAW(GroundOfBox2dGame, HoldsLaw13AndKeepsMatter, 40, (std::uint64_t seed)) {
  GroundGame game(seed);
  for (int k = 0; k < 40 && !::testing::Test::HasFailure(); ++k) game.turn();
}

}  // namespace
}  // namespace lgs::box2d_test
