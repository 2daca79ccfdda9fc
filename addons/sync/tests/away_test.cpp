// Servers whose chunks leave memory and come back, and lines that are slow.
#include "ends.h"
#include "proptests/support/law.h"
#include "proptests/support/traces.h"
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>

#include <deque>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace lgs::test {
namespace {

/// A server with three chunks, and clients that miss some of what it tells.
class Walk {
 public:
  explicit Walk(Chance& chance) : chance_(chance) { clients_.push_back(std::make_unique<End>()); }

  void step() {
    const Cell corner{32 * chance_.below(3), 0};
    const bool isAway = away_.contains(corner);
    const int what = chance_.below(12);
    if (what == 0 && clients_.size() < 3) clients_.push_back(std::make_unique<End>());
    if (what <= 4 && !isAway) {
      const Cell cell{corner.i + chance_.below(32), chance_.below(32)};
      ASSERT_TRUE(world_.clear(cell));
      if (chance_.chance(70)) {
        ASSERT_TRUE(world_.add(cell, unitSquare(), static_cast<Block>(chance_.below(3))));
      }
    } else if (what <= 6 && isAway) {
      ASSERT_TRUE(world_.reload(away_[corner]));
      away_.erase(corner);
    } else if (what <= 8 && !isAway && isCommitted(world_)) {
      ASSERT_TRUE(world_.unload(GroundHashes::square(corner, 0).cells, [&](Cell, std::span<const std::byte> bytes) {
        away_[corner].assign(bytes.begin(), bytes.end());
      }));
    } else if (what == 9) {
      marks_.push_back(world_.mark());
    } else if (what == 10 && !marks_.empty()) {
      marks_.resize(chance_.below(marks_.size()) + 1);
      ASSERT_TRUE(world_.rollBack(marks_.back()));
      tell(world_.changesOfRollBack());
    }
    if (chance_.chance(60)) tell(world_.commit());
  }

  /// What is in memory is the same at both ends after some rounds, whatever is away.
  void becomeQuiet() {
    tell(world_.commit());
    talk();
    for (const auto& end : clients_)
      for (const std::int32_t i : {0, 32, 64})
        if (!away_.contains({i, 0})) {
          const CellRect chunk = GroundHashes::square({i, 0}, 0).cells;
          ASSERT_EQ(groundHash(end->world, chunk), groundHash(world_, chunk)) << "the chunk of cell " << i;
        }
  }

  void comeBack() {
    for (const auto& [corner, bytes] : std::exchange(away_, {})) ASSERT_TRUE(world_.reload(bytes));
    becomeQuiet();
    for (const auto& end : clients_) {
      ASSERT_TRUE(end->client.isInStep());
      ASSERT_TRUE(samePolygons(end->world, world_));
    }
  }

 private:
  void tell(const Changes& changes) {
    const Bytes told = server_.update(changes);
    for (const auto& end : clients_)
      if (chance_.chance(70)) answerAll(server_, end->client, end->client.receive(told));
  }
  void talk() {
    for (int round = 0; round < 12; ++round)
      for (const auto& end : clients_) {
        answerAll(server_, end->client, end->client.receive(server_.signOfLife()));
        answerAll(server_, end->client, end->client.tick());
      }
  }

  Chance& chance_;
  World world_;
  in_step::Server server_{followed(world_)};
  std::vector<std::unique_ptr<End>> clients_;
  std::map<Cell, std::vector<std::byte>> away_;
  std::vector<Mark> marks_;
};

LGS_LAW(Sync, WhatIsAwayKeepsNothingElseBack, 300, (Chance chance)) {
  Walk walk(chance);
  for (int k = 0; k < 60; ++k) {
    walk.step();
    if (chance.chance(10)) walk.becomeQuiet();
  }
  walk.becomeQuiet();
  walk.comeBack();
}

/// 60 frames a second: in how many a client that comes late has all, if messages take so many frames.
int framesUntilInStep(int edits, int answers, bool digs) {
  World world;
  fill(world, {{0, 0}, {99, 99}});
  world.commit();
  in_step::Server server(followed(world));
  End end;
  std::deque<std::pair<int, Bytes>> down, slowDown, up;
  int frame = 0;
  const auto ask = [&](std::vector<Bytes> questions) {
    for (Bytes& question : questions) up.emplace_back(frame + edits, std::move(question));
  };
  const auto come = [&](std::deque<std::pair<int, Bytes>>& line, const auto& take) {
    for (; !line.empty() && line.front().first <= frame; line.pop_front()) take(line.front().second);
  };
  for (; frame < 600 && !end.client.isInStep(); ++frame) {
    if (digs) {
      EXPECT_TRUE(world.clear(Cell{frame % 100, frame / 100}));
    }
    down.emplace_back(frame + edits, server.update(world.commit()));
    come(up, [&](const Bytes& question) { slowDown.emplace_back(frame + answers, must(server.answer(question))); });
    come(down, [&](const Bytes& message) { ask(end.client.receive(message)); });
    come(slowDown, [&](const Bytes& message) { ask(end.client.receive(message)); });
    if (frame % 30 == 29) ask(end.client.tick());
  }
  return frame;
}

TEST(SyncByHand, AServerThatRestsWaitsForSlowAnswers) {
  EXPECT_LE(framesUntilInStep(3, 3, true), 120) << "on the same line as the edits";
  EXPECT_LE(framesUntilInStep(3, 3, false), 60);
  EXPECT_LE(framesUntilInStep(3, 9, false), 120) << "nothing is edited, so nothing is newer";
}

TEST(SyncByHand, AWorldThatDoesNotFollowItsCellsIsReadAnew) {
  World world;
  in_step::Server server(world);
  End end;
  place(world, {1, 1}, unitSquare());
  answerAll(server, end.client, end.client.receive(server.update(world.commit())));
  EXPECT_TRUE(end.client.isInStep());
  EXPECT_TRUE(samePolygons(end.world, world));
}

// cellChanges() are those of the empty commit then.
TEST(SyncByHand, ACommitThatFindsNothingInBetweenIsNoticed) {
  World world;
  EXPECT_TRUE(world.followCells(true));
  in_step::Server server(world);
  End end;
  place(world, {1, 1}, unitSquare());
  const Changes changes = world.commit();
  world.commit();
  answerAll(server, end.client, end.client.receive(server.update(changes)));
  EXPECT_TRUE(end.client.isInStep());
  EXPECT_TRUE(samePolygons(end.world, world));
}

}  // namespace
}  // namespace lgs::test
