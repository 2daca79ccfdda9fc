// Which changes fit a set of edges, and that a load brings it up to date with any world.
#include "oracle/calls/random.h"
#include "oracle/trace/player.h"

#include "edge_copy.h"
#include "field.h"
#include "naive_edges.h"
#include "played.h"

#include <lgs/box2d/edges.h>

namespace lgs::box2d_test {
namespace {

using box2d::EdgeOptions;
using box2d::SyncError;

EdgeOptions randomOptions(Chance& random) {
  EdgeOptions options;
  options.chunkCells = 1 + random.below(4);
  options.shortest = random.chance(60) ? 0 : random.pick(std::vector<std::int32_t>{400, U / 2, U + 1});
  options.merge = random.chance(60);
  if (random.chance(50)) options.material = [](Block block) { return block % 2; };
  return options;
}

bool isEmpty(const Changes& changes) {
  return changes.removed.empty() && changes.added.empty() && changes.relinked.empty();
}

// A game that forgets to hand on changes, hands them on twice, late, or from another world. The test counts the states
// of the world, and knows which one the edges show.
class Careless {
 public:
  Careless(World& world, const EdgeOptions& options) : world_(world), set_(options) { load(); }

  void hand(const Changes& changes, Chance& random) {
    const int before = state_;
    if (isNews(changes)) state_ = ++states_;
    if (random.chance(20)) return;  // forgotten
    if (random.chance(20)) expectForeign(random);
    if (random.chance(20) && isNews(last_) && isNews(changes)) {
      EXPECT_EQ(set_.misfit(world_, last_), SyncError::notTheLast);
    }
    last_ = changes;
    const std::optional<SyncError> misfit = set_.misfit(world_, changes);
    if (shown_ != before) {
      EXPECT_EQ(misfit, shown_ == state_ ? SyncError::shownAlready : SyncError::leftOut);
      return random.chance(50) ? load() : void();
    }
    ASSERT_FALSE(misfit) << message(*misfit);
    copy_.apply(set_, set_.update(world_, changes), Copy::Ids::mayReturn);
    expectEdgesOf(world_, set_);
    shown_ = state_;
    if (!isNews(changes)) return;
    EXPECT_EQ(set_.misfit(world_, changes), SyncError::shownAlready);
  }

  /// The world goes to a mark; which is where it was in some state.
  void rollBack(Mark mark, int state, Chance& random) {
    ASSERT_TRUE(world_.rollBack(mark));
    const Changes& undone = world_.changesOfRollBack();
    if (!isNews(undone)) return hand(undone, random);
    const int now = state_;
    state_ = state;
    const std::optional<SyncError> misfit = set_.misfit(world_, undone);
    if (shown_ != now) {
      EXPECT_EQ(misfit, shown_ == state ? SyncError::shownAlready : SyncError::leftOut);
      if (shown_ == state) expectEdgesOf(world_, set_);
      return;
    }
    ASSERT_FALSE(misfit);
    copy_.apply(set_, set_.update(world_, undone), Copy::Ids::mayReturn);
    expectEdgesOf(world_, set_);
    shown_ = state_;
  }

  void load() {
    copy_.apply(set_, set_.load(world_), Copy::Ids::mayReturn);
    expectEdgesOf(world_, set_);
    shown_ = state_;
  }

  int state() const { return state_; }

