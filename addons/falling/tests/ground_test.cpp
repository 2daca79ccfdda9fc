// The ground of a game, without physics: whatever is dug, undone, streamed, saved and loaded, in any order, matter is
// neither doubled nor lost.
#include "addons/falling/tests/area.h"
#include "addons/falling/tests/hills.h"
#include "proptests/support/law.h"

#include <lgs/hashes.h>

#include <gtest/gtest.h>

#include <array>
#include <map>

namespace lgs::test {
namespace {

/// All that there is, on the shelf too.
struct Matter {
  std::int64_t ground = 0, rocks = 0, land = 0;  ///< twice the areas; `land` is what was made
  std::uint64_t hash = 0;                        ///< of the ground
  std::size_t rockCount = 0;
};
Matter matterOf(Ground<>& ground) {
  const auto all = loadGround(saved(ground), {}, kEverywhere, shelfInMemory());
  EXPECT_TRUE(all);
  Matter matter{areaOf(all->world), 0, 0, groundHash(all->world, kEverywhere), all->rocks.size()};
  for (const Rock& rock : all->rocks)
    for (const BodyPolygon& p : rock.ground.polygons) matter.rocks += areaOf(p.vertices);
  for (const Cell corner : all->land) {
    World land;
    hills(land, chunkAround(corner));
    matter.land += areaOf(land);
  }
  return matter;
}

/// What a square looks like, whatever the order of its parts.
std::vector<std::array<double, 5>> partsOf(const GroundDrawing& drawing) {
  std::vector<std::array<double, 5>> parts;
  for (const GroundDrawing::Line& l : drawing.lines)
    parts.push_back({static_cast<double>(l.block), l.start.x, l.start.y, l.end.x, l.end.y});
  for (const GroundDrawing::Fill& f : drawing.fills)
    for (const DoublePoint c : f.corners) parts.push_back({-1, static_cast<double>(f.block), c.x, c.y, 0});
  std::ranges::sort(parts);
  return parts;
}

/// A player who digs, builds, goes back and forth in time and in space. Each stroke has brought or taken so much.
class Play {
 public:
  explicit Play(std::uint64_t seed) : state_(seed) {
    if (below(2) == 0) build();
    expectAll();
  }
  void turn() {
    isWhole_ = ground_->window(cellsAt(at_));  // goes on
    EXPECT_TRUE(isWhole_ || chunksAtOnce_ < 100);
    EXPECT_TRUE(!isWhole_ || !ground_->world().firstUnloaded(cellsAt(at_)));
    mayHang_ = mayHang_ && !isWhole_;
    const int what = below(100);
    if (what < 36 && isWhole_) {
      stroke([&] { return ground_->dig(circle(somewhere(), (1 + below(4)) * kUnitsPerCell, 8)); });
    } else if (what < 40 || (what < 45 && !isWhole_)) {
      build();
    } else if (what < 45) {
      stroke([&] { return ground_->paint(circle(somewhere(), (1 + below(2)) * kUnitsPerCell, 8), kWood); });
    } else if (what < 62) {
      if (ground_->undo()) --now_, since_ = 0;
    } else if (what < 72) {
      if (ground_->redo()) ++now_, since_ = 0;
    } else if (what < 85) {
      at_ += 16 * (below(5) - 2);
    } else if (what < 95) {
      settleOne();
    } else {
      load();
    }
    EXPECT_LE(now_, static_cast<std::int64_t>(brought_.size()));
    expectAll();
  }

 private:
  int below(int n) {
    state_ = state_ * 6'364'136'223'846'793'005U + 1'442'695'040'888'963'407U;
    return static_cast<int>((state_ >> 33) % static_cast<std::uint64_t>(n));
  }
  static CellRect cellsAt(std::int32_t i) { return {{i - 24, -8}, {i + 24, 40}}; }
  Point somewhere() { return toWorld({at_ + below(30) - 15, below(24)}, {0, 0}); }

