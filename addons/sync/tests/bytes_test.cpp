// Messages as bytes: what comes back from them, and what becomes of those that no server sends.
#include "ends.h"
#include "proptests/laws/calls.h"
#include "proptests/support/law.h"
#include "proptests/support/must.h"
#include "proptests/support/traces.h"

#include <gtest/gtest.h>

#include <utility>

namespace lgs::test {
namespace {

LGS_LAW(Sync, GroundComesBackFromItsBytes, 500, (Chance chance)) {
  in_step::Ground ground;
  const std::int32_t i = chance.chance(50) ? -2 : kMaxCell - 4, j = chance.chance(50) ? -2 : -kMaxCell;
  for (int k = chance.below(30); k > 0; --k) {
    const std::int32_t column = i + chance.below(5);
    in_step::Content& content = ground[{column, j + chance.below(5)}];
    content.clear();
    if (chance.chance(80)) content.push_back({unitSquare(), static_cast<Block>(chance.below(2))});
  }
  Bytes bytes;
  in_step::put(bytes, ground);
  in_step::Reader in(bytes);
  EXPECT_EQ(in_step::readGround(in), ground);
  EXPECT_TRUE(in.isGood() && in.isAtEnd());
}

/// Messages with a byte that is another one, or that are cut, are refused or understood; worlds stay worlds.
LGS_LAW(Sync, DamagedMessagesDoNoHarm, 200, (const Calls& calls, Chance chance)) {
  Caller caller;
  in_step::Server server(followed(caller.world));
  World world;
  in_step::Client client(followed(world));
  const auto damaged = [&](Bytes bytes) {
    for (int k = chance.below(3); k > 0 && !bytes.empty(); --k)
      bytes[chance.below(bytes.size())] = static_cast<std::byte>(chance.below(256));
    if (chance.chance(20)) bytes.resize(chance.below(bytes.size() + 1));
    return bytes;
  };
  for (const Call& call : calls.list) {
    const std::uint64_t before = caller.world.version();
    if (caller.make(call).refusal || call.kind != Call::Kind::commit) continue;
    std::vector<Bytes> questions = client.receive(damaged(server.update(changesFrom(before, caller.world))));
    for (int k = 0; k < 8 && !questions.empty(); ++k) {
      const auto answer = server.answer(damaged(questions.back()));
      questions.pop_back();
      if (!answer) continue;
      for (Bytes& question : client.receive(damaged(*answer))) questions.push_back(std::move(question));
    }
    EXPECT_TRUE(World::load(saved(world))) << "nothing is pending, and all is as it must be";
  }
}

LGS_LAW(Sync, WhatNobodyAskedForIsLeftOut, 300, (Chance chance)) {
  World ours, theirs;
  for (int k = chance.below(20); k >= 0; --k) fill(ours, {{k, 0}, {k, chance.below(40)}});
  ours.commit();
  in_step::Server server(followed(ours));
  in_step::Client client(followed(theirs));
  answerAll(server, client, client.receive(server.signOfLife()));
  ASSERT_TRUE(client.isInStep());
  in_step::News news;
  news.kind = chance.chance(50) ? in_step::News::Kind::parts : in_step::News::Kind::ground;
  news.turn = chance.chance(50) ? 1 : 2;
  news.square.level = chance.below(GroundHashes::kTopLevel + 1);
  news.square.corner = GroundHashes::square({0, 0}, news.square.level).cells.min;
  ASSERT_TRUE(in_step::readNews(bytesOf(news)));
  client.receive(bytesOf(news));
  ASSERT_TRUE(samePolygons(ours, theirs));
}

/// Ground of one content, for which `runs` runs of `cells` cells stand that begin at the origin, each at the same one.
bool isTaken(int polygons, int vertices, int runs, std::uint64_t cells) {
  Bytes bytes;
  in_step::put(bytes, 1);
  in_step::put(bytes, static_cast<std::uint64_t>(polygons));
  for (int p = 0; p < polygons; ++p) {
    in_step::put(bytes, 0);
    in_step::put(bytes, static_cast<std::uint64_t>(vertices));
    for (int v = 0; v < 2 * vertices; ++v) in_step::putSigned(bytes, v % 3);
  }
  in_step::put(bytes, static_cast<std::uint64_t>(runs));
  for (int k = 0; k < runs; ++k) {
    in_step::put(bytes, (cells - 1) << 2 | (k > 0 ? 1 : 0));
    if (k > 0) in_step::putSigned(bytes, -static_cast<std::int64_t>(cells));
    in_step::put(bytes, 0);
  }
  in_step::Reader in(bytes);
  static_cast<void>(in_step::readGround(in));
  return in.isGood() && in.isAtEnd();
}

TEST(SyncByHand, FewBytesAreLittleWork) {
  EXPECT_TRUE(isTaken(1, 3, 1, 2'048));
  EXPECT_TRUE(isTaken(1, 3, 2, 2'048));
  EXPECT_FALSE(isTaken(1, 3, 3, 2'048)) << "cells that come again count again";
  for (const int vertices : {0, 1, 2}) EXPECT_FALSE(isTaken(1, vertices, 1, 1)) << "no polygon has so few vertices";
}

/// A comb of `teeth` teeth.
std::vector<LocalPoint> combOf(std::int32_t teeth) {
  std::vector<LocalPoint> comb{{0, 0}, {kUnitsPerCell, 0}};
  for (std::int32_t k = 2 * teeth; k > 0; --k) comb.push_back({8 * k, k % 2 == 0 ? kUnitsPerCell : 9});
  return comb;
}

TEST(SyncByHand, WhatHasTooManyVerticesForAMessageIsToldWithoutThem) {
  World world;
  in_step::Server server(followed(world));
  fill(world, {{0, 0}, {1'049, 0}}, combOf(2'000));
  const Bytes told = server.update(world.commit());
  EXPECT_TRUE(in_step::readNews(told));
  EXPECT_LT(told.size(), 30U);
}

}  // namespace
}  // namespace lgs::test