 private:
  // A commit that found something has another version behind it, also if that came to nothing.
  static bool isNews(const Changes& changes) { return changes.before != changes.after; }
  // Of a copy that went its own way: the same change in a copy is a change of another world.
  void expectForeign(Chance& random) {
    World copy = world_;
    const ShapeId square = copy.shape(kUnitSquare).value();
    const CellRect all = copy.bounds().value_or(CellRect{});
    ASSERT_TRUE(copy.replace(random.chance(50) ? all.min : all.max, square, 1'000));
    ASSERT_FALSE(isEmpty(copy.commit()));
    const Changes foreign = copy.commit();
    EXPECT_TRUE(isEmpty(foreign));
    EXPECT_EQ(set_.misfit(world_, foreign), SyncError::notTheLast);
  }

  World& world_;
  EdgeSet set_;
  Copy copy_;
  Changes last_;
  int states_ = 0, state_ = 0, shown_ = 0;
};

LGS_LAW(Box2dSync, EachMisuseIsNoticedAndALoadRepairs, 300, (const Edits& trace, Chance random)) {
  oracle::Player player(trace.preserve);
  World& world = player.world();
  Careless careless(world, randomOptions(random));
  playAll(trace, player, [&] {
    careless.hand(player.commit(), random);
    if (random.chance(70)) return;
    const Mark mark = world.mark();
    const int state = careless.state();
    const ShapeId square = world.shape(kUnitSquare).value();
    for (int guesses = random.below(3); guesses > 0; --guesses) {
      const CellRect all = world.bounds().value_or(CellRect{});
      ASSERT_TRUE(world.replace(random.chance(50) ? all.min : all.max, square, 7));
      careless.hand(world.commit(), random);
    }
    careless.rollBack(mark, state, random);
    ASSERT_TRUE(world.forget(mark));
  });
  careless.load();
}

// Ids mean something else in the other world, or they mean the same where the worlds are alike.
LGS_LAW(Box2dSync, ALoadTakesOverAnyOtherWorld, 200, (const Edits& trace, Chance random)) {
  const EdgeOptions options = randomOptions(random);
  std::vector<World> worlds(1);
  oracle::Player player(trace.preserve);
  playAll(trace, player, [&] {
    player.commit();
    worlds.push_back(player.world());
  });
  EdgeSet set(options);
  Copy copy;
  for (int k = 0; k < 6; ++k) {
    const World& world = random.pick(worlds);
    const box2d::EdgeChanges& changes = set.load(world);
    copy.apply(set, changes, Copy::Ids::mayReturn);
    expectEdgesOf(world, set);
    const auto what = [&](EdgeId id) {
      const Edge& e = set.edge(id);
      return std::tuple(e.first, e.start, e.end, e.block, e.chunk);
    };
    std::set<decltype(what({}))> gone;
    for (const EdgeId id : changes.removed) gone.insert(what(id));
    for (const EdgeId id : changes.added) EXPECT_FALSE(gone.contains(what(id))) << "it should have stayed";
  }
}

World worldWith(Cell cell, std::initializer_list<LocalPoint> polygon, Block block) {
  World world;
  EXPECT_TRUE(world.add(cell, polygon, block));
  world.commit();
  return world;
}

TEST(Box2dSync, ALoadMakesAnEdgeOfAnotherBlockAnew) {
  EdgeSet set({});
  for (const Block block : {1U, 2U}) {
    const box2d::EdgeChanges& changes = set.load(worldWith({0, 0}, {{0, 0}, {U, 0}, {0, U}}, block));
    EXPECT_EQ(changes.added.size(), 3U);
    EXPECT_EQ(changes.removed.size(), block == 1 ? 0U : 3U);
  }
}

// Two short segments below y = 1 are welded; in the other world two above. The welds have the same ends, and their
// first segments the same id.
TEST(Box2dSync, ALoadMakesAnEdgeOfAnotherChunkAnew) {
  EdgeSet set({.chunkCells = 1, .shortest = 900});
  for (const World& world : {worldWith({0, 0}, {{0, U}, {500, U - 300}, {1000, U}}, 1),
                             worldWith({0, 1}, {{0, 0}, {500, 300}, {1000, 0}, {500, 1000}}, 1)}) {
    set.load(world);
    expectEdgesOf(world, set);
    const Edge& weld = set.edge(set.edgeOf({1}));
    EXPECT_EQ(std::pair(weld.start, weld.end), std::pair(Point{0, U}, Point{1000, U}));
  }
}

TEST(Box2dSync, ErrorsAreToldInWords) {
  std::set<std::string> texts;
  for (const SyncError error : {SyncError::notTheLast, SyncError::shownAlready, SyncError::leftOut})
    texts.insert(message(error));
  EXPECT_EQ(texts.size(), 3U);
  EXPECT_FALSE(texts.contains("unknown error"));
}

}  // namespace
}  // namespace lgs::box2d_test