  template <class Stroke>
  void stroke(const Stroke& stroke) {
    const Matter before = matterOf(*ground_);
    if (!stroke()) return;
    const Matter after = matterOf(*ground_);
    brought_.resize(static_cast<std::size_t>(now_));
    brought_.push_back(since_ + after.ground + after.rocks - before.ground - before.rocks);
    since_ = 0;
    ++now_;
  }
  /// Far away or near, above all land, also where none was made yet.
  void build() {
    const Cell at{at_ + 40 * (below(11) - 5), 28 + below(4)};
    const Block block = below(3) == 0 ? kWood : kBedrock;
    stroke([&] {
      return ground_->edit([&](World& world) {
        return world.fill({at, {at.i + 1, at.j}}, *world.shape(kUnitSquare), block);
      });
    });
  }
  /// A rock that did not move yet fits where it was.
  void settleOne() {
    std::vector<NoPhysics::Handle> rocks;
    ground_->forEachRock([&](NoPhysics::Handle handle, const Body&) { rocks.push_back(handle); });
    if (rocks.empty()) return;
    const NoPhysics::Handle handle = rocks[static_cast<std::size_t>(below(static_cast<int>(rocks.size())))];
    Rock& rock = ground_->host().rock(handle);
    if (ground_->world().firstUnloaded(rock.ground.cells)) return;
    const Placing lay = rock.placing;
    const bool isOnLand =
        isWhole_ && contains(cellsAt(at_), rock.ground.cells.min) && rock.ground.cells.max.i <= at_ + 24;
    if (isOnLand && below(2) == 0) rock.placing.origin.y -= 0.5 * (1 + below(8));
    const Matter before = matterOf(*ground_);
    // A hundredth of a cell along its sides.
    constexpr std::int64_t kCell = 2 * std::int64_t{kUnitsPerCell} * kUnitsPerCell;
    const std::int64_t most = 4 * static_cast<std::int64_t>(rock.ground.polygons.size()) * kCell / 100;
    const auto done = ground_->settle(handle);
    if (!done) {
      EXPECT_TRUE(done.error().code == ErrorCode::overlap || done.error().code == ErrorCode::unloaded);
      ground_->host().rock(handle).placing = lay;
      return;
    }
    const Matter after = matterOf(*ground_);
    const std::int64_t change = after.ground + after.rocks - before.ground - before.rocks;
    EXPECT_LE(std::max(change, -change), most) << "matter was doubled or lost as a rock settled";
    since_ += change;
    brought_.resize(static_cast<std::size_t>(now_));  // there is nothing to redo any more
  }
  /// Into a new one, which has a window, or not yet, and then there is no land beside what is in memory.
  void load() {
    const bool isAtRest = !ground_->canRedo() && !mayHang_ && ground_->window(cellsAt(at_));
    const Matter before = matterOf(*ground_);
    const std::vector<std::byte> bytes = saved(*ground_);
    auto other = std::make_unique<Ground<>>(options(chunksAtOnce_, atEdge_));
    if (below(2) == 0) other->window(cellsAt(at_));
    EXPECT_TRUE(other->load(bytes));
    EXPECT_FALSE(other->canUndo());
    ground_ = std::move(other);
    picture_.clear();
    for (; now_ > 0; --now_) kept_ += brought_[static_cast<std::size_t>(now_ - 1)];
    kept_ += std::exchange(since_, 0);
    brought_.clear();
    mayHang_ = true;
    if (!isAtRest) return;
    for (int k = 0; k < 1000 && !ground_->window(cellsAt(at_)); ++k) continue;
    const Matter after = matterOf(*ground_);
    EXPECT_EQ(after.hash, before.hash) << "another ground than was saved";
    EXPECT_EQ(after.rockCount, before.rockCount) << "a load let something fall";
  }
  void expectAll() {
    const Matter matter = matterOf(*ground_);
    std::int64_t expected = matter.land + kept_ + since_;
    for (std::int64_t k = 0; k < now_; ++k) expected += brought_[static_cast<std::size_t>(k)];
    EXPECT_EQ(matter.ground + matter.rocks, expected) << "matter was doubled or lost";
    for (const IslandId id : ground_->islands().all())
      EXPECT_TRUE(ground_->canRedo() || mayHang_ || ground_->islands().island(id)->anchors > 0)
          << "something hangs in the air";
    expectPicture();
  }
  /// What a game that draws what draw() says has on the screen is what there is.
  void expectPicture() {
    for (GroundDrawing& d : ground_->draw()) picture_[d.cells.min] = std::move(d);
    for (std::int32_t j = -8; j <= 40; j += 8) {
      for (std::int32_t i = (at_ - 64) & -8; i <= at_ + 64; i += 8) {
        const GroundDrawing is = drawingOf(ground_->world(), {{i, j}, {i + 7, j + 7}});
        EXPECT_EQ(partsOf(picture_[{i, j}]), partsOf(is)) << "square (" << i << ", " << j << ") looks different";
      }
    }
  }

  std::uint64_t state_;
  std::size_t chunksAtOnce_ = static_cast<std::size_t>(std::array{1, 2, 5, 100}[static_cast<std::size_t>(below(4))]);
  AtEdge atEdge_ = below(3) == 0 ? AtEdge::open : AtEdge::holds;
  std::unique_ptr<Ground<>> ground_ = std::make_unique<Ground<>>(options(chunksAtOnce_, atEdge_));
  std::int32_t at_ = 0;
  std::int64_t kept_ = 0;              // brought by what can not be undone any more
  std::vector<std::int64_t> brought_;  // by each stroke
  std::int64_t now_ = 0;
  std::int64_t since_ = 0;  // by what settled since the last stroke, as it was rounded
  bool isWhole_ = false;    // whether the window was at the last turn
  bool mayHang_ = false;    // after a load, until the window is whole
  std::map<Cell, GroundDrawing> picture_;
};

LGS_LAW(Ground, NeitherDoublesNorLosesMatter, 20, (std::uint64_t seed)) {
  Play play(seed);
  for (int k = 0; k < 25 && !::testing::Test::HasFailure(); ++k) play.turn();
}

}  // namespace
}  // namespace lgs::test
