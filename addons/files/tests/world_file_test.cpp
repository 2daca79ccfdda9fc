// Worlds in files: what was said to be written is there, wherever the writer is killed.
#include "files.h"
#include "proptests/support/law.h"
#include "proptests/support/must.h"
#include "proptests/support/traces.h"

#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <map>
#include <random>
#include <string>

namespace lgs::test {
namespace {

TEST(WorldFile, KeepsWhatIsOnlyNotInMemory) {
  const auto path = freshPath();
  World world;
  for (std::uint32_t turn = 1; turn <= 300; ++turn) play(world, turn);
  world.commit();
  WorldFile file = opened(path);
  save(file, world);
  const World whole = world;
  std::vector<std::byte> left;
  ASSERT_TRUE(world.unload({{0, 0}, {31, 31}},
                           [&](Cell, std::span<const std::byte> bytes) { left.assign(bytes.begin(), bytes.end()); }));
  world.commit();
  save(file, world);
  EXPECT_TRUE(samePolygons(loaded(file), whole));
  ASSERT_TRUE(world.clear({{-32, -32}, {-1, -1}}));
  world.commit();
  save(file, world);
  EXPECT_EQ(must(file.chunks()).size(), 3U) << "what was emptied is gone, and what was unloaded is not";
  EXPECT_FALSE(file.load(world, kAll)) << "its ground is not in memory";
  ASSERT_TRUE(world.reload(left));
  world.commit();
  EXPECT_TRUE(samePolygons(loaded(file), world));
}

TEST(WorldFile, HoldsTheGroundChunkByChunk) {
  const auto path = freshPath();
  World world;
  for (std::uint32_t turn = 1; turn <= 300; ++turn) play(world, turn);
  world.commit();
  {
    WorldFile file = opened(path);
    EXPECT_TRUE(must(file.chunks()).empty());
    save(file, world);
    EXPECT_EQ(must(file.chunks()).size(), 4U);
  }
  WorldFile file = opened(path);
  EXPECT_TRUE(samePolygons(loaded(file), world));
  World part = world;  // a chunk alone
  ASSERT_TRUE(part.clear({{-32, -32}, {-1, 31}}));
  ASSERT_TRUE(part.clear({{0, -32}, {31, -1}}));
  EXPECT_TRUE(samePolygons(loaded(file, {{3, 3}, {4, 4}}), part));
  const auto done = file.save(World(), GroundHashes(World()), {{0, 0}, {31, 31}});  // it is empty there
  EXPECT_TRUE(done) << done.error();
  EXPECT_EQ(must(file.chunks()).size(), 3U) << "and elsewhere nothing is said";
  ASSERT_TRUE(file.load(world, {{0, 0}, {5, 5}}));
  EXPECT_EQ(groundHash(world, {{0, 0}, {31, 31}}), 0U) << "what stood there before is gone";
}

/// The hash of each chunk of a world that has ground.
std::map<Cell, std::uint64_t> hashesOf(const World& world) {
  std::map<Cell, std::uint64_t> hashes;
  for (const HashedSquare& chunk : GroundHashes(world).hashes(kAll)) hashes[chunk.cells.min] = chunk.hash;
  return hashes;
}

/// Chunks leave memory and come back, and the world is saved at any moment when no edit is pending.
LGS_LAW(WorldFile, HoldsWhatWasInMemoryAtEachSave, 40, (Chance chance)) {
  const auto path = freshPath();
  WorldFile file = opened(path);
  World world;
  ASSERT_TRUE(world.followCells(true));
  GroundHashes hashes(world);
  std::map<Cell, std::uint64_t> saved;  // by the chunk's lower-left cell
  std::map<Cell, std::vector<std::byte>> away;
  const auto commit = [&] { ASSERT_TRUE(hashes.update(world, world.commit())); };
  for (int k = 0; k < 40; ++k) {
    const Cell corner{32 * (chance.below(3) - 1), 32 * (chance.below(3) - 1)};
    const CellRect chunk = GroundHashes::square(corner, 0).cells;
    if (away.contains(corner) && chance.chance(20)) {
      if (world.forgetChunks(chunk).value_or(0) == 1) away.erase(corner);  // not before a commit
    } else if (away.contains(corner)) {
      ASSERT_TRUE(world.reload(away[corner]));
      away.erase(corner);
    } else if (chance.chance(40)) {
      ASSERT_TRUE(world.unload(
          chunk, [&](Cell cell, std::span<const std::byte> bytes) { away[cell].assign(bytes.begin(), bytes.end()); }));
    } else {
      const Cell cell{corner.i + chance.below(32), corner.j + chance.below(32)};
      ASSERT_TRUE(world.clear(chance.chance(20) ? chunk : CellRect{cell, cell}));
      if (chance.chance(80)) {
        ASSERT_TRUE(world.add(cell, kUnitSquare, static_cast<Block>(chance.below(3))));
      }
      commit();
    }
    if (chance.chance(50)) commit();
    if (chance.chance(50)) continue;
    const CellRect cells = chance.chance(50) ? kAll : chunk;
    if (file.save(world, hashes, cells)) {
      const auto isSaved = [&](Cell place) { return contains(cells, place) && !world.firstUnloaded({place, place}); };
      std::erase_if(saved, [&](const auto& one) { return isSaved(one.first); });
      for (const HashedSquare& square : hashes.hashes(kAll))
        if (isSaved(square.cells.min)) saved[square.cells.min] = square.hash;
    } else {
      ASSERT_NE(hashes.hash(), GroundHashes(world).hash()) << "nothing but other hashes is refused";
    }
    World found;
    const auto done = file.load(found, kAll);
    ASSERT_TRUE(done) << done.error();
    ASSERT_EQ(hashesOf(found), saved);
  }
  std::filesystem::remove(path);
}

TEST(WorldFile, WritesOnlyWhatDiffers) {
  const auto path = freshPath();
  WorldFile file = opened(path);
  World world;
  for (std::uint32_t turn = 1; turn <= 300; ++turn) play(world, turn);
  world.commit();
  save(file, world);
  const auto written = std::filesystem::last_write_time(path);
  save(file, world);
  EXPECT_EQ(std::filesystem::last_write_time(path), written);
}

/// Goes on from what the file holds, and says each turn once it is written. Never ends.
[[noreturn]] void write(const std::filesystem::path& path, std::uint32_t turn, int told) {
  WorldFile file = opened(path);
  World world = loaded(file);
  for (;;) {
    play(world, ++turn);
    world.commit();
    save(file, world);
    if (testing::Test::HasFailure() || ::write(told, &turn, sizeof turn) != sizeof turn) std::_Exit(1);
  }
}

TEST(WorldFile, WhatWasSaidToBeWrittenOutlivesItsWriter) {
  const auto path = freshPath();
  const char* const scale = std::getenv("LGS_TEST_SCALE");
  const int kills = std::max(10, static_cast<int>(1'000 * (scale ? std::atof(scale) : 1)));
  World model;  // as of `turn`
  std::uint32_t turn = 0, unsaid = 0;
  std::mt19937 random(1);
  for (int k = 0; k < kills; ++k) {
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    const pid_t writer = fork();
    ASSERT_GE(writer, 0);
    if (writer == 0) write(path, turn, ends[1]);
    close(ends[1]);
    std::uint32_t said = turn, next = 0;
    if (k % 4 != 0 && read(ends[0], &next, sizeof next) == sizeof next) said = next;  // it is well under way then
    usleep(static_cast<useconds_t>(random() % (k % 4 == 0 ? 20'000 : 4'000)));
    kill(writer, SIGKILL);
    int status = 0;
    waitpid(writer, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status)) << "it ended by itself";
    while (read(ends[0], &next, sizeof next) == sizeof next) said = next;
    close(ends[0]);
    while (turn < said) play(model, ++turn);
    model.commit();
    const WorldFile file = opened(path);
    std::string complaint;
    EXPECT_TRUE(std::ranges::all_of(file.check(complaint), &world_file::Stored::isGood));
    EXPECT_TRUE(complaint.empty()) << complaint;
    const World found = loaded(file);
    if (!samePolygons(found, model)) {  // the turn after that may be written, and was not said
      play(model, ++turn);
      model.commit();
      ++unsaid;
    }
    ASSERT_TRUE(samePolygons(found, model)) << "after kill " << k << ", turn " << turn;
  }
  EXPECT_GT(turn, 0U);
  std::cout << kills << " writers killed in " << turn << " turns, " << unsaid << " of them before they said so\n";
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace lgs::test
