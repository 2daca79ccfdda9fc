// Worlds in files: what was said to be written is there, wherever the writer is killed; what is damaged is found.
#include "addons/files/world_file.h"
#include "proptests/support/must.h"

#include <sqlite3.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <random>
#include <string>

namespace lgs::test {
namespace {

using world_file::WorldFile;

constexpr CellRect kAll{{-kMaxCell, -kMaxCell}, {kMaxCell, kMaxCell}};

/// A path of its own for each test; nothing is there.
std::filesystem::path freshPath() {
  const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
  const auto path = std::filesystem::temp_directory_path() / (name + std::to_string(getpid()) + ".lgsw");
  std::filesystem::remove(path);
  return path;
}

WorldFile opened(const std::filesystem::path& path) {
  auto file = WorldFile::open(path);
  EXPECT_TRUE(file) << file.error();
  return std::move(*file);
}

/// What is done in a turn: in three chunks at once, with a block that names the turn.
void play(World& world, std::uint32_t turn) {
  const std::int32_t i = static_cast<std::int32_t>(turn * 37 % 64) - 32,
                     j = static_cast<std::int32_t>(turn * 11 % 64) - 32;
  for (const Cell cell : {Cell{i, j}, Cell{-1 - i, j}, Cell{i, -1 - j}}) {
    EXPECT_TRUE(world.clear(cell));
    if (turn % 5 == 0) continue;
    EXPECT_TRUE(world.add(cell, {{0, 0}, {kUnitsPerCell, 0}, {0, static_cast<std::int32_t>(turn % 1'000) + 1}}, turn));
  }
}

void save(WorldFile& file, const World& world) {
  const auto done = file.save(world, GroundHashes(world), kAll);
  EXPECT_TRUE(done) << done.error();
}

World loaded(const WorldFile& file, const CellRect& cells = kAll) {
  World world;
  const auto done = file.load(world, cells);
  EXPECT_TRUE(done) << done.error();
  world.commit();
  return world;
}

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
  EXPECT_EQ(file.chunks().size(), 3U) << "what was emptied is gone, and what was unloaded is not";
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
    EXPECT_TRUE(file.chunks().empty());
    save(file, world);
    EXPECT_EQ(file.chunks().size(), 4U);
  }
  WorldFile file = opened(path);
  EXPECT_TRUE(samePolygons(loaded(file), world));
  World part = world;  // a chunk alone
  ASSERT_TRUE(part.clear({{-32, -32}, {-1, 31}}));
  ASSERT_TRUE(part.clear({{0, -32}, {31, -1}}));
  EXPECT_TRUE(samePolygons(loaded(file, {{3, 3}, {4, 4}}), part));
  const auto done = file.save(World(), GroundHashes(World()), {{0, 0}, {31, 31}});  // it is empty there
  EXPECT_TRUE(done) << done.error();
  EXPECT_EQ(file.chunks().size(), 3U) << "and elsewhere nothing is said";
  ASSERT_TRUE(file.load(world, {{0, 0}, {5, 5}}));
  EXPECT_EQ(groundHash(world, {{0, 0}, {31, 31}}), 0U) << "what stood there before is gone";
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

TEST(WorldFile, WhatIsDamagedIsFoundAndTheRestIsSaved) {
  const auto path = freshPath();
  World world;
  for (std::uint32_t turn = 1; turn <= 300; ++turn) play(world, turn);
  world.commit();
  WorldFile file = opened(path);
  save(file, world);
  sqlite3* raw = nullptr;
  ASSERT_EQ(sqlite3_open(path.string().c_str(), &raw), SQLITE_OK);
  // The last byte of one chunk is another one, another has another hash, and one stands where no chunk begins.
  ASSERT_EQ(sqlite3_exec(raw,
                         "UPDATE chunk SET ground = CAST(substr(ground, 1, length(ground) - 1) || x'7f' AS BLOB) "
                         "WHERE i = 0 AND j = 0; UPDATE chunk SET hash = hash + 1 WHERE i = 0 AND j = -32; INSERT INTO "
                         "chunk VALUES (5, 5, 1, x'00')",
                         nullptr, nullptr, nullptr),
            SQLITE_OK);
  sqlite3_close(raw);
  std::string complaint;
  const auto checked = file.check(complaint);
  EXPECT_TRUE(complaint.empty()) << complaint;
  EXPECT_EQ(std::ranges::count(checked, false, &world_file::Stored::isGood), 3);
  World untouched;
  EXPECT_FALSE(file.load(untouched, kAll));
  EXPECT_FALSE(untouched.bounds());
  ASSERT_TRUE(file.load(untouched, {{-32, -32}, {-1, -1}})) << "the others can be read";
  const auto removed = must(file.repair());
  EXPECT_EQ(removed, 3U);
  ASSERT_TRUE(world.clear({{0, -32}, {31, 31}}));
  EXPECT_TRUE(samePolygons(loaded(file), world));
}

TEST(WorldFile, AnotherFormatIsRefusedWithBothVersions) {
  const auto path = freshPath();
  opened(path);
  sqlite3* raw = nullptr;
  ASSERT_EQ(sqlite3_open(path.string().c_str(), &raw), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(raw, "PRAGMA user_version = 7", nullptr, nullptr, nullptr), SQLITE_OK);
  const auto refused = refusal(WorldFile::open(path));
  EXPECT_EQ(refused, "the file is of version 7, and this program reads version 1");
  ASSERT_EQ(sqlite3_exec(raw, "PRAGMA application_id = 9", nullptr, nullptr, nullptr), SQLITE_OK);
  EXPECT_EQ(WorldFile::open(path).error(), "this is no world of LocalGridSeg");
  sqlite3_close(raw);
  std::ofstream(path, std::ios::trunc) << std::string(5'000, 'x');
  EXPECT_FALSE(WorldFile::open(path));
  EXPECT_FALSE(WorldFile::open(path / "nowhere"));
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
