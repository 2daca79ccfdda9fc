// A server and its clients are in step once the line is quiet, whatever the line does to messages; and what is mended
// costs little (addons/sync).
#include "ends.h"
#include "proptests/laws/calls.h"
#include "proptests/laws/twins.h"
#include "proptests/support/law.h"
#include "proptests/support/must.h"
#include "proptests/support/traces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <random>

namespace lgs::test {
namespace {

/// A line that loses messages, has some twice, and keeps some back.
class Line {
 public:
  Line(int losses, int repeats) : losses_(losses), repeats_(repeats) {}

  void send(const Bytes& message, Chance& chance) {
    for (int copies = chance.chance(repeats_) ? 2 : 1; copies > 0; --copies)
      if (!chance.chance(losses_)) waiting_.push_back(message);
  }
  /// Some of the messages, in any order; all of them if it is quiet.
  std::vector<Bytes> come(Chance& chance, bool isQuiet) {
    std::vector<Bytes> now;
    for (std::size_t count = isQuiet ? waiting_.size() : chance.below(waiting_.size() + 1); count > 0; --count) {
      const std::size_t k = chance.below(waiting_.size());
      now.push_back(std::move(waiting_[k]));
      waiting_.erase(waiting_.begin() + static_cast<std::ptrdiff_t>(k));
    }
    return now;
  }

 private:
  int losses_, repeats_;
  std::vector<Bytes> waiting_;
};

/// A client, its world, and the two ways of its line.
struct Follower {
  explicit Follower(Chance& chance)
      : down(chance.below(40), chance.below(40)), up(chance.below(40), chance.below(40)), client(followed(world)) {}

  World world;
  Line down, up;
  in_step::Client client;
};

class Game {
 public:
  Game(const Setting& setting, Chance& chance)
      : corner_(setting.corner), chance_(chance), caller_(World(), setting.corner), server_(followed(caller_.world)) {}

  void make(const Call& call) {
    const bool tells = call.kind == Call::Kind::commit || call.kind == Call::Kind::rollBack;
    const std::uint64_t before = caller_.world.version();
    if (caller_.make(call).refusal || !tells || (call.kind == Call::Kind::rollBack && !caller_.hasMarks())) return;
    if (chance_.chance(5)) return;  // a commit that the server misses
    tell(server_.update(changesFrom(before, caller_.world)));
    const int what = chance_.below(100);
    if (what < 10 && followers_.size() < 3) followers_.push_back(std::make_unique<Follower>(chance_));
    if (what >= 90) drift();
    if (what % 3 == 0) travel(false);
  }

  void becomeQuiet() {
    const std::uint64_t before = caller_.world.version();
    caller_.world.commit();
    tell(server_.update(changesFrom(before, caller_.world)));  // it sees what it missed
    if (followers_.empty()) followers_.push_back(std::make_unique<Follower>(chance_));
    const auto isEqual = [this](const auto& f) {
      return f->client.isInStep() && samePolygons(f->world, caller_.world);
    };
    for (int k = 0; k < 2'000 && !std::ranges::all_of(followers_, isEqual); ++k) {
      tell(server_.signOfLife());
      travel(true);
    }
    for (const auto& follower : followers_) {
      EXPECT_TRUE(follower->client.isInStep());
      EXPECT_TRUE(samePolygons(follower->world, caller_.world));
    }
  }

 private:
  void tell(const Bytes& message) {
    for (const auto& follower : followers_) follower->down.send(message, chance_);
  }

  void travel(bool isQuiet) {
    for (const auto& follower : followers_) {
      const auto ask = [&](const std::vector<Bytes>& questions) {
        for (const Bytes& question : questions) follower->up.send(question, chance_);
      };
      for (const Bytes& message : follower->down.come(chance_, isQuiet)) ask(follower->client.receive(message));
      if (chance_.chance(30)) ask(follower->client.tick());
      for (const Bytes& question : follower->up.come(chance_, isQuiet)) {
        follower->down.send(must(server_.answer(question)), chance_);
      }
    }
  }

  /// A client's world changes by itself, in a cell or in a whole chunk.
  void drift() {
    if (followers_.empty()) return;
    Follower& follower = *followers_[chance_.below(followers_.size())];
    const auto index = [this](std::int32_t from) {
      return static_cast<std::int32_t>(
          std::clamp(from + std::int64_t{chance_.below(80)} - 40, std::int64_t{-kMaxCell}, std::int64_t{kMaxCell}));
    };
    const std::int32_t i = index(corner_.i);
    const Cell cell{i, index(corner_.j)};
    if (chance_.chance(50))
      static_cast<void>(follower.world.add(cell, unitSquare(), 9));
    else
      static_cast<void>(follower.world.clear(GroundHashes::square(cell, chance_.below(2)).cells));
    follower.client.update(follower.world.commit());
  }

