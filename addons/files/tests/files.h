// Files of worlds for tests, and a world to play in.
#pragma once

#include "addons/files/world_file.h"

#include <unistd.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>

namespace lgs::test {

using world_file::WorldFile;

inline constexpr CellRect kAll{{-kMaxCell, -kMaxCell}, {kMaxCell, kMaxCell}};

/// A path of its own for each test; nothing is there.
inline std::filesystem::path freshPath() {
  const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
  const auto path = std::filesystem::temp_directory_path() / (name + std::to_string(getpid()) + ".lgsw");
  std::filesystem::remove(path);
  return path;
}

inline WorldFile opened(const std::filesystem::path& path) {
  auto file = WorldFile::open(path);
  EXPECT_TRUE(file) << file.error();
  return std::move(*file);
}

/// What is done in a turn: in three chunks at once, with a block that names the turn.
inline void play(World& world, std::uint32_t turn) {
  const std::int32_t i = static_cast<std::int32_t>(turn * 37 % 64) - 32,
                     j = static_cast<std::int32_t>(turn * 11 % 64) - 32;
  for (const Cell cell : {Cell{i, j}, Cell{-1 - i, j}, Cell{i, -1 - j}}) {
    EXPECT_TRUE(world.clear(cell));
    if (turn % 5 == 0) continue;
    EXPECT_TRUE(world.add(cell, {{0, 0}, {kUnitsPerCell, 0}, {0, static_cast<std::int32_t>(turn % 1'000) + 1}}, turn));
  }
}

inline void save(WorldFile& file, const World& world) {
  const auto done = file.save(world, GroundHashes(world), kAll);
  EXPECT_TRUE(done) << done.error();
}

inline World loaded(const WorldFile& file, const CellRect& cells = kAll) {
  World world;
  const auto done = file.load(world, cells);
  EXPECT_TRUE(done) << done.error();
  world.commit();
  return world;
}

}  // namespace lgs::test
