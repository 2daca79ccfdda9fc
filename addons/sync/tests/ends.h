// The two ends of a line, for tests.
#pragma once

#include "addons/sync/client.h"
#include "addons/sync/server.h"
#include "proptests/support/must.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace lgs::test {

using in_step::Bytes;

inline World& followed(World& world) {
  EXPECT_TRUE(world.followCells(true));
  return world;
}

/// Of a commit that led from one version to another. The lists are not looked at.
inline Changes changesFrom(std::uint64_t before, const World& world) {
  Changes changes;
  changes.before = before;
  changes.after = world.version();
  return changes;
}

/// A client and its world.
struct End {
  World world;
  in_step::Client client{followed(world)};
};

/// Over a line without faults, until no question is left that the server answers.
inline void answerAll(const in_step::Server& server, in_step::Client& client, std::vector<Bytes> questions) {
  while (!questions.empty()) {
    const auto answer = server.answer(questions.back());
    questions.pop_back();
    if (!answer) continue;
    for (Bytes& question : client.receive(*answer)) questions.push_back(std::move(question));
  }
}

}  // namespace lgs::test
