// Files of worlds that others wrote to, or read at the same time: what is damaged is found, and the rest is saved.
#include "files.h"
#include "proptests/support/command.h"
#include "proptests/support/law.h"
#include "proptests/support/must.h"
#include "proptests/support/traces.h"

#include <sqlite3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string>

namespace lgs::test {
namespace {

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

/// Rows that other programs may have written: SQLite takes any value in a column of whole numbers.
LGS_LAW(WorldFile, ARepairRemovesWhatIsNoChunkAndNothingElse, 50, (Chance chance)) {
  const auto path = freshPath();
  World world;
  for (int k = chance.below(30); k >= 0; --k) play(world, static_cast<std::uint32_t>(chance.below(1'000)));
  world.commit();
  WorldFile file = opened(path);
  save(file, world);
  const std::size_t chunks = must(file.chunks()).size();
  sqlite3* raw = nullptr;
  ASSERT_EQ(sqlite3_open(path.string().c_str(), &raw), SQLITE_OK);
  const std::array keys{"0.5", "-31.75", "'a'", "x'00'", "1e300", "4294967296", "-9223372036854775807 - 1", "5", "1"};
  const std::array others{"0", "-32", "0.25", "4294967264", "'b'"};
  std::size_t wrong = 0;
  for (int k = chance.below(4); k >= 0; --k) {
    std::string i = keys[chance.below(keys.size())], j = others[chance.below(others.size())];
    if (chance.chance(50)) std::swap(i, j);
    const std::string row = "INSERT OR IGNORE INTO chunk VALUES (" + i + ", " + j + ", 7, x'00')";
    ASSERT_EQ(sqlite3_exec(raw, row.c_str(), nullptr, nullptr, nullptr), SQLITE_OK);
    wrong += static_cast<std::size_t>(sqlite3_changes(raw));
  }
  sqlite3_close(raw);
  std::string complaint;
  const auto checked = file.check(complaint);
  ASSERT_EQ(checked.size(), chunks + wrong);
  ASSERT_EQ(static_cast<std::size_t>(std::ranges::count(checked, false, &world_file::Stored::isGood)), wrong);
  ASSERT_EQ(must(file.repair()), wrong);
  ASSERT_EQ(must(file.repair()), 0U);
  ASSERT_TRUE(samePolygons(loaded(file), world));
  std::filesystem::remove(path);
}

TEST(WorldFile, IsOpenedBesideAWriter) {
  const auto path = freshPath();
  opened(path);
  sqlite3* raw = nullptr;
  ASSERT_EQ(sqlite3_open(path.string().c_str(), &raw), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(raw, "BEGIN IMMEDIATE", nullptr, nullptr, nullptr), SQLITE_OK);
  EXPECT_TRUE(WorldFile::open(path));
  sqlite3_close(raw);
}

TEST(WorldFile, AListThatCannotBeReadIsNotEmpty) {
  const auto path = freshPath();
  World world;
  for (std::int32_t k = 0; k < 500; ++k) ASSERT_TRUE(world.add({32 * k, 0}, kUnitSquare, 1));
  world.commit();
  {
    WorldFile file = opened(path);
    save(file, world);
    EXPECT_EQ(must(file.chunks()).size(), 500U);
  }
  const auto size = std::filesystem::file_size(path);
  std::fstream bytes(path, std::ios::in | std::ios::out | std::ios::binary);
  bytes.seekp(4'096);
  bytes << std::string(size - 4'096, '\xff') << std::flush;
  const WorldFile file = opened(path);
  EXPECT_FALSE(file.chunks());
}

TEST(WorldFile, EachPathIsAFile) {
  EXPECT_FALSE(WorldFile::open(""));
  const auto before = std::filesystem::current_path(), folder = freshPath();
  std::filesystem::create_directory(folder);
  std::filesystem::current_path(folder);
  opened(":memory:");
  EXPECT_TRUE(std::filesystem::exists(folder / ":memory:"));
  std::filesystem::current_path(before);
}

TEST(WorldFileCommand, LooksAtFilesAndDestroysNone) {
  const auto path = freshPath();
  const std::string command = "'" LGS_WORLD "' '" + path.string() + "' ";
  const auto run = [&](const std::string& arguments) { return outcomeOf(command + arguments + " 2>&1"); };
  EXPECT_EQ(run("").status, 2) << "it is not there";
  std::ofstream(path).close();
  EXPECT_EQ(run("--check").status, 2) << "it is empty";
  EXPECT_EQ(std::filesystem::file_size(path), 0U);
  std::filesystem::remove(path);
  World world;
  play(world, 1);
  world.commit();
  WorldFile file = opened(path);
  save(file, world);
  EXPECT_EQ(run("").status, 0);
  EXPECT_EQ(run("> /dev/full").status, 2) << "nobody reads the list";
  EXPECT_EQ(run("--check").text, "all is well\n");
  EXPECT_EQ(run("--svg '" + path.string() + "'").status, 2) << "the picture would be in its place";
  EXPECT_TRUE(samePolygons(loaded(file), world));
  EXPECT_EQ(run("--svg '" + path.string() + ".svg'").status, 0);
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

}  // namespace
}  // namespace lgs::test