  Cell corner_;
  Chance& chance_;
  Caller caller_;
  in_step::Server server_;
  std::vector<std::unique_ptr<Follower>> followers_;
};

LGS_LAW(Sync, BothEndsAreEqualWhenTheLineIsQuiet, 300,
        (const CallsAndMarks& calls, const Setting& setting, Chance chance)) {
  Game game(setting, chance);
  for (const Call& call : calls.list) game.make(call);
  game.becomeQuiet();
}

/// Both ends of a line without faults. Counts what goes over it.
struct Talk {
  explicit Talk(World& serversWorld, World& clientsWorld)
      : server(followed(serversWorld)), client(followed(clientsWorld)) {}

  void receive(const Bytes& message) {
    bytes += message.size();
    largest = std::max(largest, message.size());
    ++messages;
    for (const Bytes& question : client.receive(message)) waiting.push_back(question);
    while (!waiting.empty()) {
      const Bytes question = std::move(waiting.back());
      waiting.pop_back();
      bytes += question.size();
      ++messages;
      receive(must(server.answer(question)));
    }
  }

  in_step::Server server;
  in_step::Client client;
  std::vector<Bytes> waiting;
  std::size_t bytes = 0, messages = 0, largest = 0;
};

/// Random ramps, in four turns.
World rampsOf(std::int32_t side) {
  constexpr std::int32_t U = kUnitsPerCell;
  World world;
  std::vector<ShapeId> shapes;
  for (const auto& ramp : {std::vector<LocalPoint>{{0, 0}, {U, 0}, {0, U}},
                           {{U, 0}, {U, U}, {0, 0}},
                           {{U, U}, {0, U}, {U, 0}},
                           {{0, U}, {0, 0}, {U, U}}})
    shapes.push_back(world.shape(ramp).value());
  std::mt19937 random(1);
  std::vector<Placement> all;
  for (std::int32_t j = 0; j < side; ++j)
    for (std::int32_t i = 0; i < side; ++i)
      all.push_back({{i, j}, shapes[random() % 4], static_cast<Block>(random() % 3)});
  EXPECT_TRUE(world.addMany(all));
  world.commit();
  return world;
}

TEST(SyncByHand, OneCellOfAMillionIsFoundAndMendedInFourKilobytes) {
  World ours = rampsOf(1'000), theirs = ours;
  Talk talk(ours, theirs);
  talk.receive(talk.server.signOfLife());
  EXPECT_TRUE(talk.client.isInStep());
  std::mt19937 random(2);
  for (int k = 0; k < 20; ++k) {
    const Cell cell{static_cast<std::int32_t>(random() % 1'000), static_cast<std::int32_t>(random() % 1'000)};
    const PolygonHandle polygon = theirs.polygons(cell).front().handle;
    ASSERT_TRUE(k % 2 == 0 ? theirs.remove(polygon) : theirs.setBlock(polygon, 7));
    talk.client.update(theirs.commit());
    talk.bytes = talk.messages = 0;
    EXPECT_FALSE(talk.client.isInStep());
    talk.receive(talk.server.signOfLife());
    EXPECT_TRUE(talk.client.isInStep());
    EXPECT_LE(talk.bytes, 4'096U);
    EXPECT_LE(talk.messages, 13U);
  }
  EXPECT_TRUE(samePolygons(ours, theirs));
  std::cout << "the last repair: " << talk.bytes << " bytes in " << talk.messages << " messages\n";
}

TEST(SyncByHand, WhoComesLateGetsAllOfIt) {
  World ours = rampsOf(300), theirs;
  Talk talk(ours, theirs);
  talk.receive(talk.server.signOfLife());
  EXPECT_TRUE(talk.client.isInStep());
  EXPECT_TRUE(samePolygons(ours, theirs));
  std::cout << "90,000 ramps: " << talk.bytes << " bytes in " << talk.messages << " messages, the largest has "
            << talk.largest << '\n';
}

TEST(SyncByHand, WhatIsUnloadedIsNotGone) {
  World ours = rampsOf(60), theirs = ours;
  const World whole = ours;
  Talk talk(ours, theirs);
  const auto tell = [&] { talk.receive(talk.server.update(ours.commit())); };
  std::vector<std::byte> left;
  ASSERT_TRUE(ours.unload({{0, 0}, {31, 31}},
                          [&](Cell, std::span<const std::byte> bytes) { left.assign(bytes.begin(), bytes.end()); }));
  tell();
  EXPECT_TRUE(talk.client.isInStep());
  EXPECT_TRUE(samePolygons(theirs, whole));
  EXPECT_FALSE(talk.server.answer(bytesOf(in_step::Question{in_step::Question::Kind::ground, {0, {0, 0}}})));
  ASSERT_TRUE(ours.clear(Cell{40, 40}));
  tell();
  EXPECT_TRUE(talk.client.isInStep());
  ASSERT_TRUE(ours.reload(left));
  tell();
  EXPECT_TRUE(talk.client.isInStep());
  EXPECT_TRUE(samePolygons(theirs, ours));
}

TEST(SyncByHand, WhoFollowsGetsEditsAndNothingElse) {
  World ours = rampsOf(40), theirs = ours;
  Talk talk(ours, theirs);
  talk.receive(talk.server.signOfLife());
  for (std::int32_t k = 0; k < 20; ++k) {
    const PolygonHandle stays = theirs.polygons({k, 1}).front().handle;
    ASSERT_TRUE(ours.clear(Cell{k, 0}));
    place(ours, {k, 60}, unitSquare());
    talk.messages = 0;
    talk.receive(talk.server.update(ours.commit()));
    EXPECT_EQ(talk.messages, 1U);
    EXPECT_TRUE(talk.client.isInStep());
    EXPECT_TRUE(theirs.polygon(stays)) << "what did not change keeps its handle";
  }
  EXPECT_TRUE(samePolygons(ours, theirs));
}

TEST(SyncByHand, WhatDidNotChangeInACellKeepsItsHandle) {
  constexpr std::int32_t U = kUnitsPerCell;
  World ours;
  const PolygonHandle goes = place(ours, {}, {{0, 0}, {U, 0}, {0, U}});
  place(ours, {}, {{U, 0}, {U, U}, {0, U}});
  ours.commit();
  World theirs = ours;
  Talk talk(ours, theirs);
  const PolygonHandle stays = theirs.polygons({}).back().handle;
  ASSERT_TRUE(ours.remove(goes));
  talk.receive(talk.server.update(ours.commit()));
  EXPECT_TRUE(theirs.polygon(stays));
  EXPECT_TRUE(samePolygons(ours, theirs));
}

TEST(SyncByHand, WhatIsOlderThanWhatWasHeardIsLeftOut) {
  World ours, theirs;
  Talk talk(ours, theirs);
  std::vector<Bytes> told;
  for (const Block block : {1U, 2U, 3U}) {
    ASSERT_TRUE(ours.clear(Cell{0, 0}));
    place(ours, {0, 0}, unitSquare(), block);
    told.push_back(talk.server.update(ours.commit()));
  }
  Block latest = 0;
  for (const Block heard : {2U, 1U, 3U, 3U, 2U, 1U}) {
    talk.receive(told[heard - 1]);
    latest = std::max(latest, heard);
    EXPECT_EQ(theirs.polygons({0, 0}).front().block, latest);
    EXPECT_TRUE(talk.client.isInStep());
  }
}

TEST(SyncByHand, WhatIsTooMuchForAMessageIsFound) {
  World ours, theirs;
  Talk talk(ours, theirs);
  fill(ours, {{0, 0}, {99, 99}});
  const Bytes told = talk.server.update(ours.commit());
  EXPECT_LT(told.size(), 30U);
  talk.receive(told);
  EXPECT_TRUE(samePolygons(ours, theirs));
  std::cout << "10,000 full blocks: " << talk.bytes << " bytes in " << talk.messages << " messages\n";
}

TEST(SyncByHand, WhatIsRefusedIsNotHalfDone) {
  World world;
  in_step::Client client(followed(world));
  place(world, {5, 5}, unitSquare());
  client.update(world.commit());
  const in_step::Polygon square{unitSquare(), 1}, ramp{{{0, 0}, {kUnitsPerCell, 0}, {0, kUnitsPerCell}}, 1};
  in_step::News news;
  news.turn = 3;
  news.ground = {{{4, 5}, {square}}, {{5, 5}, {}}, {{6, 5}, {square, ramp}}};  // the last two overlap
  EXPECT_FALSE(client.receive(bytesOf(news)).empty()) << "it asks for what it does not have";
  EXPECT_TRUE(world.isEmpty({4, 5}) && !world.isEmpty({5, 5}) && world.isEmpty({6, 5}));
  EXPECT_TRUE(isCommitted(world)) << "nothing is pending";
}

}  // namespace
}  // namespace lgs::test
